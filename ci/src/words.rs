//! The list of words, what a word answers, and the usage text made from the list.

use std::fmt::Write as _;

use crate::tally::Tally;
use crate::{
    all, android, bindings, desktop, eink, fuzz, hashes, no_std, peers, seed_slots, size, slots,
    style, swift, tests, tree, web,
};

/// Why a word did not pass.
#[derive(Debug)]
pub(crate) enum Stop {
    /// Something is wrong, and what (empty if it was said already); tests that ran before count all the same.
    Failed(String, Tally),
    /// This machine lacks something that could not be installed. A failure when `CI=true`.
    Skipped(String),
    /// The arguments make no sense.
    Usage(String),
}

impl From<String> for Stop {
    fn from(why: String) -> Self {
        Self::Failed(why, Tally::default())
    }
}

/// The tests that a word ran, or why it stopped.
pub(crate) type Result = std::result::Result<Tally, Stop>;

/// One word of `cargo ci`.
#[derive(Debug)]
pub(crate) struct Word {
    pub(crate) name: &'static str,
    args: &'static str,
    about: &'static str,
    pub(crate) run: fn(&[String]) -> Result,
}

const WORDS: &[Word] = &[
    Word { name: "fmt", args: "[--check]", about: "format every crate", run: style::fmt },
    Word {
        name: "lint",
        args: "",
        about: "clippy, all targets, warnings denied; the core alone with each feature",
        run: style::lint,
    },
    Word { name: "doc", args: "", about: "documentation, warnings denied", run: style::doc },
    Word {
        name: "test",
        args: "[--debug|--release] [ARG..]",
        about: "cargo test on the workspace, both profiles unless one is named",
        run: tests::test,
    },
    Word {
        name: "no-std",
        args: "[--via WAY]",
        about: "the core for thumbv7em: no feature, each, all (WAY: installed, nightly, debian)",
        run: no_std::no_std,
    },
    Word {
        name: "tree",
        args: "",
        about: "what must never enter the core: crates, features, words",
        run: tree::tree,
    },
    Word {
        name: "slots",
        args: "[--check]",
        about: "write (or compare) the generated factorisation patterns",
        run: pattern,
    },
    Word {
        name: "golden",
        args: "[--bless]",
        about: "compare (or rewrite) the golden tables",
        run: tests::golden,
    },
    Word {
        name: "hashes",
        args: "[--bless]",
        about: "the same bits on every target, at O0 and O3",
        run: hashes::hashes,
    },
    Word {
        name: "size",
        args: "",
        about: "the firmware's image: bytes, stack, instructions; no panic, no allocator",
        run: size::size,
    },
    Word {
        name: "eink",
        args: "[--bless]",
        about: "the reading firmware on every board: pictures, memory, instructions, rest (or print its pages)",
        run: eink::eink,
    },
    Word {
        name: "wasm",
        args: "",
        about: "microseconds a step in node, with vectors and without",
        run: hashes::wasm,
    },
    Word {
        name: "bindings",
        args: "[--check]",
        about: "write (or compare) what uniffi makes of ffi/ for Kotlin and Swift",
        run: bindings::bindings,
    },
    Word {
        name: "android",
        args: "",
        about: "the Kotlin shell on a JVM, drawing on Mesa",
        run: android::android,
    },
    Word {
        name: "android-size",
        args: "",
        about: "what a phone would load: bytes, alignment, exports, a table",
        run: android::size,
    },
    Word {
        name: "swift",
        args: "[--bless]",
        about: "the Swift shell: its sources, its shaders (or write them), its library",
        run: swift::swift,
    },
    Word {
        name: "soak",
        args: "[--steps N] [--seed S] [--real f32|f64]",
        about: "random books under random hands; failing cases are kept as recordings",
        run: fuzz::soak,
    },
    Word {
        name: "fuzz",
        args: "[--seconds N] [TARGET..]",
        about: "fuzz targets: a few seconds of each, always the same; or as long as one likes",
        run: fuzz::fuzz,
    },
    Word {
        name: "cost",
        args: "",
        about: "orders of convergence, the golden table of costs, a quick report",
        run: tests::cost,
    },
    Word {
        name: "desktop",
        args: "",
        about: "the desktop shell: its pictures against the reference, a window, the check for Android",
        run: desktop::desktop,
    },
    Word {
        name: "web",
        args: "[--serve]",
        about: "the web shell: package, types, sizes, the page in Chromium; or serve the page",
        run: web::web,
    },
    Word {
        name: "peers",
        args: "[ARG..]",
        about: "time the step beside Eigen, MuJoCo and pyPBD; writes peers.json for `dogleaf cost`",
        run: peers::peers,
    },
    Word {
        name: "all",
        args: "",
        about: "everything that ci/test runs, then `N passed, N failed`",
        run: all::all,
    },
];

/// The word of that name.
pub(crate) fn find(name: &str) -> Option<&'static Word> {
    WORDS.iter().find(|w| w.name == name)
}

/// What `cargo ci` says about itself.
pub(crate) fn usage() -> String {
    let mut text = String::from("usage: cargo ci <word> [options]\n\n");
    for w in WORDS {
        let call = format!("{} {}", w.name, w.args);
        let _ = writeln!(text, "  {call:<34} {}", w.about);
    }
    text.push_str("\nExit status: 0 passed, 1 failed (or skipped where CI=true), 2 bad usage.\n");
    text.push_str(
        "Arguments after `test` go to cargo: `cargo ci test --debug -p dogleaf-core -- kkt`.",
    );
    text
}

/// Whether the only option a word knows is given.
pub(crate) fn flag(args: &[String], name: &str) -> std::result::Result<bool, Stop> {
    match args {
        [] => Ok(false),
        [one] if one == name => Ok(true),
        [other, ..] => Err(Stop::Usage(format!("expected {name} or nothing, found `{other}`"))),
    }
}

/// Refuses every argument.
pub(crate) fn no_args(args: &[String]) -> std::result::Result<(), Stop> {
    args.first().map_or(Ok(()), |a| Err(Stop::Usage(format!("unexpected `{a}`"))))
}

fn pattern(args: &[String]) -> Result {
    let check = flag(args, "--check")?;
    eprintln!("> slots{}", if check { " --check" } else { "" });
    slots::run(check)?;
    seed_slots::run(check)?;
    Ok(Tally::default())
}

#[cfg(test)]
mod check {
    use super::{WORDS, find, flag, usage};

    #[test]
    fn every_word_is_found_and_explained() {
        let text = usage();
        for w in WORDS {
            assert!(find(w.name).is_some(), "{} is not found", w.name);
            assert!(text.contains(w.about), "{} is not explained", w.name);
        }
        assert!(find("lnit").is_none(), "a slip of the pen is no word");
    }

    #[test]
    fn flags_are_refused_by_name() {
        let args = |s: &str| vec![s.to_owned()];
        assert!(flag(&args("--check"), "--check").is_ok_and(|on| on), "the flag itself");
        assert!(flag(&[], "--check").is_ok_and(|on| !on), "nothing");
        assert!(flag(&args("--chekc"), "--check").is_err(), "a slip of the pen");
    }
}
