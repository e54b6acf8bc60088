//! The parts of a step, timed one by one on the poses of a turn.

use super::poses::{Pose, Poses};
use super::times::{Figures, Times};
use dogleaf_core::collision::{block, leaf};
use dogleaf_core::grid::Grid;
use dogleaf_core::kkt::solve::Unknowns;
use dogleaf_core::kkt::{Factor, Stencil};
use dogleaf_core::real::{Real, V2};
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::state::sheet::{CONTACT, DELTA};
use dogleaf_core::state::strip::{BLOCK, Fibre};
use dogleaf_core::state::{Field, Leaf};
use dogleaf_core::step::assemble::assemble;
use dogleaf_core::step::constant::Constant;
use dogleaf_core::step::matrix::Matrix;
use dogleaf_core::step::merit::merit;
use dogleaf_core::step::strip::{StripAsk, step as step_strip};
use serde::Serialize;
use std::hint::black_box;
use std::time::Instant;

/// The parts, in the order of a step. Merit is what a step without cuts evaluates: two poses.
pub(super) const NAMES: [&str; 6] =
    ["midline", "assemble", "factor", "solve", "merit", "collisions"];

/// One part's line of the report.
#[derive(Debug, Serialize)]
pub(super) struct Part {
    pub(super) name: &'static str,
    pub(super) us: Figures,
    /// Of the median of the whole step.
    pub(super) share: f64,
}

/// The parts' figures; what no part covers is `other`.
pub(super) fn report(by_part: &[Times], step_us: f64) -> Vec<Part> {
    let share = |us: f64| if step_us > 0.0 { us / step_us } else { 0.0 };
    let part = |(name, times): (&&'static str, &Times)| {
        let us = times.figures();
        Part { name, us, share: share(us.median) }
    };
    let mut parts: Vec<Part> = NAMES.iter().zip(by_part).map(part).collect();
    let other = (step_us - parts.iter().map(|p| p.us.median).sum::<f64>()).max(0.0);
    let us = Figures { median: other, p95: other, p99: other };
    parts.push(Part { name: "other", us, share: share(other) });
    parts
}

/// Poses, and the workspace a step has.
pub(super) struct Parts<R: Real, G: Grid> {
    poses: Poses<R, G>,
    work: Box<Work<R, G>>,
}

struct Work<R: Real, G: Grid> {
    constant: Constant<R, G>,
    stencil: Stencil<R, G>,
    factor: Factor<R, G>,
    gradient: Field<R, G>,
    inertia: Field<R, G>,
    unknowns: Unknowns<R, G>,
    leaf: Leaf<R, G>,
    scratch: Field<R, G>,
}

impl<R: Real, G: Grid> Parts<R, G> {
    pub(super) fn new(poses: Poses<R, G>) -> Self {
        let mut work = Box::new(Work {
            constant: Constant::ZERO,
            stencil: Stencil::ZERO,
            factor: Factor::ZERO,
            gradient: Field::ZERO,
            inertia: Field::ZERO,
            unknowns: Unknowns::ZERO,
            leaf: Leaf::ZERO,
            scratch: Field::ZERO,
        });
        if let Some(pose) = poses.list.first() {
            work.constant.fill(&poses.sheet, pose.ask.h, pose.ask.root);
        }
        Self { poses, work }
    }

    /// Microseconds of every part at every pose.
    pub(super) fn time(&mut self) -> [Vec<f64>; NAMES.len()] {
        let mut times: [Vec<f64>; NAMES.len()] = Default::default();
        for pose in &self.poses.list {
            let all = self.work.time(&self.poses, pose);
            for (times, time) in times.iter_mut().zip(all) {
                times.push(time);
            }
        }
        times
    }
}

fn timed<T>(work: impl FnOnce() -> T) -> f64 {
    let start = Instant::now();
    black_box(work());
    start.elapsed().as_nanos() as f64 * 1e-3
}

impl<R: Real, G: Grid> Work<R, G> {
    fn time(&mut self, poses: &Poses<R, G>, pose: &Pose<R, G>) -> [f64; NAMES.len()] {
        let sheet = &*poses.sheet;
        let midline = timed(|| step_midline(pose));
        let assemble = timed(|| {
            let Self { constant, stencil, factor, gradient, inertia, .. } = self;
            let mut matrix = Matrix { constant, stencil, factor };
            assemble(sheet, &pose.leaf, inertia, &pose.ask, &mut matrix, gradient);
        });
        let factor = timed(|| self.factor.decompose());
        let rhs = self.gradient.raw().iter().cycle();
        self.unknowns.numbers_mut().iter_mut().zip(rhs).for_each(|(u, &g)| *u = g);
        let solve = timed(|| self.factor.solve(&mut self.unknowns));
        let x = &pose.leaf.x;
        let merit = timed(|| {
            [x, &self.scratch].map(|aim| merit(sheet, &pose.leaf, black_box(x), aim, &pose.ask))
        });
        self.leaf.clone_from(&pose.leaf);
        let [left, right] = &pose.profiles;
        let collisions =
            timed(|| leaf::resolve(&mut self.leaf, [left, right], pose.half, 3, &mut self.scratch));
        [midline, assemble, factor, solve, merit, collisions]
    }
}

/// Both boards and both blocks, as a book steps them. The solves are dense: the numbers cost nothing.
fn step_midline<R: Real, G: Grid>(pose: &Pose<R, G>) -> u32 {
    let edge = WIDTH / (BLOCK - 1) as f64;
    let fibre = |edge: f64| Fibre {
        edge: R::of(edge),
        mass: R::of(1.0 / 6.0),
        bend: R::of(20.0),
        glue: R::of(30.0),
    };
    let ask = StripAsk {
        h: pose.ask.h,
        keep: pose.ask.keep,
        gravity: V2([R::ZERO, pose.ask.gravity.0[1]]),
        delta: R::of(DELTA),
        contact: R::of(CONTACT),
    };
    let mut pushed = 0;
    for (mut strip, mut board) in pose.blocks.into_iter().zip(pose.boards) {
        let before = (strip.x, board.x);
        step_strip::<R, 2, 2>(&mut board, &fibre(WIDTH), &ask);
        pushed += block::resolve(&mut board, &block::Ground::table());
        block::velocities(&mut board, &before.1, ask.h);
        step_strip::<R, 7, 12>(&mut strip, &fibre(edge), &ask);
        pushed += block::resolve(&mut strip, &block::Ground::board(&board));
        block::velocities(&mut strip, &before.0, ask.h);
    }
    pushed
}
