//! What is seen of a leaf at one moment, and the one thing every scene can do: take a step.

use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;
use dogleaf_core::state::{Leaf, Sheet};
use dogleaf_core::step::StepReport;

/// A leaf that can be stepped.
pub trait Sim {
    /// Takes one step that ends at `t_s` seconds.
    fn step(&mut self, t_s: f64) -> StepReport;
    /// What is seen now; nothing where no leaf is in the air.
    fn look(&self) -> Option<Look>;
    /// Mean place of the fore-edge across, page widths from the spine.
    fn edge(&self) -> Option<f64>;
    /// Whether the leaf has come down and lies.
    fn settled(&mut self) -> bool {
        false
    }
    /// Makes a mesh, for who asks for one; answers the bytes it took.
    fn mesh(&mut self) -> usize {
        0
    }
    /// Bytes of state and workspace.
    fn bytes(&self) -> usize;
}

/// A leaf at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// Nodes across and along.
    pub size: [usize; 2],
    /// Places, page widths, column by column from the spine.
    pub nodes: Vec<[f64; 3]>,
    /// Largest and root mean square edge stretch.
    pub stretch: [f64; 2],
    /// Largest difference between the four angles of an inner node, radians.
    pub star: f64,
    /// Kinetic and potential energy, model units.
    pub energy: [f64; 2],
    /// Deepest place inside a block, thicknesses of a leaf; negative: none.
    pub depth: f64,
}

/// Model units of a page's width.
const WIDTH: f64 = dogleaf_core::scene::units::WIDTH;

impl Look {
    /// Looks at a leaf.
    pub fn of<R: Real, G: Grid>(leaf: &Leaf<R, G>, sheet: &Sheet<R, G>, energy: [R; 2]) -> Self {
        let at = |i: usize, k: usize| leaf.x.at(i, k).0.map(|c| c.wide() / WIDTH);
        let nodes = (0..G::NX).flat_map(|i| (0..G::NZ).map(move |k| (i, k)));
        let nodes: Vec<[f64; 3]> = nodes.map(|(i, k)| at(i, k)).collect();
        let stretch = leaf.stretch(sheet.spacing);
        let star = star(&nodes, [G::NX, G::NZ]);
        Self {
            size: [G::NX, G::NZ],
            nodes,
            stretch: [stretch.max().wide(), stretch.rms().wide()],
            star,
            energy: energy.map(Real::wide),
            depth: f64::NEG_INFINITY,
        }
    }
}

/// Largest difference between the four angles round any inner node: nothing on a perfect net.
fn star(nodes: &[[f64; 3]], [nx, nz]: [usize; 2]) -> f64 {
    let at = |i: usize, k: usize| nodes[i * nz + k];
    let mut worst = 0.0_f64;
    for (i, k) in (1..nx - 1).flat_map(|i| (1..nz - 1).map(move |k| (i, k))) {
        let arms =
            [at(i + 1, k), at(i, k + 1), at(i - 1, k), at(i, k - 1)].map(|p| minus(p, at(i, k)));
        let angles = [0, 1, 2, 3].map(|n: usize| angle(arms[n], arms[(n + 1) % 4]));
        let most = angles.iter().fold(f64::MIN, |m, &a| m.max(a));
        let least = angles.iter().fold(f64::MAX, |m, &a| m.min(a));
        worst = worst.max(most - least);
    }
    worst
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    (dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()).clamp(-1.0, 1.0).acos()
}
