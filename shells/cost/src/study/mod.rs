//! The study: which scenes, which configurations, in which order; and what is done when a reference is not good enough.

mod books;
mod grids;
mod leaves;
pub mod orders;

use crate::CostError;
use crate::axes::{Config, GridName, Levels};
use crate::cost::{Counts, Probe, available, count};
use crate::pareto::{front, master};
use crate::peers::Peers;
use crate::report::{PresetRow, Report, SceneReport};
use dogleaf_core::scene::Fidelity;
use std::collections::BTreeMap;
use std::process::Command;

/// What is asked for.
#[derive(Debug, Clone)]
pub struct Ask {
    /// Levels of the axes.
    pub levels: Levels,
    /// Scenes; all where empty.
    pub scenes: Vec<String>,
    /// Only what fits into a minute.
    pub quick: bool,
    /// Peers to draw.
    pub peers: Option<Peers>,
    /// The program that counts: [`Probe::run`] with the words behind these arguments.
    pub probe: Option<(std::path::PathBuf, Vec<String>)>,
}

/// Names of the scenes.
pub const SCENES: [&str; 4] = ["turn", "fall", "release", "peek"];

/// A study while it runs.
pub(crate) struct Study<'a> {
    pub(crate) ask: &'a Ask,
    say: &'a mut dyn FnMut(&str),
    counts: BTreeMap<Probe, Option<Counts>>,
    counting: bool,
    pub(crate) omissions: Vec<String>,
}

impl Study<'_> {
    pub(crate) fn say(&mut self, text: &str) {
        (self.say)(text);
    }

    /// Instructions of a configuration's step, counted once for all that are alike.
    pub(crate) fn counts(&mut self, config: &Config) -> Option<Counts> {
        let probe = Probe::of(config);
        let worth = !self.ask.quick || probe.grid == GridName::G11x8;
        if !self.counting || !worth {
            return None;
        }
        let (program, args) = self.ask.probe.as_ref()?;
        let call = |c: &mut Command, words: &str| {
            c.arg(program).args(args).arg(words);
        };
        *self.counts.entry(probe).or_insert_with(|| count(&probe, &call))
    }
}

/// Runs the study; `say` hears what is being done.
///
/// # Errors
///
/// A scene nobody knows, and what the core refuses.
pub fn study(ask: &Ask, say: &mut dyn FnMut(&str)) -> Result<Report, CostError> {
    if let Some(unknown) = ask.scenes.iter().find(|s| !SCENES.contains(&s.as_str())) {
        return Err(CostError::Scene(unknown.clone()));
    }
    let counting = ask.probe.is_some() && available();
    let mut study = Study { ask, say, counts: BTreeMap::new(), counting, omissions: Vec::new() };
    let wanted = |name: &str| ask.scenes.is_empty() || ask.scenes.iter().any(|s| s == name);
    let mut scenes = Vec::new();
    for name in SCENES.into_iter().filter(|n| wanted(n)) {
        scenes.push(match name {
            "turn" | "fall" => leaves::scene(&mut study, name)?,
            _ => books::scene(&mut study, name)?,
        });
    }
    let (grids, space) =
        if wanted("turn") { grids::grids(&mut study)? } else { (Vec::new(), None) };
    study.say("orders of convergence");
    let orders = orders::orders();
    study.say("the seed's claims");
    let mut claims = crate::claims::claims()?;
    study.say("the seed's claims: ribbons");
    claims.extend(crate::ribbon::claims::claims()?);
    let presets = scenes.iter().find(|s| s.name == "turn").map(presets).unwrap_or_default();
    study.standing_omissions();
    if !counting {
        study
            .omissions
            .push("instructions: valgrind is not installed; costs are told in time".into());
    }
    Ok(Report {
        dogleaf: env!("CARGO_PKG_VERSION"),
        machine: machine(),
        unit: if counting {
            "instructions a picture (1/60 s)"
        } else {
            "microseconds a picture (1/60 s)"
        },
        quick: ask.quick,
        scenes,
        grids,
        space,
        orders,
        presets,
        claims,
        peers: ask.peers.clone(),
        omissions: study.omissions,
    })
}

/// Marks the front among the safe configurations of each grid.
pub(crate) fn mark_front(scene: &mut SceneReport) {
    for grid in GridName::ALL {
        let here: Vec<usize> = (0..scene.rows.len())
            .filter(|&n| {
                let r = &scene.rows[n];
                r.config.grid == grid && !r.config.unsafe_dial() && r.errors.shape_rms.is_some()
            })
            .collect();
        let points: Vec<[f64; 2]> = here.iter().map(|&n| point(scene, n)).collect();
        for (&n, on) in here.iter().zip(front(&points)) {
            scene.rows[n].front = on;
        }
    }
}

fn point(scene: &SceneReport, n: usize) -> [f64; 2] {
    let row = &scene.rows[n];
    [row.cost.axis(), row.errors.shape_rms.unwrap_or(f64::INFINITY)]
}

/// Where the fidelities stand on the turn.
fn presets(scene: &SceneReport) -> Vec<PresetRow> {
    let safe: Vec<usize> = (0..scene.rows.len())
        .filter(|&n| {
            !scene.rows[n].config.unsafe_dial() && scene.rows[n].config.grid == GridName::G11x8
        })
        .collect();
    let points: Vec<[f64; 2]> = safe.iter().map(|&n| point(scene, n)).collect();
    let named = |name: &'static str, fidelity: Fidelity| {
        let config = Config { passes: Config::STANDARD.passes, ..Config::of(fidelity) };
        let at = safe.iter().position(|&n| scene.rows[n].config == config)?;
        let beaten = master(&points, points[at]).map(|n| scene.rows[safe[n]].config.to_string());
        Some(PresetRow {
            name,
            config: Config::of(fidelity).to_string(),
            error: points[at][1],
            cost: points[at][0],
            front: beaten.is_none(),
            beaten_by: beaten,
        })
    };
    Fidelity::ALL.into_iter().filter_map(|(name, f)| named(name, f)).collect()
}

impl Study<'_> {
    fn standing_omissions(&mut self) {
        let standing = [
            "effects: of those that can be switched off, the mesh and ribbons exist in this version; ribbons stand among the seed's claims",
            "ribbons: the chains of Table 1 touch one another and are not in this report; Figs 9 and 10 compare with finite elements that are not built here",
            "time of a step as a peer would measure it on a phone, and a Cortex-M7's instructions: not in this report",
            "stick and slip: the model has no friction between leaf and block",
            "the front is drawn among safe configurations: at least a step a picture (60/s), line search on, δ = 1e-6, at least one collision pass; on these mild motions switching them off looks free, in the hard cases it is not",
            "draft differs from standard in collision passes only; a lone leaf collides with nothing, so the two share one mark on the turn",
            "event \"has come to lie\": told at the rate of the book's world steps, so to 17 ms (33 ms at 30/s)",
        ];
        self.omissions.extend(standing.map(String::from));
        if self.ask.quick {
            self.omissions.push("quick: finer grids and the limit in space were left out".into());
        }
    }
}

fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = info.lines().find_map(|l| l.strip_prefix("model name")).unwrap_or_default();
    let name = name.trim_start_matches([' ', '\t', ':']);
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = load.split_whitespace().next().unwrap_or("unknown").to_owned();
    let name = if name.is_empty() { std::env::consts::ARCH } else { name };
    format!("{name}, load {load}")
}
