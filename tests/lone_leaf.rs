//! Promise: a leaf clamped along its spine stays a leaf wherever it is let go: exactly flat, exactly upright,
//! upside down, curled, without weight, on every grid. Finite, named, in the band, and at rest in the end.

use dogleaf_core::LoneLeaf;
use dogleaf_core::grid::{G6x5, G8x6, G11x8, G12x9, G16x12, G22x16, Grid};
use dogleaf_core::real::Real;
use dogleaf_core::scene::{Fidelity, LeafSpec, PaperSpec, Preset, WorldSpec};
use dogleaf_core::step::{StepReport, StepStatus};

/// A lone leaf and the world around it.
#[derive(Debug, Clone, Copy, Default)]
struct Lone {
    leaf: LeafSpec,
    paper: PaperSpec,
    world: WorldSpec,
    fidelity: Fidelity,
}

/// What was seen of it.
#[derive(Debug, Default)]
struct Seen {
    fastest: f64,
    /// Last moment it was faster than a tenth of a page width a second.
    rest_s: f64,
    worst: f64,
    tip: [f64; 3],
    work: StepReport,
}

/// Seconds it is watched.
const SECONDS: u32 = 10;
/// Speed of a leaf at rest, model units/s: a hundredth of its width.
const REST: f64 = 0.12;

impl Lone {
    fn open<R: Real, G: Grid>(&self) -> Box<LoneLeaf<R, G>> {
        let mut lone = Box::new(LoneLeaf::<R, G>::EMPTY);
        lone.open(&self.leaf, &self.paper, &self.world, self.fidelity).expect("a sound leaf");
        lone
    }

    /// Lets it go, looks at it after every picture.
    fn watch<R: Real, G: Grid>(&self, name: &str) -> Seen {
        let mut lone = self.open::<R, G>();
        let mut seen = Seen::default();
        for n in 0..60 * SECONDS {
            let report = lone.advance(16_667);
            let name = format!("{name} {} {}x{}, picture {n}", R::NAME, G::NX, G::NZ);
            let leaf = lone.leaf();
            assert!(leaf.x.finite() && leaf.v.finite(), "{name}: not finite");
            assert_ne!(report.status, StepStatus::Held, "{name}");
            let s = lone.stretch();
            let (least, most) = (1.0 + s.smallest.wide(), 1.0 + s.largest.wide());
            assert!(
                least > 0.5 && most < 1.6,
                "{name}: edges from {least:.2} to {most:.2} of rest"
            );
            seen.worst = seen.worst.max(s.max().wide());
            seen.fastest = leaf.fastest().wide();
            if seen.fastest > REST {
                seen.rest_s = f64::from(n + 1) / 60.0;
            }
            seen.work.add(&report);
        }
        seen.tip = lone.leaf().x.at(G::NX - 1, G::NZ / 2).0.map(|c| c.wide() / 12.0);
        println!(
            "{name:28} {} {:2}x{:2}  tip ({:6.3}, {:6.3})  rest {:5.2} s  worst {:5.2} %  {} cuts {}",
            R::NAME,
            G::NX,
            G::NZ,
            seen.tip[0],
            seen.tip[1],
            seen.rest_s,
            100.0 * seen.worst,
            seen.work.status.name(),
            seen.work.cuts,
        );
        seen
    }

    /// Both scalars come to rest at the same place.
    fn rests<G: Grid>(&self, name: &str) -> Seen {
        let [a, b] = [self.watch::<f32, G>(name), self.watch::<f64, G>(name)];
        for seen in [&a, &b] {
            assert!(seen.rest_s < f64::from(SECONDS - 1), "{name}: {} units/s", seen.fastest);
        }
        let apart = a.tip.iter().zip(b.tip).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-2, "{name}: f32 and f64 rest {apart} page widths apart");
        b
    }
}

fn clamped(clamp_angle_deg: f64) -> Lone {
    Lone { leaf: LeafSpec { clamp_angle_deg, ..LeafSpec::default() }, ..Lone::default() }
}

#[test]
fn exactly_flat_without_weight_it_stays() {
    let mut lone = clamped(0.0);
    lone.world.gravity = [0.0; 3];
    fn stays<R: Real>(lone: &Lone, bound: f64) {
        let mut lone = lone.open::<R, G11x8>();
        let before = lone.leaf().x.clone();
        for _ in 0..600 {
            let report = lone.step();
            // Where there is nothing to gain, rounding may shorten a step.
            let named = [StepStatus::Converged, StepStatus::Reduced];
            assert!(named.contains(&report.status), "{}: {:?}", R::NAME, report.status);
        }
        let moved = lone.leaf().x.raw().iter().zip(before.raw());
        let far = moved.map(|(a, b)| (a.wide() - b.wide()).abs()).fold(0.0, f64::max);
        assert!(far < 12.0 * bound, "{}: {far:e}", R::NAME);
    }
    stays::<f32>(&lone, 1e-5);
    stays::<f64>(&lone, 1e-12);
}

#[test]
fn exactly_flat_it_droops_evenly() {
    let mut lone = clamped(0.0).open::<f64, G11x8>();
    for _ in 0..240 {
        let _ = lone.advance(16_667);
        let x = &lone.leaf().x;
        for (i, k) in (1..G11x8::NX).flat_map(|i| (0..4).map(move |k| (i, k))) {
            let ([a, b, c], [d, e, f]) = (x.at(i, k).0, x.at(i, 7 - k).0);
            let apart = (a - d).abs().max((b - e).abs()).max((c + f).abs());
            assert!(apart < 1e-9, "node {i} {k}: {apart:e} from its mirror image");
        }
    }
    assert!(lone.leaf().x.at(10, 4).0[1] < -1.0, "it droops");
    clamped(0.0).rests::<G11x8>("flat");
}

/// Upright a stiff leaf stands, a limp one falls to one side and may lean on nothing: it still rests.
#[test]
fn exactly_upright() {
    let stands = clamped(90.0).rests::<G11x8>("upright");
    assert!(stands.tip[1] > 0.98, "office paper stands: {:?}", stands.tip);
    let mut limp = clamped(90.0);
    limp.paper = Preset::Newsprint.into();
    let balanced = limp.rests::<G11x8>("upright, limp");
    assert!(balanced.tip[1] > 0.98 || balanced.tip[0].abs() > 0.1, "{:?}", balanced.tip);
    // A hair off the vertical decides the side.
    for (angle, side) in [(89.9, 1.0), (90.1, -1.0)] {
        limp.leaf.clamp_angle_deg = angle;
        let falls = limp.rests::<G11x8>(&format!("limp, clamp at {angle}"));
        assert!(side * falls.tip[0] > 0.1, "clamp at {angle}: {:?}", falls.tip);
    }
    limp.leaf.clamp_angle_deg = -90.0;
    let hangs = limp.rests::<G11x8>("hanging");
    assert!(hangs.tip[1] < -0.98, "{:?}", hangs.tip);
}

#[test]
fn every_clamp() {
    for angle in (-180..=180).step_by(30) {
        clamped(f64::from(angle)).rests::<G11x8>(&format!("clamp at {angle}"));
    }
}

#[test]
fn curled() {
    for turns in [-6.0, -3.0, -0.5, 0.5, 3.0, 6.0] {
        let mut lone = clamped(0.0);
        lone.leaf.curl_per_m = turns / lone.leaf.width_m;
        lone.rests::<G11x8>(&format!("curl of {turns} rad"));
    }
}

#[test]
fn every_paper_and_shape() {
    for (name, preset) in Preset::ALL {
        Lone { paper: preset.into(), ..clamped(0.0) }.rests::<G11x8>(name);
    }
    for aspect in [0.2, 0.5, 1.0, 2.0, 5.0] {
        let leaf = LeafSpec { width_m: 0.1, height_m: 0.1 * aspect, ..LeafSpec::default() };
        Lone { leaf, ..Lone::default() }.rests::<G11x8>(&format!("height {aspect} widths"));
    }
}

#[test]
fn every_world() {
    for factor in [-10.0, -1.0, 0.1, 10.0, 100.0] {
        let mut lone = clamped(0.0);
        lone.world.gravity[1] *= factor;
        lone.rests::<G11x8>(&format!("gravity x {factor}"));
    }
    for damping_per_s in [0.0, 10.0, 100.0] {
        let mut lone = clamped(0.0);
        lone.world.damping_per_s = damping_per_s;
        lone.watch::<f32, G11x8>(&format!("damping {damping_per_s} /s"));
        lone.watch::<f64, G11x8>(&format!("damping {damping_per_s} /s"));
    }
    for rate in [15, 30, 120, 240, 480] {
        let mut lone = clamped(0.0);
        lone.world.step_us = 1_000_000 / rate;
        lone.rests::<G11x8>(&format!("step 1/{rate} s"));
    }
    for (name, fidelity) in Fidelity::ALL {
        let mut lone = Lone { fidelity, ..clamped(0.0) };
        // The finer the steps, the less they damp by themselves.
        lone.world.damping_per_s = 5.0;
        lone.rests::<G11x8>(name);
    }
}

/// The same leaf on every grid rests at the same place, the nearer the finer.
#[test]
fn every_grid() {
    let lone = clamped(20.0);
    let fine = lone.rests::<G22x16>("grid").tip;
    let apart = |tip: [f64; 3]| ((tip[0] - fine[0]).powi(2) + (tip[1] - fine[1]).powi(2)).sqrt();
    let tips = [
        lone.rests::<G6x5>("grid").tip,
        lone.rests::<G8x6>("grid").tip,
        lone.rests::<G11x8>("grid").tip,
        lone.rests::<G12x9>("grid").tip,
        lone.rests::<G16x12>("grid").tip,
    ];
    let far = tips.map(apart);
    assert!(far[0] < 0.03 && far[2] < 0.01 && far[4] < 0.005, "{far:.4?}");
}
