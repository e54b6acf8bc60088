//! What the seed says of its own speed and stretch, and what is measured here.

use crate::CostError;
use crate::axes::{Config, Form, RealName};
use crate::cost::Cost;
use crate::run::{Watch, play};
use crate::scene::open_book;
use dogleaf_core::scene::Fidelity;
use serde::Serialize;

/// One row: a claim, the same measured on our rebuilding of the seed, and ours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Claim {
    /// What is claimed.
    pub what: &'static str,
    /// The seed's figure, percent.
    pub seed: &'static str,
    /// The seed's method, rebuilt.
    pub rebuilt: String,
    /// Ours.
    pub ours: String,
    /// What to know about the comparison.
    pub note: &'static str,
}

/// Microseconds a step and stretch of a corner turn.
fn turn(config: &Config) -> Result<(f64, [f64; 3]), CostError> {
    let (rate, _) = config.world();
    let mut least = f64::INFINITY;
    let mut stretch = [0.0; 3];
    for _ in 0..2 {
        let watch = Watch { rate, seconds: 1.1, mesh: false, until_settled: true };
        let run = play(open_book("release", config)?.as_mut(), watch);
        let cost = Cost::of(&run);
        // The least quartile of two runs: a busy machine only adds.
        least = least.min(cost.step_us[1]);
        stretch = run.stretch;
    }
    Ok((least, stretch))
}

fn saving(more: f64, less: f64) -> String {
    format!("{:.0} %", 100.0 * (less / more - 1.0))
}

/// All rows.
///
/// # Errors
///
/// As [`open_book`].
pub fn claims() -> Result<Vec<Claim>, CostError> {
    let seed = Config {
        form: Form::Seed { hessian: false },
        real: RealName::F64,
        refinements: 1,
        ..Config::STANDARD
    };
    let with = |newton: u32, hessian: bool| Config {
        newton: Some(newton),
        form: Form::Seed { hessian },
        ..seed
    };
    let (one, stretch) = turn(&with(1, false))?;
    let (two, _) = turn(&with(2, false))?;
    let (one_curved, _) = turn(&with(1, true))?;
    let (two_curved, _) = turn(&with(2, true))?;
    let ours = Config::STANDARD;
    let (our_one, our_stretch) = turn(&ours)?;
    let (our_two, _) = turn(&Config { newton: Some(2), ..ours })?;
    let (_, our_fine) = turn(&Config::of(Fidelity::Fine))?;
    let percent =
        |[_, mean, rms]: [f64; 3]| format!("{:.1} % / {:.2} %", 100.0 * mean, 100.0 * rms);
    let worst =
        |[worst, _, rms]: [f64; 3]| format!("{:.1} % / {:.2} %", 100.0 * worst, 100.0 * rms);
    Ok(vec![
        Claim {
            what: "One Newton step instead of two, time a step",
            seed: "-45 %",
            rebuilt: saving(two, one),
            ours: saving(our_two, our_one),
            note: "whole step with blocks and contact; the second step is a second factorisation",
        },
        Claim {
            what: "Constraint Hessian left out, time a step",
            seed: "-7 %",
            rebuilt: format!("{} (N1), {} (N2)", saving(one_curved, one), saving(two_curved, two)),
            ours: "not formed".into(),
            note: "with N1 its multipliers are zero: only the slots it keeps open cost",
        },
        Claim {
            what: "Edge stretch of a turn: mean of the largest / root mean square",
            seed: "11 % / 1.8 %",
            rebuilt: percent(stretch),
            ours: format!("{}; fine {}", percent(our_stretch), percent(our_fine)),
            note: "one second, corner to the other fore-edge; the seed's gesture is not known",
        },
        Claim {
            what: "Edge stretch at its worst: largest / root mean square",
            seed: "30 % / 3 %",
            rebuilt: worst(stretch),
            ours: format!("{}; fine {}", worst(our_stretch), worst(our_fine)),
            note: "the seed shows one extreme pose; here the worst picture of the same turn",
        },
    ])
}
