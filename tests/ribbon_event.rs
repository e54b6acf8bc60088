//! Promise: who asks hears when a ribbon touches and how fast, and when it snaps; who does not ask gets the same bits.

use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near};
use dogleaf_core::effect::ribbon::event::{Ear, Sound, step_all_heard};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::{Ribbon, RibbonSpec, Root};
use dogleaf_core::real::V3;
use dogleaf_tests::ribbons::{open, spec, twist};

/// Rate at which the fall's velocities fade, so that it comes to lie.
const DAMPING: f64 = 2.0;

type Strip = Ribbon<f64, 20>;
type Floor = Near<f64, HalfSpace<f64>, 20, 64, 512>;

/// A free stiff strip of twenty segments, flat, its front up, at a height and a velocity along Z.
fn flat(height: f64, speed: f64, damping_per_s: f64) -> Box<Strip> {
    let stiff = RibbonSpec {
        root: Root::Free,
        rigidity_nm: 0.5,
        perturbation: 0.0,
        damping_per_s,
        ..spec(20)
    };
    let mut strip = open::<f64, 20>(&stiff);
    strip.lay(&Frame::at(V3([0.0, 0.0, height])), |_| Crease::default());
    strip.launch(|_| V3([0.0, 0.0, speed]));
    strip
}

fn floor(height: f64) -> Box<Floor> {
    let ground = HalfSpace { point: V3([0.0, 0.0, height]), normal: V3([0.0, 0.0, 1.0]) };
    Box::new(Near::over(ground, Cushion::default()))
}

/// A fall from twenty centimetres on a floor: every step's sound, and the hash at the end.
fn fall(mut floor: Box<Floor>, heard: bool) -> (Vec<Sound<f64>>, u64) {
    let (mut strip, mut ear) = (flat(0.2, 0.0, DAMPING), Box::new(Ear::<f64, 20>::NEW));
    strip.gravity = [0.0, 0.0, -9.81];
    let mut sounds = Vec::new();
    for _ in 0..200 {
        floor.begin(&strip, 0.005);
        if heard {
            sounds.push(ear.step(&mut strip, 0.005, &(), &mut *floor).1);
        } else {
            strip.step_touching(0.005, &(), &mut *floor);
        }
    }
    (sounds, strip.state_hash())
}

#[test]
fn a_fall_is_heard_once_as_fast_as_it_fell() {
    let (sounds, _) = fall(floor(0.0), true);
    let first = sounds.iter().position(|s| s.touches > 0).expect("it is heard");
    let Sound { touches, speed, .. } = sounds[first];
    let flight = 0.005 * first as f64;
    let fallen = 9.81 / DAMPING * (1.0 - (-DAMPING * flight).exp());
    println!("step {first}: {touches} vertices at {speed:.3} m/s; a stone has {fallen:.3}");
    assert!((speed - fallen).abs() <= 0.02, "{speed} against {fallen}");
    assert_eq!(touches, 42, "a flat strip lands on all its vertices");
    assert!((0.19..=0.22).contains(&flight), "when it lands: {flight} s");
    let loudest = sounds.iter().skip(first + 1).map(|s| s.speed).fold(0.0, f64::max);
    assert!(loudest < 0.5 * speed, "{loudest} afterwards");
    assert!(sounds[150..].iter().all(|s| s.touches == 0), "what lies is silent");
}

#[test]
fn without_a_floor_nothing_is_heard() {
    let (sounds, _) = fall(floor(-100.0), true);
    assert!(sounds.iter().all(|s| *s == Sound::default()), "a fall through nothing is silent");
}

#[test]
fn to_be_heard_changes_nothing() {
    assert_eq!(fall(floor(0.0), true).1, fall(floor(0.0), false).1);
}

/// The loudest that is heard of two strips, the upper one twice as fast downwards or up.
fn two(upper: f64) -> Vec<Sound<f64>> {
    let mut strips = vec![*flat(0.0, -5.0, 0.0), *flat(0.01, upper, 0.0)];
    let mut ears = vec![Ear::<f64, 20>::NEW; 2];
    let mut near = Box::new(Near::<f64, (), 20, 64, 4096>::over((), Cushion::default()));
    let mut heard = vec![Sound::default(); 2];
    for _ in 0..10 {
        let all = step_all_heard(&mut strips, 0.005, &mut near, &mut ears, |i, s| {
            heard[i].touches += s.touches;
            heard[i].speed = s.speed.max(heard[i].speed);
        });
        assert_eq!((all.held, all.crowded), (0, 0), "{all:?}");
    }
    heard
}

#[test]
fn of_two_that_fall_together_only_their_meeting_is_heard() {
    let loudest = |heard: &[Sound<f64>]| heard.iter().map(|s| s.speed).fold(0.0, f64::max);
    let heard = two(-5.5);
    println!("{heard:?}");
    assert!((loudest(&heard) - 0.5).abs() <= 0.01, "{heard:?}");
    assert!(heard.iter().any(|s| s.touches >= 40), "{heard:?}");
    assert_eq!(loudest(&two(-5.0)), 0.0, "side by side they never meet");
}

/// A clamped strip whose end is bent back by a guide, which lets go over some steps: the sum of the snaps that are
/// heard, and the bending energy that there was.
fn let_go(steps: u32) -> (f64, f64) {
    let clamped = RibbonSpec { rigidity_nm: 0.05, damping_per_s: 2.0, ..spec(20) };
    let mut strip = open::<f64, 20>(&clamped);
    let mut ear = Box::new(Ear::<f64, 20>::NEW);
    for k in 1..=200 {
        twist(&mut strip, 0.0, 1.0);
        // About Y: the end's normal leans back along the strip.
        let angle = 2.0 * f64::from(k) / 200.0;
        strip.ask.guides[0].normal = V3([-angle.sin(), 0.0, angle.cos()]);
        strip.step(0.01);
    }
    let stored = strip.energy().bending;
    let mut snaps = 0.0;
    for k in 0..200 {
        let stiffness = 1.0 - f64::from(k + 1) / f64::from(steps);
        if stiffness <= 0.0 {
            strip.ask.guides.clear();
        } else {
            let angle = 2.0 * stiffness;
            strip.ask.guides[0].normal = V3([-angle.sin(), 0.0, angle.cos()]);
        }
        snaps += ear.step(&mut strip, 0.01, &(), &mut ()).1.snap;
    }
    println!("let go in {steps} steps: {stored:.2e} J were stored, {snaps:.2e} J snapped");
    (snaps, stored)
}

#[test]
fn what_is_let_go_at_once_snaps() {
    let (snaps, stored) = let_go(1);
    assert!(snaps > 0.25 * stored && snaps < 2.0 * stored, "{snaps} of {stored}");
    let (snaps, stored) = let_go(200);
    assert!(snaps == 0.0 && stored > 0.0, "slowly, {snaps} of {stored}");
}
