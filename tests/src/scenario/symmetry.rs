//! Scenarios 5-8: what looks the same behaves the same.

use super::harness::{Pages, Rules, WIDTH, apart, at as with, play_for};
use super::lone::lone;
use super::{At, Found};
use crate::gesture::{Gesture, Scene};
use dogleaf_core::grid::{G11x8, Grid};
use dogleaf_core::hand::Sample;
use dogleaf_core::real::{Real, V3};
use dogleaf_core::scene::{Direction, LeafSpec, WorldSpec};
use dogleaf_core::state::Leaf;

/// Furthest a mirror image may be from its original, page widths.
const MIRRORED: f64 = 1e-5;

/// Places of the nodes, in book order, every so many pictures.
fn places<R: Real>(scene: &Scene, samples: &[Sample], sign: f64) -> (Vec<V3<f64>>, Vec<String>) {
    let mut all = Vec::new();
    let seen = play_for::<R>(scene, samples, &Rules::WILD, |n, book: &mut Pages<R>| {
        if n % 4 == 0
            && let Some(leaf) = book.leaf()
        {
            let nodes = (0..G11x8::NX).flat_map(|i| (0..G11x8::NZ).map(move |k| (i, k)));
            all.extend(nodes.map(|(i, k)| {
                let [x, y, z] = leaf.x.at(i, k).0.map(Real::wide);
                V3([sign * x, y, z])
            }));
        }
    });
    (all, seen.faults)
}

fn mirrored<R: Real>(at: At, gesture: impl Fn(&Scene) -> Vec<Sample>) -> Found {
    let scene = with(&Scene::open_at(320, 120), at);
    let mut other = scene;
    other.book.direction = Direction::Rtl;
    let samples = gesture(&scene);
    let (a, faults) = places::<R>(&scene, &samples, 1.0);
    let (b, _) = places::<R>(&other, &scene.eye().mirror(&samples), -1.0);
    let far = a.iter().zip(&b).map(|(p, q)| (*p - *q).norm() / WIDTH).fold(0.0, f64::max);
    let mut found = Found::within(far, MIRRORED).with(faults);
    found.expect(a.len() == b.len() && !a.is_empty(), || "they end at different times".into());
    found
}

/// 5: straight up from the page, where it may buckle to either side.
pub fn along_normal<R: Real>(at: At) -> Found {
    mirrored::<R>(at, |scene| {
        let eye = scene.eye();
        let press = Gesture::press(eye.page(0.6, 0.0));
        press.to(eye.above(0.6, 0.6, 0.0), 700_000).hold(300_000).up()
    })
}

/// 7: a turn and its mirror image.
pub fn mirror<R: Real>(at: At) -> Found {
    mirrored::<R>(at, |scene| Gesture::corner_turn(&scene.eye(), 5))
}

fn swing<R: Real>(spec: &LeafSpec, gravity: [f64; 3], at: At, steps: u32) -> Leaf<R, G11x8> {
    let world = WorldSpec { gravity, ..WorldSpec::default() };
    let mut leaf = lone::<R, G11x8>(spec, &world, at);
    for _ in 0..steps {
        let _ = leaf.step();
    }
    leaf.leaf().clone()
}

/// 6: a load that is the same at head and tail bends the leaf to a cylinder.
pub fn mid_height<R: Real>(at: At) -> Found {
    let spec = LeafSpec { clamp_angle_deg: 60.0, curl_per_m: 3.0, ..LeafSpec::default() };
    let leaf = swing::<R>(&spec, [0.0, -9.81, 0.0], at, 60);
    let nodes = (0..G11x8::NX).flat_map(|i| (0..G11x8::NZ).map(move |k| (i, k)));
    let far = nodes.map(|(i, k)| {
        let [x, y, z] = leaf.x.at(i, k).0.map(Real::wide);
        let [u, v, w] = leaf.x.at(i, G11x8::NZ - 1 - k).0.map(Real::wide);
        V3([x - u, y - v, z + w]).norm() / WIDTH
    });
    Found::within(far.fold(0.0, f64::max), if size_of::<R>() == 4 { 1e-5 } else { 1e-12 })
}

/// 8: clamp and gravity turned together about the spine. A book has no place in the world that could be moved:
/// its frame is the world's, and only the camera goes about (34).
pub fn turned<R: Real>(at: At) -> Found {
    let (sin, cos) = (0.7f64.sine(), 0.7f64.cosine());
    let about = |[x, y, z]: [f64; 3]| [cos * x - sin * y, sin * x + cos * y, z];
    let level = LeafSpec { curl_per_m: 2.0, ..LeafSpec::default() };
    let leaning = LeafSpec { clamp_angle_deg: 0.7f64.to_degrees(), ..level };
    let gravity = [0.0, -9.81, 0.0];
    let a = swing::<R>(&level, gravity, at, 60);
    let mut b = swing::<R>(&leaning, about(gravity), at, 60);
    for (i, k) in (0..G11x8::NX).flat_map(|i| (0..G11x8::NZ).map(move |k| (i, k))) {
        let [x, y, z] = b.x.at(i, k).0.map(Real::wide);
        b.x.set(i, k, V3([cos * x + sin * y, cos * y - sin * x, z].map(R::of)));
    }
    Found::within(apart(Some(&a), Some(&b)), 1e-4)
}
