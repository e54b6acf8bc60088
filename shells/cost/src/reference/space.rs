//! The limit of no spacing, from grids whose spacings shrink.

use crate::axes::GridName;
use crate::errors::distance;
use crate::run::Trajectory;

/// A limit in space, and how well it is known.
#[derive(Debug, Clone)]
pub struct Limit {
    /// The limit from the finest grids.
    pub truth: Trajectory,
    /// Its distance from the limit of the next ones.
    pub agreement: f64,
    /// Which grids made the two.
    pub methods: [String; 2],
}

/// Limits from the trajectories of grids, coarse to fine: from the last pair, and from the pair before it.
///
/// # Source
///
/// `x = X + c h²` with `h²` the mean of the squared spacings, as shares of the page: the grids are nearly alike.
pub fn limit(runs: &[(GridName, Trajectory)]) -> Option<Limit> {
    let [.., (ga, a), (gb, b), (gc, c)] = runs else { return None };
    let truth = extrapolated(*gb, b, *gc, c);
    let other = extrapolated(*ga, a, *gb, b);
    let agreement = distance(&truth, &other).0;
    let methods = [format!("{gb} and {gc} to no spacing"), format!("{ga} and {gb} to no spacing")];
    Some(Limit { truth, agreement, methods })
}

/// Mean squared spacing.
fn spacing_sq(grid: GridName) -> f64 {
    let [nx, nz] = grid.size().map(|n| 1.0 / (n - 1) as f64);
    0.5 * (nx * nx + nz * nz)
}

fn extrapolated(ga: GridName, a: &Trajectory, gb: GridName, b: &Trajectory) -> Trajectory {
    let (ha, hb) = (spacing_sq(ga), spacing_sq(gb));
    let w = ha / (ha - hb);
    let mut limit = b.clone();
    let pairs = limit.pictures.iter_mut().zip(&a.pictures).flat_map(|(p, q)| p.iter_mut().zip(q));
    for (p, q) in pairs {
        p.iter_mut().zip(q).for_each(|(fine, coarse)| *fine = w * *fine + (1.0 - w) * coarse);
    }
    limit
}

/// Observed order of errors that belong to sizes: the slope of the best line through their logarithms.
pub fn order(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let logs: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::ln)).collect();
    let mean = |c: usize| logs.iter().map(|p| p[c]).sum::<f64>() / n;
    let (mx, my) = (mean(0), mean(1));
    let over: f64 = logs.iter().map(|p| (p[0] - mx) * (p[1] - my)).sum();
    let under: f64 = logs.iter().map(|p| (p[0] - mx) * (p[0] - mx)).sum();
    over / under
}
