//! One step of the product against one of the seed's form, from poses of a real turn.
//!
//! They are the same Newton step where they must be: the same `δ`, the semidefinite `∇²V`, no contact, the
//! spine held. What then differs is `C_binding`: the product eliminates its rows, here they give by `δ λ`,
//! so the distance goes to zero with `δ`.

use super::{flat_book, model};
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::scene::Settings;
use dogleaf_core::seed::{Pose, SeedSettings, Solver as SeedSolver};
use dogleaf_core::state::{Field, Leaf, Root, Sheet};
use dogleaf_core::step::{Ask, Solver, StepReport, StepStatus};
use dogleaf_tests::gesture::{Gesture, Scene, play};

/// Width of a page.
const WIDTH: f64 = 12.0;

/// A moment of a turn.
struct Moment {
    sheet: Sheet<f64, G11x8>,
    leaf: Leaf<f64, G11x8>,
    ask: Ask<f64>,
}

/// Every eighth picture of a turn by the product, contacts forgotten.
fn moments(seed: u64) -> Vec<Moment> {
    let scene = Scene::seed();
    let mut book = scene.open::<f64, G11x8>().expect("a sound scene");
    let h = 1.0 / 60.0;
    let gravity = dogleaf_core::real::V3([0.0, -98.1, 0.0]);
    let (mut all, mut frame) = (Vec::new(), 0);
    play(&mut book, &Gesture::corner_turn(&scene.eye(), seed), 60, &mut |book, _| {
        frame += 1;
        if let (Some(leaf), true) = (book.leaf(), frame % 8 == 0) {
            let mut leaf = leaf.clone();
            leaf.holding.clear();
            let grab = book.held();
            let ask = Ask { h, keep: 0.98, gravity, root: Root::Hinge, grab };
            all.push(Moment { sheet: book.sheet().clone(), leaf, ask });
        }
    });
    all
}

impl Moment {
    fn set_delta(&mut self, delta: f64) {
        let ratio = (self.sheet.delta / delta).sqrt();
        self.sheet.delta = delta;
        for (i, k) in Field::<f64, G11x8>::nodes() {
            self.sheet.star.set(i, k, self.sheet.star.at(i, k) * ratio);
        }
    }
    /// The product's step; `None` where it was cut.
    fn product(&self) -> Option<Field<f64, G11x8>> {
        let (mut solver, mut leaf) = (Box::new(Solver::ZERO), self.leaf.clone());
        let mut report = StepReport::default();
        solver.step(&self.sheet, &mut leaf, &self.ask, &Settings::STANDARD, &mut report);
        (report.status == StepStatus::Converged).then_some(leaf.x)
    }
    /// The seed's step; `None` where it was cut.
    fn seed(&self, settings: &SeedSettings) -> Option<Field<f64, G11x8>> {
        let mut solver = Box::new(SeedSolver::ZERO);
        let (mut pose, mut velocity) = (flat_book(&self.leaf.x), Box::new(Pose::ZERO));
        velocity.leaf.copy_from(&self.leaf.v);
        let mut report = StepReport::default();
        let asked = model(&self.sheet, &self.leaf, self.ask);
        solver.step(&asked, settings, &mut pose, &velocity, &mut report);
        (report.status == StepStatus::Converged).then(|| pose.leaf.clone())
    }
}

/// Largest distance between two poses, in page widths.
fn apart(a: &Field<f64, G11x8>, b: &Field<f64, G11x8>) -> f64 {
    Field::<f64, G11x8>::nodes()
        .map(|(i, k)| (a.at(i, k) - b.at(i, k)).0.map(|d| d * d).iter().sum::<f64>().sqrt())
        .fold(0.0, f64::max)
        / WIDTH
}

/// The worst over moments, how far the leaf moved at most, and how many both steps were whole in.
fn compare(
    moments: &mut [Moment],
    product_delta: f64,
    settings: &SeedSettings,
) -> (f64, f64, usize) {
    let (mut worst, mut moved, mut count) = (0.0, 0.0, 0);
    for moment in moments {
        moment.set_delta(product_delta);
        let (Some(a), Some(b)) = (moment.product(), moment.seed(settings)) else { continue };
        worst = f64::max(worst, apart(&a, &b));
        moved = f64::max(moved, apart(&a, &moment.leaf.x));
        count += 1;
    }
    (worst, moved, count)
}

#[test]
fn one_step_is_one_step() {
    let mut all: Vec<Moment> = (0..4).flat_map(moments).collect();
    let there = all.len();
    assert!(G11x8::UNKNOWNS > 0 && there >= 20, "{there} moments");
    println!("product and seed's form, largest distance of a node in page widths:");
    let mut last = f64::INFINITY;
    for (product, seed) in
        [(1e-6, 1e-6), (1e-7, 1e-7), (1e-8, 1e-8), (1e-9, 1e-9), (1e-10, 1e-10), (1e-6, 1e-8)]
    {
        for exact in [false, true] {
            let settings = SeedSettings { delta: seed, exact, ..SeedSettings::default() };
            let (worst, moved, count) = compare(&mut all, product, &settings);
            let hessian = if exact { "exact" } else { "semidefinite" };
            println!(
                "  delta {product:.0e} and {seed:.0e}, {hessian:12}: {worst:.1e} of {moved:.1e} moved, {count} of {there}"
            );
            if !exact {
                assert!(2 * count >= there, "cut: {count} of {there}");
                assert!(moved > 1e-3, "a leaf that does not move proves nothing");
                assert!(product != seed || worst < 0.3 * last, "{worst:.1e} at {product:.0e}");
                assert!(product != 1e-9 || worst < 1e-6, "{worst:.1e} at {product:.0e}");
                last = worst;
            }
        }
    }
}
