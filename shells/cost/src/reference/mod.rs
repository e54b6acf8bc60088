//! What is held for true: two methods that must agree ten times better than the smallest error that is drawn.
//!
//! In time, on one grid: R1 is the product's implicit step in `f64`, Newton to tolerance, at two small steps, and from
//! these Richardson's limit; R2 is the explicit leapfrog. In space: the limits in time of three grids, taken to
//! the limit of no spacing; once from the three finest, once from the three next to them.

mod explicit;
mod space;

pub use space::{Limit, limit, order};

use crate::CostError;
use crate::axes::{Config, GridName, RealName, with_grid};
use crate::errors::distance;
use crate::run::{Trajectory, Watch, play};
use crate::scene::{Stage, open};
use explicit::Explicit;

/// How much better than an error the two references must agree for it to be drawn.
pub const BETTER: f64 = 10.0;

/// A trajectory held for true, and how well it is known.
#[derive(Debug, Clone)]
pub struct Reference {
    /// What errors are measured against: R2.
    pub truth: Trajectory,
    /// Root mean square distance of R1 from R2, page widths.
    pub agreement: f64,
    /// How the two were made.
    pub methods: [String; 2],
}

impl Reference {
    /// The smallest error that may be drawn.
    pub fn floor(&self) -> f64 {
        BETTER * self.agreement
    }
}

/// Both references of a stage on a grid; `rate` is the smaller of R1's rates.
///
/// # Errors
///
/// As [`open`].
pub fn reference(
    stage: &Stage,
    grid: GridName,
    delta: f64,
    rate: u32,
) -> Result<Reference, CostError> {
    let exact = Config { grid, newton: None, real: RealName::F64, delta, ..Config::STANDARD };
    let mut coarse = implicit(stage, &Config { rate, ..exact })?;
    let fine = implicit(stage, &Config { rate: 2 * rate, ..exact })?;
    extrapolate(&mut coarse, &fine);
    let (truth, steps) = with_grid!(grid, G => {
        let steps = explicit::rate::<G>();
        let watch = Watch { rate: steps, seconds: stage.seconds, mesh: false, until_settled: false };
        (play(Explicit::<G>::boxed(stage, &exact, steps).as_mut(), watch), steps)
    });
    let agreement = if truth.finite() { distance(&coarse, &truth).0 } else { f64::INFINITY };
    let methods = [
        format!("implicit, f64, Newton to 1e-10, {rate}/s and {}/s, Richardson", 2 * rate),
        format!("explicit leapfrog, f64, {steps}/s"),
    ];
    Ok(Reference { truth, agreement, methods })
}

fn implicit(stage: &Stage, config: &Config) -> Result<Trajectory, CostError> {
    let watch =
        Watch { rate: config.rate, seconds: stage.seconds, mesh: false, until_settled: false };
    Ok(play(open(stage, config)?.as_mut(), watch))
}

/// `2 fine - coarse`: what is left once an error of the first order is gone.
fn extrapolate(coarse: &mut Trajectory, fine: &Trajectory) {
    let pairs =
        coarse.pictures.iter_mut().zip(&fine.pictures).flat_map(|(p, q)| p.iter_mut().zip(q));
    for (p, q) in pairs {
        p.iter_mut().zip(q).for_each(|(c, f)| *c = 2.0 * f - *c);
    }
}
