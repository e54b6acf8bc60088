//! Promise: chains of closed ribbons fall, hang in one another and come to lie, and none passes through another.

use dogleaf_core::effect::ribbon::Closure;
use dogleaf_core::effect::ribbon::contact::step_all;
use dogleaf_tests::chains::{Link, all_crossings, around, chain, energy, links};
use std::time::Instant;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];

/// Plays steps of ten milliseconds; after every one nothing crosses, all are linked as they were, and no energy has come
/// from anywhere. Answers the energy of motion that is left, as a share of all there was.
fn play(name: &str, mut chain: Vec<Link>, steps: usize) -> f64 {
    let (mut around, linked) = (around(), links(&chain));
    assert_eq!(all_crossings(&chain), 0, "{name}: nothing crosses at the start");
    let first: f64 = energy(&chain, &mut around).iter().sum();
    let (mut before, mut left, mut grew, mut most, mut iterations) =
        (first, 0.0, 0.0_f64, [0; 4], 0);
    let (mut ends, mut clock) = ([0; 4], 0.0);
    for k in 0..steps {
        let start = Instant::now();
        let s = step_all(&mut chain, 0.01, &mut around);
        clock += start.elapsed().as_secs_f64();
        iterations += s.iterations;
        for (sum, x) in ends.iter_mut().zip([s.converged, s.capped, s.stalled, s.held]) {
            *sum += x;
        }
        for (m, x) in most.iter_mut().zip([s.pairs, s.others, s.limited, s.crowded]) {
            *m = x.max(*m);
        }
        let parts = energy(&chain, &mut around);
        let now: f64 = parts.iter().sum();
        (grew, left) = (grew.max((now - before) / first), parts[0] / first);
        before = now;
        assert_eq!(all_crossings(&chain), 0, "{name}, step {k}: something passed through");
        assert_eq!(links(&chain), linked, "{name}, step {k}: a link was lost or made");
        assert!(s.gap < 1e-5, "{name}, step {k}: a loop is open by {}", s.gap);
        assert_eq!((s.held, s.crowded), (0, 0), "{name}, step {k}: {s:?}");
    }
    println!(
        "{name}: {:.1} ms a step, {:.1} iterations a link; converged, capped, stalled, held {ends:?}; \
         most pairs, near, limited, crowded {most:?}; energy grew by {grew:.1e} at most, {left:.1e} moves at the end",
        1e3 * clock / steps as f64,
        f64::from(iterations) / (steps * chain.len()) as f64,
    );
    assert!(grew <= 1e-9, "{name}: energy came from nowhere, {grew} of all in one step");
    left
}

#[test]
fn a_short_chain_falls() {
    play("rings, 3", chain(Closure::Ring, 3, [0.0, 0.0, 0.4], X), 100);
    play("bands, 3", chain(Closure::Moebius, 3, [0.0, 0.0, 0.4], X), 100);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "minutes")]
fn nine_bands_fall() {
    let left = play("Moebius chain", chain(Closure::Moebius, 9, [0.0, 0.0, 0.4], X), 300);
    assert!(left < 1e-3, "it comes to lie: {left}");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "minutes")]
fn two_chains_of_nine_fall_on_each_other() {
    let mut both = chain(Closure::Ring, 9, [-0.92, 0.0, 0.3], X);
    both.extend(chain(Closure::Ring, 9, [0.1, -0.92, 0.8], Y));
    let left = play("double chain", both, 300);
    assert!(left < 1e-3, "they come to lie: {left}");
}
