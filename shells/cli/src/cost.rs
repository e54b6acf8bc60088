//! `dogleaf cost`: what accuracy costs in time. Everything is measured by `dogleaf-cost`; here are its arguments.

use crate::error::CliError;
use crate::files::{say, say_json};
use clap::Args;
use dogleaf_cost::axes::Levels;
use dogleaf_cost::cost::Probe;
use dogleaf_cost::peers::Peers;
use dogleaf_cost::report::Report;
use dogleaf_cost::study::{Ask, study};
use std::path::{Path, PathBuf};

/// Shows what accuracy costs in time: every dial turned, errors beside references that agree.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  dogleaf cost --quick
  dogleaf cost --out report/
  dogleaf cost --scene turn --axes newton,step --newton 1,2,tol --step 60,120,240
  dogleaf cost --scene release --axes passes --passes 0,1,2,3 --json

Writes cost.json and cost.html. With valgrind installed costs are instructions, else time.")]
pub(crate) struct CostArgs {
    /// Scenes, separated by commas: turn, fall, release, peek. All if not given.
    #[arg(long, value_name = "S", value_delimiter = ',')]
    scene: Vec<String>,
    /// Folder for cost.json and cost.html.
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Turn only these axes: grid, newton, step, real, form, search, passes, delta, mesh.
    #[arg(long, value_name = "AXES", value_delimiter = ',')]
    axes: Vec<String>,
    /// Nodes, such as 6x5,11x8.
    #[arg(long)]
    grid: Option<String>,
    /// Newton steps, such as 1,2,tol.
    #[arg(long)]
    newton: Option<String>,
    /// Steps a second: 30, or a multiple of 60.
    #[arg(long)]
    step: Option<String>,
    /// Scalars: f32, f32+1 (one refinement), f64, f64+1.
    #[arg(long)]
    real: Option<String>,
    /// Equations: ours, seed, seed+hessian (the constraints' second derivatives).
    #[arg(long)]
    form: Option<String>,
    /// Line search: on, off.
    #[arg(long)]
    search: Option<String>,
    /// Collision passes: 0 to 3.
    #[arg(long)]
    passes: Option<String>,
    /// Dual regularisation, such as 1e-6.
    #[arg(long)]
    delta: Option<String>,
    /// Mesh made for every picture: on, off.
    #[arg(long)]
    mesh: Option<String>,
    /// Peers to draw: the file that `cargo ci peers` writes.
    #[arg(long, value_name = "FILE")]
    peers: Option<PathBuf>,
    /// Only what fits into a minute.
    #[arg(long)]
    quick: bool,
    /// Print cost.json's object instead of the text.
    #[arg(long)]
    json: bool,
    /// Take the steps that are counted.
    #[arg(long, hide = true)]
    probe: Option<String>,
}

impl CostArgs {
    fn levels(&self) -> Result<Levels, CliError> {
        let mut levels = if self.quick { Levels::quick() } else { Levels::full() };
        Levels::check_names(&self.axes)?;
        let given = [
            ("grid", &self.grid),
            ("newton", &self.newton),
            ("step", &self.step),
            ("real", &self.real),
            ("form", &self.form),
            ("search", &self.search),
            ("passes", &self.passes),
            ("delta", &self.delta),
            ("mesh", &self.mesh),
        ];
        if !self.axes.is_empty() {
            levels.only(&self.axes);
        }
        for (axis, text) in given {
            if let Some(text) = text {
                levels.set(axis, text)?;
            }
        }
        Ok(levels)
    }
}

/// Measures, writes both files, prints.
pub(crate) fn cost(args: &CostArgs) -> Result<(), CliError> {
    if let Some(words) = &args.probe {
        return Ok(Probe::run(words)?);
    }
    let program = std::env::current_exe().ok();
    let ask = Ask {
        levels: args.levels()?,
        scenes: args.scene.clone(),
        quick: args.quick,
        peers: args.peers.as_deref().map(Peers::read).transpose()?,
        probe: program.map(|p| (p, ["cost", "--probe"].map(String::from).to_vec())),
    };
    let report = study(&ask, &mut |what| eprintln!("{what}"))?;
    write(&report, &args.out)?;
    if args.json { say_json(&report) } else { say(&report.text()) }
}

fn write(report: &Report, folder: &Path) -> Result<(), CliError> {
    std::fs::create_dir_all(folder).map_err(|e| CliError::write(folder, &e))?;
    let json = serde_json::to_string_pretty(report).unwrap_or_default();
    for (name, text) in [("cost.json", json + "\n"), ("cost.html", report.html())] {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|e| CliError::write(&path, &e))?;
        eprintln!("{}", path.display());
    }
    Ok(())
}
