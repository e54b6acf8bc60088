//! Ribbons: the operations of a step, and three short scenes, one of each kind of trouble.

use crate::Row;
use crate::fold::Fold;
use crate::random::Random;
use crate::work::Pick;
use dogleaf_core::effect::ribbon::closure::{Gap, Hold};
use dogleaf_core::effect::ribbon::contact::distance::{Parts, Quad, apart, meetings};
use dogleaf_core::effect::ribbon::contact::push::{FLOOR, SOLID, barrier};
use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near};
use dogleaf_core::effect::ribbon::elementary::{angle, hyperbolic, logarithm};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::{Crease, Turn};
use dogleaf_core::effect::ribbon::strip::Strip;
use dogleaf_core::effect::ribbon::{
    Bending, Closure, Report, Ribbon, RibbonSpec, Root, Settings, Status, bending,
};
use dogleaf_core::real::{Real, V3};

/// Segments of a scene's ribbon.
pub(crate) const SEGMENTS: usize = 16;
/// Cases of every operation.
const CASES: usize = 500;

/// A scene's ribbon.
pub(crate) type Short<R> = Ribbon<R, SEGMENTS>;
/// What is near it: itself and a ground.
pub(crate) type Ground<R> = Near<R, HalfSpace<R>, SEGMENTS, 1, 256>;

/// Nothing near yet.
pub(crate) const fn ground<R: Real>() -> Ground<R> {
    let plane = HalfSpace { point: V3([R::ZERO; 3]), normal: V3([R::ZERO; 3]) };
    Near::over(plane, Cushion { reach_m: 2e-3, stiffness: 200.0 })
}

/// Operations.
pub(crate) fn operations<R: Pick>() -> [Row; 6] {
    [
        ("ribbon.elementary", |_| each::<R>("ribbon.elementary", elementary)),
        ("ribbon.frame", |_| each::<R>("ribbon.frame", frame)),
        ("ribbon.bending", |_| each::<R>("ribbon.bending", bent)),
        ("ribbon.closure", |_| each::<R>("ribbon.closure", closed)),
        ("ribbon.push", |_| each::<R>("ribbon.push", pushed)),
        ("ribbon.distance", |_| each::<R>("ribbon.distance", distance)),
    ]
}

/// Scenes.
pub(crate) fn scenes<R: Pick>() -> [Row; 3] {
    [
        ("ribbon_helix", |w| helix(&mut R::of_work(w).ribbon).hash),
        ("ribbon_band", |w| band(&mut R::of_work(w).ribbon).hash),
        ("ribbon_fall", |w| {
            let tier = R::of_work(w);
            fall(&mut tier.ribbon, &mut tier.ground).hash
        }),
    ]
}

fn each<R: Real>(name: &str, run: fn(&mut Random, &mut Fold) -> R) -> u64 {
    let (mut random, mut fold) = (Random::named(name), Fold::START);
    for _ in 0..CASES {
        let last = run(&mut random, &mut fold);
        fold.real(last);
    }
    fold.value()
}

fn elementary<R: Real>(random: &mut Random, fold: &mut Fold) -> R {
    let [x, y] = [random.wild::<R>(), random.wild::<R>()].map(|v| v.magnitude());
    fold.real(logarithm(x));
    fold.real(angle(x, y));
    hyperbolic(random.within::<R>(0.999)).into_iter().for_each(|v| fold.real(v));
    logarithm(y)
}

fn some_frame<R: Real>(random: &mut Random) -> Frame<R> {
    Frame::leaning(random.v3(2.0), random.v3(1.0), random.v3(1.0))
}

fn fold_frame<R: Real>(frame: &Frame<R>, fold: &mut Fold) {
    [frame.t, frame.b, frame.n, frame.p].into_iter().for_each(|v| fold.v3(v));
}

fn crease<R: Real>(random: &mut Random) -> Crease<R> {
    Crease { psi: random.within(3.0), c: random.within(2.0) }
}

fn frame<R: Real>(random: &mut Random, fold: &mut Fold) -> R {
    let frame = some_frame::<R>(random);
    fold_frame(&frame, fold);
    let turn = Turn::of(crease(random));
    let beyond = turn.beyond(&frame, random.within(0.1));
    fold_frame(&beyond, fold);
    turn.axes(&frame).into_iter().chain(turn.second_axes(&frame)).for_each(|v| fold.v3(v));
    let twist = core::array::from_fn(|_| random.within(1.5));
    let moved = beyond.moved(&twist);
    fold_frame(&moved, fold);
    moved.apart(&frame).into_iter().for_each(|v| fold.v3(v));
    turn.versine
}

fn bent<R: Real>(random: &mut Random, fold: &mut Fold) -> R {
    let accurate = random.below(2) == 0;
    let bending = if accurate { Bending::Wunderlich } else { Bending::Sadowsky };
    let strip = Strip::of(&RibbonSpec { bending, ..spec() });
    let (a, j) = (crease(random), random.below(4) as usize);
    let b = Crease { psi: random.within(3.0), c: a.c + random.within::<R>(0.99) * strip.limit };
    let found = bending::derivatives(&strip, j, a, b);
    found.g.into_iter().chain(found.h.into_iter().flatten()).for_each(|v| fold.real(v));
    bending::energy(&strip, j, a, b)
}

fn closed<R: Real>(random: &mut Random, fold: &mut Fold) -> R {
    let [end, start] = [some_frame::<R>(random), some_frame(random)];
    let turned: R = random.within(3.0);
    let gap = Gap::between(&end, &start, [turned.sine(), turned.cosine()]);
    let lambda = core::array::from_fn(|_| random.within(1.0));
    let hold = Hold { lambda, turn: R::of(3.0), shift: R::of(40.0) };
    hold.gradient(&gap).into_iter().flatten().for_each(|v| fold.real(v));
    hold.hessian(&gap).into_iter().flatten().for_each(|v| fold.real(v));
    hold.energy(&gap)
}

fn pushed<R: Real>(random: &mut Random, fold: &mut Fold) -> R {
    let (cushion, d) = (Cushion::default(), random.within::<R>(2.2e-3));
    let both = [FLOOR, SOLID].map(|floor| barrier(&cushion, d, floor));
    both.into_iter().flatten().for_each(|v| fold.real(v));
    d
}

fn quad<R: Real>(random: &mut Random) -> Quad<R> {
    core::array::from_fn(|_| random.v3(0.05))
}

fn distance<R: Real>(random: &mut Random, fold: &mut Fold) -> R {
    let (a, b) = (quad::<R>(random), quad::<R>(random));
    meetings([&a, &b], [Parts::own(false); 2], |m| {
        fold.v3(m.way);
        m.here.into_iter().chain(m.there).for_each(|w| fold.real(w));
    });
    apart(&a, &b)
}

/// What scenes are made of.
fn spec() -> RibbonSpec {
    RibbonSpec { segments: SEGMENTS, rigidity_nm: 2e-3, ..RibbonSpec::default() }
}

/// What a scene came to.
struct Ran {
    hash: u64,
    /// That something was solved.
    #[cfg_attr(not(test), expect(dead_code, reason = "asked for by tests only"))]
    newton: u32,
}

/// A ribbon under way.
struct Run<'a, R: Real> {
    ribbon: &'a mut Short<R>,
    fold: Fold,
    newton: u32,
}

impl<'a, R: Real> Run<'a, R> {
    fn open(ribbon: &'a mut Short<R>, spec: &RibbonSpec) -> Self {
        let opened = ribbon.open(spec, [0.0; 3]).is_ok();
        let mut fold = Fold::START;
        fold.word(u64::from(opened));
        Self { ribbon, fold, newton: 0 }
    }
    fn note(&mut self, report: &Report<R>) {
        self.newton += report.iterations;
        self.fold.word(self.ribbon.state_hash());
        self.fold.word(u64::from(report.iterations) << 8 | ended(report.status));
        self.fold.real(report.objective);
    }
    fn ran(self) -> Ran {
        Ran { hash: self.fold.value(), newton: self.newton }
    }
}

fn ended(status: Status) -> u64 {
    match status {
        Status::Converged => 0,
        Status::Capped => 1,
        Status::Stalled => 2,
        Status::Held => 3,
        Status::Open => 4,
    }
}

/// Three turns of a helix, clamped, let go under gravity.
fn helix<R: Real>(ribbon: &mut Short<R>) -> Ran {
    let mut run = Run::open(ribbon, &spec());
    run.ribbon.gravity = [0.0, -9.81, 0.0];
    let psi = R::of(6.0 * core::f64::consts::PI / SEGMENTS as f64);
    run.ribbon.lay(&Frame::at(V3([R::ZERO; 3])), |_| Crease { psi, c: R::of(0.3) });
    for _ in 0..8 {
        let report = run.ribbon.step(0.01);
        run.note(&report);
    }
    run.ran()
}

/// A Möbius band, wound with Wunderlich's energy, then let fall.
fn band<R: Real>(ribbon: &mut Short<R>) -> Ran {
    let loose = RibbonSpec {
        closure: Closure::Moebius,
        root: Root::Free,
        bending: Bending::Wunderlich,
        regularisation: 4e-2,
        ..spec()
    };
    let mut run = Run::open(ribbon, &loose);
    let report = run.ribbon.wind(&Frame::at(V3([R::ZERO; 3])), &Settings::STEP);
    run.note(&report);
    run.ribbon.gravity = [0.0, 0.0, -9.81];
    for _ in 0..3 {
        let report = run.ribbon.step(0.02);
        run.note(&report);
    }
    run.ran()
}

/// A free ribbon that falls aslant on a half-space, by contact.
fn fall<R: Real>(ribbon: &mut Short<R>, near: &mut Ground<R>) -> Ran {
    let mut run = Run::open(ribbon, &RibbonSpec { root: Root::Free, ..spec() });
    run.ribbon.gravity = [0.0, 0.0, -9.81];
    near.surface =
        HalfSpace { point: V3([R::ZERO; 3]), normal: V3([R::ZERO, R::ZERO, R::of(1.0)]) };
    let base = Frame::leaning(
        V3([0.0, 0.0, 0.02].map(R::of)),
        V3([0.98, 0.1, 0.06].map(R::of)),
        V3([0.0, 0.0, 1.0].map(R::of)),
    );
    run.ribbon.lay(&base, |j| Crease { psi: R::of(0.05), c: R::of(0.02 * (j % 5) as f64) });
    for _ in 0..10 {
        near.begin(run.ribbon, 0.01);
        let report = run.ribbon.step_touching(0.01, &(), near);
        run.note(&report);
        run.fold.word(u64::from(near.counts.pushes) << 32 | u64::from(near.counts.limited));
    }
    run.ran()
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{band, fall, helix};
    use crate::Work;
    use crate::work::Pick;
    use std::boxed::Box;

    #[test]
    fn in_every_scene_something_is_solved() {
        let mut work = Box::new(Work::EMPTY);
        let tier = f32::of_work(&mut work);
        let runs = [
            helix(&mut tier.ribbon),
            band(&mut tier.ribbon),
            fall(&mut tier.ribbon, &mut tier.ground),
        ];
        let newton = runs.map(|r| r.newton);
        std::println!("{newton:?}, pushes at the end: {}", tier.ground.counts.pushes);
        assert!(newton.iter().all(|&n| n >= 30), "Newton iterations: {newton:?}");
        assert!(tier.ground.counts.pushes > 0, "the fall ended on the ground");
    }
}
