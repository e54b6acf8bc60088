//! Hands that mean no good: every way to lead a leaf that a screen can report.

use super::draw::{log_within, one_of, percent};
use crate::gesture::{Eye, Gesture, Rng, TOUCH_US};
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::real::Real;

/// A way to lead a leaf: from a press to where it is let go.
type Hand = fn(&mut Rng, &Eye, Gesture) -> Gesture;

/// Every hand, with the name it is reported under.
pub const HANDS: [(&str, Hand); 11] = [
    ("turn", turn),
    ("flick", flick),
    ("wander", wander),
    ("scribble", scribble),
    ("teleports", teleports),
    ("shake", shake),
    ("far", far),
    ("under", under),
    ("brink", brink),
    ("along", along),
    ("hold", hold),
];

/// A gesture of one pointer, or of several; answers the hand's name with it.
pub fn gesture(rng: &mut Rng, eye: &Eye) -> (&'static str, Vec<Sample>) {
    let (name, hand) = one_of(rng, &HANDS);
    let side = one_of(rng, &[1.0, -1.0]);
    let from = eye.page(side * rng.within(0.2, 1.0), rng.within(-1.0, 1.0));
    let leaves = if percent(rng, 20) { one_of(rng, &[0, 2, 5, 20, u16::MAX]) } else { 1 };
    let led = hand(rng, eye, Gesture::press_stack(from, leaves));
    let samples = if percent(rng, 12) { led.cancel() } else { led.up() };
    (name, spoil(rng, eye, samples))
}

/// Fingers that do not keep to the rules, and a screen that does not report all they do.
fn spoil(rng: &mut Rng, eye: &Eye, mut samples: Vec<Sample>) -> Vec<Sample> {
    match rng.bits() % 10 {
        0 => samples = samples.iter().flat_map(|&s| [s, s]).collect(),
        1 => {
            let lost = rng.bits() % 95;
            samples.retain(|s| s.phase != Phase::Move || !percent(rng, lost));
        }
        2 => samples.iter_mut().for_each(|s| s.t_us = s.t_us / 50_000 * 50_000),
        3 => {
            let at = eye.page(rng.within(-1.0, 1.0), rng.within(-1.0, 1.0));
            let other = Gesture::press(at).by(1, (rng.within(0.0, 1.0) * 1e6) as u64);
            samples.extend(wander(rng, eye, other).up());
            samples.sort_by_key(|s| s.t_us);
        }
        _ => {}
    }
    samples
}

fn anywhere(rng: &mut Rng, eye: &Eye) -> [f64; 2] {
    eye.above(rng.within(-1.4, 1.4), rng.within(-0.2, 0.9), rng.within(-1.3, 1.3))
}
fn us(rng: &mut Rng, least_s: f64, most_s: f64) -> u64 {
    (log_within(rng, least_s, most_s) * 1e6) as u64
}

/// Over the spine, in a tenth of a second or in five.
fn turn(rng: &mut Rng, eye: &Eye, g: Gesture) -> Gesture {
    let (across, z) = (rng.within(-1.0, 1.0).signum(), rng.within(-1.0, 1.0));
    let end = eye.above(across * rng.within(0.3, 1.0), rng.within(0.0, 0.3), z);
    let time = us(rng, 0.1, 5.0);
    g.to(end, time)
}

fn flick(rng: &mut Rng, eye: &Eye, g: Gesture) -> Gesture {
    let end = anywhere(rng, eye);
    let time = us(rng, 0.02, 0.2);
    g.to(end, time)
}

fn wander(rng: &mut Rng, eye: &Eye, mut g: Gesture) -> Gesture {
    for _ in 0..3 + rng.bits() % 12 {
        let end = anywhere(rng, eye);
        let time = us(rng, 0.03, 0.6);
        g = g.to(end, time);
    }
    g
}

/// Circles of any size, up to twenty-five a second.
fn scribble(rng: &mut Rng, eye: &Eye, g: Gesture) -> Gesture {
    let (centre, edge) = (anywhere(rng, eye), anywhere(rng, eye));
    let (rate, seconds) = (rng.within(1.0, 25.0), rng.within(1.0, 5.0));
    let radius = [0, 1].map(|c: usize| edge[c] - centre[c]);
    g.along((seconds * 1e6) as u64, |t| {
        let angle = core::f64::consts::TAU * rate * seconds * t;
        [centre[0] + radius[0] * angle.cosine(), centre[1] + radius[1] * angle.sine()]
    })
}

/// From corner to corner in no time.
fn teleports(rng: &mut Rng, eye: &Eye, mut g: Gesture) -> Gesture {
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].map(|(x, z)| eye.page(x, z));
    for _ in 0..60 + rng.bits() % 240 {
        g = g.to(one_of(rng, &corners), TOUCH_US);
    }
    g
}

/// Up and back, up and back.
fn shake(rng: &mut Rng, eye: &Eye, mut g: Gesture) -> Gesture {
    let ends = [anywhere(rng, eye), anywhere(rng, eye)];
    let time = us(rng, 0.02, 0.3);
    for n in 0..10 + (rng.bits() % 30) as usize {
        g = g.to(ends[n % 2], time);
    }
    g
}

/// Far beyond the screen, and at the ends of the numbers.
fn far(rng: &mut Rng, eye: &Eye, mut g: Gesture) -> Gesture {
    for _ in 0..4 + rng.bits() % 8 {
        let size = log_within(rng, 1e3, 8e6);
        let end = [rng.within(-size, size), rng.within(-size, size)];
        let time = us(rng, 0.01, 0.4);
        g = g.to(end, time);
    }
    let end = anywhere(rng, eye);
    g.to(end, 100_000)
}

/// Below the table, through the other block, behind the spine.
fn under(rng: &mut Rng, eye: &Eye, mut g: Gesture) -> Gesture {
    for _ in 0..2 + rng.bits() % 4 {
        let end = eye.above(rng.within(-1.2, 1.2), rng.within(-1.5, -0.1), rng.within(-3.0, 1.2));
        let time = us(rng, 0.1, 1.0);
        g = g.to(end, time);
    }
    g
}

/// Held upright over the spine, and let go there.
fn brink(rng: &mut Rng, eye: &Eye, g: Gesture) -> Gesture {
    let end = eye.above(rng.within(-0.02, 0.02), rng.within(0.6, 0.9), rng.within(-1.0, 1.0));
    let time = us(rng, 0.3, 1.5);
    let wait = us(rng, 0.2, 2.0);
    g.to(end, time).hold(wait)
}

/// Along the spine, from head to tail.
fn along(rng: &mut Rng, eye: &Eye, mut g: Gesture) -> Gesture {
    let across = rng.within(-0.8, 0.8);
    for n in 0..3 + rng.bits() % 6 {
        let way = if n % 2 == 0 { 1.5 } else { -1.5 };
        let end = eye.above(across, rng.within(0.0, 0.5), way);
        let time = us(rng, 0.05, 0.8);
        g = g.to(end, time);
    }
    g
}

fn hold(rng: &mut Rng, eye: &Eye, g: Gesture) -> Gesture {
    let end = anywhere(rng, eye);
    let time = us(rng, 0.05, 1.0);
    let wait = us(rng, 0.5, 6.0);
    g.to(end, time).hold(wait)
}
