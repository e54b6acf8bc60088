//! What a grid's fineness buys: the limit of small steps against the limit of no spacing, and droop at rest against
//! the heavy elastica.

use super::Study;
use crate::CostError;
use crate::axes::{Config, GridName, RealName};
use crate::cost::Cost;
use crate::errors::distance;
use crate::judge::elastica::droop;
use crate::reference::{BETTER, limit};
use crate::report::{GridRow, Known};
use crate::run::{Trajectory, Watch, play};
use crate::scene::{GAMMAS, Kind, Stage, open, rest};

/// Steps a second of the two runs whose limit is a grid's motion without an error in time.
const RATES: [u32; 2] = [240, 480];

pub(super) fn grids(study: &mut Study<'_>) -> Result<(Vec<GridRow>, Option<Known>), CostError> {
    let mut rows = Vec::new();
    let mut limits = Vec::new();
    let grids = study.ask.levels.grid.clone();
    for grid in grids {
        study.say(&format!("limit of small steps and droop at {grid}"));
        let stage = Stage::new(Kind::Turn, grid);
        let standard = Config { grid, ..Config::STANDARD };
        let run = play_at(&stage, &standard)?;
        let mut cost = Cost::of(&run);
        if let Some(counts) = study.counts(&standard) {
            cost.counted(&run, counts);
        }
        let judged = GAMMAS.map(|gamma| [gamma, droop_error(gamma, grid)]);
        rows.push(GridRow {
            grid: grid.to_string(),
            space_rms: None,
            droop: judged.to_vec(),
            frame: cost.axis(),
            step_us: cost.step_us[2],
        });
        if !study.ask.quick {
            limits.push((grid, small_steps(&stage, grid)?));
        }
    }
    let known = in_space(study, &mut rows, &limits);
    Ok((rows, known))
}

fn droop_error(gamma: f64, grid: GridName) -> f64 {
    let config = Config { grid, newton: Some(2), real: RealName::F64, ..Config::STANDARD };
    let ([drop, reach], [h, w]) = (rest(gamma, &config), droop(gamma));
    (drop / reach) / (h / w) - 1.0
}

fn play_at(stage: &Stage, config: &Config) -> Result<Trajectory, CostError> {
    let watch =
        Watch { rate: config.rate, seconds: stage.seconds, mesh: false, until_settled: false };
    Ok(play(open(stage, config)?.as_mut(), watch))
}

/// A grid's motion without its error in time.
fn small_steps(stage: &Stage, grid: GridName) -> Result<Trajectory, CostError> {
    let exact = Config { grid, newton: Some(3), real: RealName::F64, ..Config::STANDARD };
    let [mut coarse, fine] = [
        play_at(stage, &Config { rate: RATES[0], ..exact })?,
        play_at(stage, &Config { rate: RATES[1], ..exact })?,
    ];
    let pairs =
        coarse.pictures.iter_mut().zip(&fine.pictures).flat_map(|(p, q)| p.iter_mut().zip(q));
    for (p, q) in pairs {
        p.iter_mut().zip(q).for_each(|(c, f)| *c = 2.0 * f - *c);
    }
    Ok(coarse)
}

/// Errors of the grids beside the limit, where it is known ten times better.
fn in_space(
    study: &mut Study<'_>,
    rows: &mut [GridRow],
    limits: &[(GridName, Trajectory)],
) -> Option<Known> {
    let limit = limit(limits)?;
    let mut smallest = f64::INFINITY;
    let mut hidden = Vec::new();
    for (row, (grid, run)) in rows.iter_mut().zip(limits) {
        let rms = distance(run, &limit.truth).0;
        if rms >= BETTER * limit.agreement {
            row.space_rms = Some(rms);
            smallest = smallest.min(rms);
        } else {
            hidden.push(format!("{grid} ({rms:.1e})"));
        }
    }
    if !hidden.is_empty() {
        study.omissions.push(format!(
            "space: reference not converged ({:.1e}) for {}; not drawn",
            limit.agreement,
            hidden.join(", ")
        ));
    }
    let converged = hidden.is_empty();
    Some(Known {
        what: "space".into(),
        methods: limit.methods,
        agreement: limit.agreement,
        smallest,
        converged,
    })
}
