//! `web`: the package for browsers and the reader's page are assembled, their types checked, and both run in Chromium.

mod build;
mod pack;

use std::path::{Path, PathBuf};

use crate::shell::{command, run, run_counting, target_dir};
use crate::tools;
use crate::words::{Result, Stop, flag};

pub(crate) use build::JSBIND;

/// The shell, and what it is tested with.
pub(crate) const SHELL: &str = "shells/web";
pub(crate) const MANIFEST: &str = "shells/web/Cargo.toml";

/// Where everything is put together.
#[derive(Debug)]
struct Places {
    /// All of it.
    out: PathBuf,
    /// The npm package.
    package: PathBuf,
    /// The reader's page, whole.
    reader: PathBuf,
    /// What npm fetched.
    modules: PathBuf,
}

impl Places {
    fn new() -> Self {
        let out = target_dir().join("web");
        let [package, reader, tools] = ["dogleaf", "reader", "tools"].map(|name| out.join(name));
        Self { out, package, reader, modules: tools.join("node_modules") }
    }
}

/// `cargo ci web [--serve]`.
pub(crate) fn web(args: &[String]) -> Result {
    let serve = flag(args, "--serve")?;
    tools::program("node", "nodejs").map_err(Stop::Skipped)?;
    tools::program("npm", "npm").map_err(Stop::Skipped)?;
    let places = Places::new();
    fetch(&places).map_err(Stop::Skipped)?;
    build::build(&places)?;
    pack::package(&places)?;
    pack::reader(&places)?;
    if serve {
        run(&mut script("serve.mjs", &[&places.reader]))?;
        return Ok(crate::tally::Tally::default());
    }
    tools::program("chromium", "chromium").map_err(Stop::Skipped)?;
    let [native, program] = [build::native(&places)?, build::program()?];
    let (own, mut tally) = run_counting(&mut build::tests());
    let (tested, more) = run_counting(&mut script("all.mjs", &[&places.out, &native, &program]));
    tally += more;
    own.and(tested).map_err(|why| Stop::Failed(why, tally))?;
    Ok(tally)
}

/// A script of the shell's tests, in node.
fn script(name: &str, args: &[&Path]) -> std::process::Command {
    let mut c = command("node", [Path::new(SHELL).join("tests").join(name)]);
    c.args(args);
    c
}

/// Fetches what `package.json` names, to the digit, beside the build and not into the source.
fn fetch(places: &Places) -> std::result::Result<(), String> {
    let tools = places.out.join("tools");
    pack::copy(Path::new("shells/web/package.json"), &tools.join("package.json"))?;
    let mut c = command("npm", ["install", "--no-audit", "--no-fund", "--no-package-lock"]);
    // A canvas for node is of no use in a browser.
    c.args(["--omit=optional", "--loglevel=error", "--prefix"]).arg(&tools);
    run(&mut c)
}
