//! A leaf clamped level, at rest: how far its free edge has come down, for the heavy elastica to judge.

use super::lone::Lone;
use super::{Kind, Stage};
use crate::axes::{Config, with_types};
use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;
use dogleaf_core::scene::units::WIDTH;

/// Weights that are asked: `Γ = w g L³ / D`.
pub const GAMMAS: [f64; 3] = [1.0, 10.0, 30.0];

/// Drop and reach of the free edge at rest, page widths.
pub fn rest(gamma: f64, config: &Config) -> [f64; 2] {
    let mut stage = Stage::flat(Kind::Fall);
    let [width, _] = stage.size_m;
    let wanted = stage.paper.areal_mass_gsm * 1e-3 * 9.81 * width * width * width / gamma;
    stage.paper.youngs_gpa *= wanted / stage.paper.rigidity_nm();
    with_types!(config, R, G => at_rest::<R, G>(&stage, config))
}

fn at_rest<R: Real, G: Grid>(stage: &Stage, config: &Config) -> [f64; 2] {
    let mut lone = Box::new(Lone::<R, G>::new(stage, config));
    lone.come_to_rest();
    let tips = (0..G::NZ).map(|k| lone.leaf.x.at(G::NX - 1, k).0.map(Real::wide));
    let [x, y] = tips.fold([0.0; 2], |sum, tip| [sum[0] + tip[0], sum[1] - tip[1]]);
    [y, x].map(|v| v / (WIDTH * G::NZ as f64))
}
