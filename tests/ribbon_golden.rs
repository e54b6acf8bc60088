//! Promise: figures of ribbons move only when somebody says so. Every scene of the seed, some steps of it, printed anew
//! and compared whole.

use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::{
    Bending, Closure, Mass, Report, Ribbon, RibbonSpec, Root, Settings, Status,
};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::state::Fnv;
use dogleaf_tests::golden::compare;
use dogleaf_tests::ribbons::{falling, helix, open, pulled, spec, start, twist};
use std::f64::consts::PI;
use std::fmt::Write;

/// A row of the table under way.
struct Row<R: Real, const N: usize> {
    ribbon: Box<Ribbon<R, N>>,
    way: Fnv,
    steps: u32,
    iterations: u32,
    /// Solves that did not converge.
    short: u32,
    gap: f64,
}

impl<R: Real, const N: usize> Row<R, N> {
    fn of(ribbon: Box<Ribbon<R, N>>) -> Self {
        Self { ribbon, way: Fnv::default(), steps: 0, iterations: 0, short: 0, gap: 0.0 }
    }
    fn take(&mut self, report: &Report<R>) {
        self.steps += 1;
        self.iterations += report.iterations;
        self.short += u32::from(report.status != Status::Converged);
        self.gap = self.gap.max(report.gap.wide());
        self.way.word(self.ribbon.state_hash());
    }
    /// Steps of `h` seconds, each asked for something before it, by its number and the share of the way.
    fn play(mut self, steps: u32, h: f64, mut ask: impl FnMut(&mut Ribbon<R, N>, f64)) -> Self {
        for k in 0..steps {
            ask(&mut self.ribbon, f64::from(k + 1) / f64::from(steps));
            let report = self.ribbon.step(h);
            self.take(&report);
        }
        self
    }
    fn line(&self, table: &mut String, name: &str) {
        let e = self.ribbon.energy();
        let [moving, bent] = [e.kinetic, e.bending].map(|e| 1e3 * e.wide());
        let gap = if self.ribbon.spec().closure == Closure::Open {
            "       -".to_owned()
        } else {
            format!("{:8.1e}", self.gap)
        };
        let Self { steps, iterations, short, .. } = self;
        let (real, hash) = (R::NAME, self.way.value());
        writeln!(
            table,
            "{name:16}  {real}  {steps:5}  {iterations:6}  {short:5}  {moving:10.4}  {bent:10.4}  {gap}  {hash:016x}"
        )
        .expect("a text takes every line");
    }
}

fn twisted<R: Real>(width_m: f64, angle: f64) -> Row<R, 50> {
    let ribbon = open::<R, 50>(&RibbonSpec { width_m, ..spec(50) });
    Row::of(ribbon).play(50, 0.01, |r, t| twist(r, angle * t, 10.0))
}

/// Spins about its centreline.
fn spinning<R: Real>(mass: Mass) -> Row<R, 50> {
    let free = RibbonSpec { width_m: 0.1, root: Root::Free, perturbation: 1e-4, mass, ..spec(50) };
    let mut ribbon = open::<R, 50>(&free);
    ribbon.launch(|x| V3([40.0, 0.0, 0.0].map(R::of)).cross(x));
    Row::of(ribbon).play(30, 0.01, |_, _| {})
}

/// A long one that falls on a half-space, by contact.
fn landing<R: Real>() -> Row<R, 150> {
    let mut row = Row::of(falling::<R, 150>(150));
    let [o, l] = [R::ZERO, R::of(1.0)];
    let ground = HalfSpace { point: V3([o; 3]), normal: V3([o, o, l]) };
    let mut near = Box::new(Near::<_, _, 150, 1, 4096>::over(ground, Cushion::default()));
    for _ in 0..50 {
        near.begin(&row.ribbon, 0.01);
        let report = row.ribbon.step_touching(0.01, &(), &mut *near);
        row.take(&report);
    }
    row
}

/// A Möbius band's rest shape.
fn rest<R: Real>(length_m: f64, settings: &Settings) -> Row<R, 100> {
    let band = RibbonSpec {
        length_m,
        width_m: 0.02,
        closure: Closure::Moebius,
        bending: Bending::Wunderlich,
        regularisation: 1e-6,
        ..spec(100)
    };
    let mut row = Row::of(open::<R, 100>(&band));
    let report = row.ribbon.wind(&start(), settings);
    row.take(&report);
    row
}

/// A ribbon clamped level that has drooped to rest.
fn droop<R: Real>(settings: &Settings) -> Row<R, 50> {
    let rigidity_nm = 0.1 * 9.81 / 10.0;
    let mut row = Row::of(open::<R, 50>(&RibbonSpec { rigidity_nm, ..spec(50) }));
    row.ribbon.gravity = [0.0, 0.0, -9.81];
    row.ribbon.lay(&Frame::at(V3([R::ZERO; 3])), |_| Crease::default());
    let report = row.ribbon.settle(settings);
    row.take(&report);
    row
}

fn scenes<R: Real>(table: &mut String) {
    let exact = if R::EPSILON < 1e-10 {
        Settings::EXACT
    } else {
        Settings { iterations: 200, ..Settings::STEP }
    };
    twisted::<R>(0.05, 4.0 * PI).line(table, "torsion 4 pi");
    twisted::<R>(0.1, 2.0 * PI).line(table, "torsion, wide");
    let drag = Row::of(pulled::<R, 50>(50, Closure::Ring, 1e3));
    drag.play(20, 0.01, |_, _| {}).line(table, "drag 1000 N/m");
    for (name, steps, h) in [("helix h=0.01", 50, 0.01), ("helix h=0.05", 10, 0.05)] {
        Row::of(helix::<R, 50>(&spec(50))).play(steps, h, |_, _| {}).line(table, name);
    }
    spinning::<R>(Mass::Consistent).line(table, "spin");
    spinning::<R>(Mass::Lumped).line(table, "spin, lumped");
    landing::<R>().line(table, "fall 150");
    for (name, length) in [("band 0.3 m", 0.3), ("band 0.6 m", 0.6), ("band 2 m", 2.0)] {
        rest::<R>(length, &exact).line(table, name);
    }
    let falls = Row::of(pulled::<R, 50>(50, Closure::Moebius, 0.0));
    falls.play(20, 0.01, |_, _| {}).line(table, "band that falls");
    droop::<R>(&exact).line(table, "droop 10");
}

#[test]
fn scenes_of_ribbons() {
    let mut table = String::from(
        "Scenes of ribbons, some steps of each; iterations and solves that did not converge are of all steps, energies\n\
         at the end, the gap is a loop's widest, the hash that of the way. Figures of chains: `ribbon_chains`.\n\
         scene             real  steps  newton  short   moving mJ     bent mJ       gap  hash of the way\n",
    );
    scenes::<f32>(&mut table);
    scenes::<f64>(&mut table);
    if let Err(difference) = compare("ribbons.txt", &table) {
        panic!("{difference}");
    }
}
