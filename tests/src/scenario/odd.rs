//! Scenarios 20 and 44: poses that no sheet of paper is in.

use super::lone::lone;
use super::{At, Found};
use crate::posed::Posed;
use crate::random::Pcg;
use dogleaf_core::LoneLeaf;
use dogleaf_core::grid::G11x8;
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::{LeafSpec, PaperSpec, WorldSpec};
use dogleaf_core::step::{Solver, StepReport};

type Spoil<R> = fn(&mut Posed<R, G11x8>);

/// 20: two nodes in one place, an edge of no length, a quad on a line, everything in one point. A book cannot
/// be loaded with a pose, so the solver is handed them.
pub fn poses<R: Real>(at: At) -> Found {
    let spoilt: [(&str, Spoil<R>); 4] = [
        ("two nodes in one place", |p| p.leaf.x.set(5, 3, p.leaf.x.at(7, 5))),
        ("an edge of no length", |p| p.leaf.x.set(5, 3, p.leaf.x.at(5, 4))),
        ("a quad on a line", |p| {
            let (a, b) = (p.leaf.x.at(5, 3), p.leaf.x.at(6, 3));
            p.leaf.x.set(5, 4, a + (b - a) * R::of(0.3));
            p.leaf.x.set(6, 4, a + (b - a) * R::of(0.7));
        }),
        ("everything in one point", |p| {
            for (i, k) in (1..11).flat_map(|i| (0..8).map(move |k| (i, k))) {
                p.leaf.x.set(i, k, V3::zero());
            }
        }),
    ];
    let mut found = Found::default();
    for (name, spoil) in spoilt {
        for seed in 0..3 {
            let mut posed = Posed::<R, G11x8>::curved(&PaperSpec::default(), &mut Pcg::new(seed));
            spoil(&mut posed);
            let mut solver = Box::new(Solver::<R, G11x8>::ZERO);
            let mut report = StepReport::default();
            let settings = at.fidelity.settings();
            solver.step(&posed.sheet, &mut posed.leaf, &posed.ask, &settings, &mut report);
            found.expect(posed.leaf.x.finite(), || format!("{name}: not finite"));
            found.expect(report.cuts <= settings.trials, || format!("{name}: {report:?}"));
            found.figure += f64::from(u32::from(report.status.failed()));
        }
    }
    found
}

/// 44: almost a full turn of curvature is taken, and unrolls as a sheet; more is refused. That the layers of a
/// roll pass through one another is known and not handled.
pub fn roll<R: Real>(at: At) -> Found {
    let world = WorldSpec::default();
    let mut found = Found::default();
    for curl in [-6.0, -4.0, 4.0, 6.0] {
        let spec = LeafSpec { curl_per_m: curl / 0.15, ..LeafSpec::default() };
        let mut leaf = lone::<R, G11x8>(&spec, &world, at);
        for n in 0..240 {
            let report = leaf.step();
            let s = leaf.stretch().max().wide();
            found.figure = found.figure.max(s);
            let sound = leaf.leaf().x.finite() && leaf.leaf().v.finite() && s < 0.6;
            found.expect(sound, || format!("curl {curl}, step {n}: {s:.2} {report:?}"));
            if !sound {
                break;
            }
        }
    }
    for curl in [6.3, -7.0, 60.0, f64::NAN] {
        let spec = LeafSpec { curl_per_m: curl / 0.15, ..LeafSpec::default() };
        let mut leaf = Box::new(LoneLeaf::<R, G11x8>::EMPTY);
        let refused = leaf.open(&spec, &PaperSpec::default(), &world, at.fidelity).is_err();
        found.expect(refused, || format!("a curl of {curl} was taken"));
    }
    found
}
