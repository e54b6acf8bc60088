//! Orders of convergence on a motion that is known exactly: a sheet that rolls up.
//!
//! ```text
//! x(u, v, t) = (sin(k u) / k, (1 - cos(k u)) / k, v)      k = k(t)
//! ```
//!
//! is isometric and developable for every `k`. In space: a couple `D k` at the free edge holds it on a circle; the
//! solved nodes are compared with that circle. In time: on one grid the forces that make the sampled cylinder the
//! exact motion are worked out from the core's own gradient, so that all that is left is the step's error.

use crate::axes::{Config, GridName, RealName, with_grid};
use crate::reference::order;
use crate::report::Order;
use crate::scene::{Kind, Lone, Sim, Stage};
use dogleaf_core::grid::Grid;
use dogleaf_core::real::V3;
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::state::Field;
use dogleaf_core::step::assemble::assemble;
use dogleaf_core::step::matrix::NoMatrix;

/// Curvature at rest, and how far and how fast it swings; one over model units, radians a second.
const CURVATURE: f64 = 0.10;
const SWING: [f64; 2] = [0.04, 4.0];
/// Grids of the order in space. The finest would only cost time.
const GRIDS: [GridName; 5] =
    [GridName::G6x5, GridName::G8x6, GridName::G11x8, GridName::G16x12, GridName::G22x16];
/// Rates of the order in time.
const RATES: [u32; 5] = [60, 120, 240, 480, 960];
/// Seconds of the motion.
const SECONDS: f64 = 0.5;

/// All orders.
pub fn orders() -> Vec<Order> {
    vec![in_space(), in_time()]
}

/// Solved circles beside the true one.
pub fn in_space() -> Order {
    let points = GRIDS.map(|grid| with_grid!(grid, G => [spacing::<G>(), circle_error::<G>(grid)]));
    Order {
        what: "space: rolled sheet at rest, spacing against RMS error",
        order: order(&points),
        points: points.to_vec(),
        least: 1.8,
    }
}

/// Steps on a rolling sheet beside its true motion.
pub fn in_time() -> Order {
    let points = RATES.map(|rate| [1.0 / f64::from(rate), rolling_error(rate)]);
    Order {
        what: "time: rolling sheet, step against RMS error",
        order: order(&points),
        points: points.to_vec(),
        least: 0.9,
    }
}

fn spacing<G: Grid>() -> f64 {
    1.0 / (G::NX - 1) as f64
}

/// The cylinder at `u` along the sheet.
fn cylinder(k: f64, u: f64) -> [f64; 2] {
    [(k * u).sin() / k, (1.0 - (k * u).cos()) / k]
}

/// A clamped leaf without weight or air.
fn weightless<G: Grid>(config: &Config) -> (Box<Lone<f64, G>>, f64) {
    let stage = Stage { damping_per_s: 0.0, ..Stage::flat(Kind::Fall) };
    let units = stage.units();
    let mut lone = Box::new(Lone::<f64, G>::new(&stage, config));
    lone.ask.gravity = V3([0.0; 3]);
    (lone, units.energy(stage.paper.rigidity_nm()))
}

fn config(grid: GridName, rate: u32) -> Config {
    Config { grid, rate, newton: None, real: RealName::F64, ..Config::STANDARD }
}

/// A force on every node acts for one step through its velocity: `x̃ = x + h v + h² f / m`.
fn push<G: Grid>(lone: &mut Lone<f64, G>, force: impl Fn(usize, usize) -> V3<f64>) {
    let h = lone.ask.h;
    for (i, k) in Field::<f64, G>::nodes() {
        let v = lone.leaf.v.at(i, k) + force(i, k) * (h / lone.sheet.mass.at(i, k));
        lone.leaf.v.set(i, k, v);
    }
}

fn circle_error<G: Grid>(grid: GridName) -> f64 {
    let (mut lone, rigidity) = weightless::<G>(&config(grid, 20));
    let [lx, lz] = lone.sheet.spacing;
    // Normal of the last edge on the circle, which is where the couple's two forces point.
    let turned = CURVATURE * (WIDTH - 0.5 * lx);
    let normal = V3([-turned.sin(), turned.cos(), 0.0]);
    let share = |k: usize| if k == 0 || k + 1 == G::NZ { 0.5 } else { 1.0 };
    let force = |i: usize, k: usize| {
        let size = rigidity * CURVATURE * lz * share(k) / lx;
        match i + 2 {
            n if n == G::NX + 1 => normal * size,
            n if n == G::NX => normal * -size,
            _ => V3([0.0; 3]),
        }
    };
    for _ in 0..400 {
        lone.leaf.v.clear();
        push(&mut lone, force);
        let _ = lone.step(0.0);
        if lone.leaf.fastest() < 1e-9 {
            break;
        }
    }
    rms::<G>(&lone, CURVATURE)
}

/// Root mean square distance of the nodes from the cylinder, page widths.
fn rms<G: Grid>(lone: &Lone<f64, G>, k: f64) -> f64 {
    let l = WIDTH / (G::NX - 1) as f64;
    let sum: f64 = Field::<f64, G>::nodes()
        .map(|(i, r)| {
            let [x, y, _] = lone.leaf.x.at(i, r).0;
            let [cx, cy] = cylinder(k, l * i as f64);
            (x - cx) * (x - cx) + (y - cy) * (y - cy)
        })
        .sum();
    (sum / (G::NX * G::NZ) as f64).sqrt() / WIDTH
}

type Rolling = dogleaf_core::grid::G11x8;

fn curvature(t: f64) -> f64 {
    CURVATURE + SWING[0] * (SWING[1] * t).sin()
}

/// Where a node of the rolling sheet is: on the cylinder, a rest length from its neighbours. Nodes at equal arcs would be
/// nearer; the forces that held them there would press on the sheet, and it would buckle.
fn at(t: f64, i: usize) -> [f64; 2] {
    let k = curvature(t);
    let chord = WIDTH / (Rolling::NX - 1) as f64;
    let arc = 2.0 * (0.5 * k * chord).asin() / k;
    cylinder(k, arc * i as f64)
}

fn rolling_error(rate: u32) -> f64 {
    let (mut lone, _) = weightless::<Rolling>(&config(GridName::G11x8, rate));
    let mut exact = Box::new(lone.leaf.clone());
    let h = 1.0 / f64::from(rate);
    let d = 1e-4;
    for (i, k) in Field::<f64, Rolling>::nodes() {
        let ([x, y], [ax, ay], [bx, by]) = (at(0.0, i), at(d, i), at(-d, i));
        let z = lone.leaf.x.at(i, k).0[2];
        lone.leaf.x.set(i, k, V3([x, y, z]));
        lone.leaf.v.set(i, k, V3([(ax - bx) / (2.0 * d), (ay - by) / (2.0 * d), 0.0]));
    }
    let nothing = Box::new(Field::<f64, Rolling>::ZERO);
    let mut pull = Box::new(Field::<f64, Rolling>::ZERO);
    let (mut sum, steps) = (0.0, (SECONDS * f64::from(rate)).round() as u32);
    for n in 1..=steps {
        let t = h * f64::from(n);
        for (i, k) in Field::<f64, Rolling>::nodes() {
            let [x, y] = at(t, i);
            let z = exact.x.at(i, k).0[2];
            exact.x.set(i, k, V3([x, y, z]));
        }
        assemble(&lone.sheet, &exact, &nothing, &lone.ask, &mut NoMatrix, &mut pull);
        let mass = lone.sheet.mass.clone();
        push(&mut lone, |i, k| {
            let (a, b, c) = (at(t - d, i), at(t, i), at(t + d, i));
            let faster = [0, 1].map(|c_: usize| (a[c_] - 2.0 * b[c_] + c[c_]) / (d * d));
            V3([faster[0], faster[1], 0.0]) * mass.at(i, k) + pull.at(i, k)
        });
        let _ = lone.step(t);
        sum += off(&lone, t);
    }
    (sum / f64::from(steps)).sqrt() / WIDTH
}

/// Mean square distance from the true motion.
fn off(lone: &Lone<f64, Rolling>, t: f64) -> f64 {
    let squares = Field::<f64, Rolling>::nodes().map(|(i, k)| {
        let ([x, y, _], [ax, ay]) = (lone.leaf.x.at(i, k).0, at(t, i));
        (x - ax) * (x - ax) + (y - ay) * (y - ay)
    });
    squares.sum::<f64>() / (Rolling::NX * Rolling::NZ) as f64
}
