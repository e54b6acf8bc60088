//! Lone leaves: turn (all with all) and fall (one dial at a time), beside references in time on each grid.

use super::{Study, mark_front};
use crate::CostError;
use crate::axes::{Config, Form, GridName, RealName};
use crate::cost::Cost;
use crate::errors::{Errors, Eye, distance};
use crate::reference::{Reference, reference};
use crate::report::{Known, Row, SceneReport};
use crate::run::{Trajectory, Watch, play};
use crate::scene::{Kind, Stage, open};

/// Seconds a single configuration may take, by an estimate; what would take longer is left out and counted.
const BUDGET_S: [f64; 2] = [2.5, 1.0];

pub(super) fn scene(study: &mut Study<'_>, name: &'static str) -> Result<SceneReport, CostError> {
    let kind = if name == "turn" { Kind::Turn } else { Kind::Fall };
    let configs = match kind {
        Kind::Turn => study.ask.levels.factorial(),
        Kind::Fall => study.ask.levels.one_at_a_time(),
    };
    let mut scene = SceneReport { name, about: about(kind), known: Vec::new(), rows: Vec::new() };
    let mut left_out = 0;
    for grid in GridName::ALL {
        let fits = |c: &&Config| {
            let seed = c.form != Form::Ours && (kind == Kind::Fall || c.grid > GridName::G11x8);
            c.grid == grid && !c.mesh && !seed && c.passes == Config::STANDARD.passes
        };
        let all: Vec<Config> = configs.iter().filter(fits).copied().collect();
        let budget = BUDGET_S[usize::from(study.ask.quick)];
        let told = reference_rate(grid, kind, study.ask.quick).is_some();
        let here: Vec<Config> =
            all.iter().filter(|c| worth(c, told) && estimate(c, kind) <= budget).copied().collect();
        left_out += all.len() - here.len();
        if !here.is_empty() {
            study.say(&format!("{name} {grid}: {} configurations", here.len()));
            on_grid(study, &mut scene, kind, grid, &here)?;
        }
    }
    if left_out > 0 {
        study.omissions.push(format!(
            "{name}: {left_out} configurations on fine grids: each would take longer than {} s, or its error in time could not be told",
            BUDGET_S[usize::from(study.ask.quick)]
        ));
    }
    mark_front(&mut scene);
    Ok(scene)
}

fn about(kind: Kind) -> &'static str {
    match kind {
        Kind::Turn => {
            "a leaf of office paper, 130 by 200 mm, hinged at the spine, slightly curved; a hand leads its corner past the vertical in a second, and has not let go"
        }
        Kind::Fall => {
            "a leaf of 150 by 200 mm clamped level at the spine and let go: the first half second"
        }
    }
}

/// Where no error in time can be told, only what one step costs is of interest.
fn worth(config: &Config, told: bool) -> bool {
    told || (config.rate == Config::STANDARD.rate && config.newton.is_some_and(|n| n <= 2))
}

/// Seconds a run takes, roughly.
fn estimate(config: &Config, kind: Kind) -> f64 {
    let newton = f64::from(config.newton.unwrap_or(6));
    let wide = if config.real == RealName::F64 { 2.0 } else { 1.0 };
    let seed = if config.form == Form::Ours { 1.0 } else { 4.0 };
    let solve = 70e-6 * (config.grid.unknowns() as f64 / 240.0).powf(1.9);
    let seconds = Stage::flat(kind).seconds;
    seconds * f64::from(config.rate) * newton * wide * seed * solve
}

/// R1's rate: the finer the grid, the less can be afforded; the agreement that is found says whether it was enough.
fn reference_rate(grid: GridName, kind: Kind, quick: bool) -> Option<u32> {
    let rate = match grid {
        GridName::G6x5 | GridName::G8x6 => 3840,
        GridName::G11x8 | GridName::G12x9 => 1920,
        GridName::G16x12 => 960,
        // Nothing that is drawn on these grids would be left.
        GridName::G22x16 | GridName::G32x24 => return None,
    };
    Some(if kind == Kind::Fall {
        4 * rate
    } else if quick {
        rate.min(1920)
    } else {
        rate
    })
}

fn on_grid(
    study: &mut Study<'_>,
    scene: &mut SceneReport,
    kind: Kind,
    grid: GridName,
    configs: &[Config],
) -> Result<(), CostError> {
    let stage = Stage::new(kind, grid);
    let eye = Eye::new(stage.size_m[0], stage.size_m[1], &stage.units());
    let truth = match reference_rate(grid, kind, study.ask.quick) {
        Some(rate) => Some(reference(&stage, grid, Config::STANDARD.delta, rate)?),
        None => None,
    };
    let strict = smallest_delta(&stage, configs)?;
    let first = scene.rows.len();
    for config in configs {
        let run = play_one(&stage, config)?;
        let row = row(study, config, &run, truth.as_ref(), strict.as_ref(), &eye);
        if run.finite() {
            scene.rows.push(row);
        } else {
            study.omissions.push(format!("{} {config}: its numbers ran away", scene.name));
        }
    }
    match truth {
        Some(truth) => known(study, scene, first, grid, &truth),
        None => study.omissions.push(format!(
            "{} {grid}: no second method in affordable time, so no error in time is drawn",
            scene.name
        )),
    }
    Ok(())
}

/// Says how well the truth is known, and takes back what is too small for it.
fn known(
    study: &mut Study<'_>,
    scene: &mut SceneReport,
    first: usize,
    grid: GridName,
    truth: &Reference,
) {
    let rows = &mut scene.rows[first..];
    // Another δ was measured against its own kind: the truth says nothing about it.
    let own = |r: &Row| r.config.delta.to_bits() == Config::STANDARD.delta.to_bits();
    let smallest = rows
        .iter()
        .filter(|r| own(r))
        .filter_map(|r| r.errors.shape_rms)
        .fold(f64::INFINITY, f64::min);
    let converged = truth.floor() <= smallest;
    if !converged {
        let small = |r: &&mut Row| own(r) && r.errors.shape_rms.is_some_and(|e| e < truth.floor());
        let mut taken = 0;
        for row in rows.iter_mut().filter(small) {
            row.errors.shape_rms = None;
            row.errors.shape_max = None;
            row.errors.outline_px = None;
            taken += 1;
        }
        study.omissions.push(format!("{} {grid}: reference not converged for {taken} configurations below {:.1e}; their errors are not drawn", scene.name, truth.floor()));
    }
    let methods = truth.methods.clone();
    scene.known.push(Known {
        what: grid.to_string(),
        methods,
        agreement: truth.agreement,
        smallest,
        converged,
    });
}

fn play_one(stage: &Stage, config: &Config) -> Result<Trajectory, CostError> {
    let watch =
        Watch { rate: config.rate, seconds: stage.seconds, mesh: false, until_settled: false };
    Ok(play(open(stage, config)?.as_mut(), watch))
}

/// The run with the smallest δ of those asked for: what the others of that axis are measured against, since each δ
/// has a truth of its own.
fn smallest_delta(
    stage: &Stage,
    configs: &[Config],
) -> Result<Option<(Config, Trajectory)>, CostError> {
    let other = configs.iter().filter(|c| c.delta.to_bits() != Config::STANDARD.delta.to_bits());
    let least = other.min_by(|a, b| a.delta.total_cmp(&b.delta));
    let Some(config) = least else { return Ok(None) };
    Ok(Some((*config, play_one(stage, config)?)))
}

fn row(
    study: &mut Study<'_>,
    config: &Config,
    run: &Trajectory,
    truth: Option<&Reference>,
    strict: Option<&(Config, Trajectory)>,
    eye: &Eye,
) -> Row {
    let mut cost = Cost::of(run);
    if let Some(counts) = study.counts(config) {
        cost.counted(run, counts);
    }
    let other_delta = config.delta.to_bits() != Config::STANDARD.delta.to_bits();
    let errors = match (truth, strict) {
        (Some(_), Some((least, run_least))) if other_delta => {
            let (rms, max) = distance(run, run_least);
            let own = least == config;
            let some = |v: f64| (!own).then_some(v);
            Errors { shape_rms: some(rms), shape_max: some(max), ..Errors::alone(run) }
        }
        (Some(truth), _) => Errors::beside(run, &truth.truth, Some(eye)),
        (None, _) => Errors::alone(run),
    };
    Row {
        config: *config,
        presets: config.preset(false),
        errors,
        cost,
        front: false,
        status: run.work.status.name(),
    }
}
