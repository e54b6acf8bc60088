//! The seed's Table 1 and Figs 7 to 13, as far as they have figures, beside its method rebuilt here and ours.

use super::race::as_the_seed;
use super::scenes::{Long, Scene, fall, helix, loop_of, spin, torsion};
use crate::claims::Claim;
use dogleaf_core::effect::ribbon::{Bending, Closure, Mass, Settings};
use dogleaf_core::scene::SpecError;
use std::time::Instant;

/// Where the seed's own iteration counts say that it stops: relative falls of so many times the spacing of `f64`.
const FACTOR: f64 = 1e7;
/// Every so many steps the rebuilt method is tried.
const EVERY: u32 = 10;

/// Mean iterations and milliseconds of a step.
#[derive(Debug, Clone, Copy, Default)]
struct Mean {
    steps: f64,
    inner: f64,
    outer: f64,
    ms: f64,
}

impl Mean {
    fn take(&mut self, inner: u32, outer: u32, seconds: f64) {
        self.steps += 1.0;
        self.inner += f64::from(inner);
        self.outer += f64::from(outer);
        self.ms += 1e3 * seconds;
    }
    fn text(&self) -> String {
        let of = |sum: f64| sum / self.steps.max(1.0);
        format!("{:.2} ms, {:.0}/{:.0}", of(self.ms), of(self.inner), of(self.outer))
    }
}

/// Plays a scene with our solver, and tries the rebuilt one on some of its steps.
fn play(mut scene: Scene, rebuild: bool) -> [String; 2] {
    let (mut seed, mut ours) = (Mean::default(), Mean::default());
    for step in 0..scene.steps {
        scene.ask(step);
        if rebuild && step % EVERY == EVERY - 1 {
            let (answer, seconds) = as_the_seed(&scene, FACTOR);
            seed.take(answer.inner, answer.outer, seconds);
        }
        let start = Instant::now();
        let report = scene.ribbon.step_under(scene.h, &scene.floor);
        ours.take(report.iterations, 1, start.elapsed().as_secs_f64());
    }
    [if rebuild { seed.text() } else { "-".into() }, ours.text()]
}

fn table(
    what: &'static str,
    seed: &'static str,
    [rebuilt, ours]: [String; 2],
    note: &'static str,
) -> Claim {
    Claim { what, seed, rebuilt, ours, note }
}

/// All rows.
///
/// # Errors
///
/// None for these numbers: as the scenes.
pub fn claims() -> Result<Vec<Claim>, SpecError> {
    let stop = "a step: time, inner/outer iterations; rebuilt as L-BFGS-B that stops at a relative fall of 1e7 spacings";
    let loops = "its loop rows are not rebuilt; ours is one of the nine, free, without contact";
    Ok(vec![
        table("Ribbon: extreme torsion, 50", "15 ms, 270/1", play(torsion(0.05)?, true), stop),
        table(
            "Ribbon: extreme dragging, ring of 50",
            "30 ms, 432/4",
            play(loop_of(Closure::Ring, 1e3)?, false),
            "pulled by 1000 N/m to a point a metre away; its loop rows are not rebuilt",
        ),
        table(
            "Ribbon: torsion beside finite elements, 50",
            "60 ms, 110/1; elements 360 and 3000 ms",
            play(torsion(0.1)?, true),
            stop,
        ),
        table("Ribbon: helix, h = 0.01 s", "45 ms, 414/1", play(helix("", 0.01)?, true), stop),
        table("Ribbon: helix, h = 0.05 s", "120 ms, 439/1", play(helix("", 0.05)?, true), stop),
        table("Ribbon: falling, 150", "2120 ms, 981/1", play(fall()?, true), stop),
        table(
            "Ribbon: Möbius chain, 9 of 50",
            "2240 ms, 3417/5",
            play(loop_of(Closure::Moebius, 0.0)?, false),
            loops,
        ),
        consistent()?,
        spinning()?,
        resting()?,
    ])
}

/// Fig. 8: the same helix at two steps.
fn consistent() -> Result<Claim, SpecError> {
    let tip = |h: f64| -> Result<[f64; 3], SpecError> {
        let mut scene = helix("", h)?;
        for _ in 0..scene.steps / 4 {
            scene.ribbon.step(h);
        }
        Ok(end(&scene.ribbon))
    };
    let (fine, coarse) = (tip(0.01)?, tip(0.05)?);
    let apart = (0..3).map(|i| (fine[i] - coarse[i]).powi(2)).sum::<f64>().sqrt();
    Ok(Claim {
        what: "Ribbon: helix after 0.25 s, h = 0.01 against 0.05 s (Fig. 8)",
        seed: "consistent",
        rebuilt: "-".into(),
        ours: format!("tips {:.0} mm apart", 1e3 * apart),
        note: "a metre long; an undamped helix is chaotic, later on the tips have nothing in common",
    })
}

fn end(ribbon: &Long) -> [f64; 3] {
    ribbon.pairs().last().map_or([0.0; 3], |[a, b]| ((a + b) * 0.5).0)
}

/// Fig. 11: what lumped mass does not see.
fn spinning() -> Result<Claim, SpecError> {
    let bent = |mass: Mass| -> Result<f64, SpecError> {
        let mut scene = spin(mass)?;
        for _ in 0..scene.steps {
            scene.ribbon.step(scene.h);
        }
        Ok(scene.ribbon.creases().map(|c| c.psi.abs()).fold(0.0, f64::max))
    };
    let (whole, lumped) = (bent(Mass::Consistent)?, bent(Mass::Lumped)?);
    Ok(Claim {
        what: "Ribbon: spinning about its centreline, sharpest bend after 1 s (Fig. 11)",
        seed: "bends; lumped: none",
        rebuilt: format!("lumped {lumped:.1e} rad"),
        ours: format!("{whole:.2} rad"),
        note: "40 rad/s, bent by a ten-thousandth at first",
    })
}

/// Fig. 13: rest shape of a Möbius band by its number of segments.
fn resting() -> Result<Claim, SpecError> {
    let mut told = Vec::new();
    for segments in [50, 100, 150] {
        let start = Instant::now();
        let (iterations, energy) = rest(segments)?;
        let ms = 1e3 * start.elapsed().as_secs_f64();
        told.push(format!("{segments}: {ms:.1} ms, {iterations} it, U {energy:.3}"));
    }
    Ok(Claim {
        what: "Ribbon: Möbius band to rest, by segments (Fig. 13)",
        seed: "a plot without numbers",
        rebuilt: "-".into(),
        ours: told.join("; "),
        note: "half-width pi/30 of 2 pi, Wunderlich's energy, from a flat ring; Starostin and van der Heijden: U = 5.93",
    })
}

fn rest(segments: usize) -> Result<(u32, f64), SpecError> {
    let mut ribbon = super::scenes::band(segments, Bending::Wunderlich)?;
    let report = ribbon.wind(&super::scenes::start(), &Settings::EXACT);
    let pi = std::f64::consts::PI;
    Ok((report.iterations, 2.0 * report.objective / (ribbon.spec().width_m * pi)))
}
