//! Promise: the hand asks of the sheet only what a sheet can do, takes the node the finger is nearest
//! to, and a camera that sees nothing is refused.

use dogleaf_core::grid::{G6x5, G11x8, G16x12, Grid};
use dogleaf_core::hand::pick::pick;
use dogleaf_core::hand::tent::Tent;
use dogleaf_core::hand::view::Ray;
use dogleaf_core::hand::{Camera, Guide, Phase, Place, Reach, Sample, View};
use dogleaf_core::real::V3;
use dogleaf_core::scene::{PaperSpec, SpecError, Units};
use dogleaf_core::state::{Field, Leaf};
use dogleaf_tests::posed::Posed;
use dogleaf_tests::random::Pcg;

/// Tents drawn at random.
const TENTS: usize = 200;
/// Places asked of each.
const PLACES: usize = 400;

/// A tent over blocks that leave its foot within the arc of the sheet.
fn tent(random: &mut Pcg) -> Tent<f64> {
    let radius = random.within(2.0, 12.0);
    let floor = |r: &mut Pcg| r.within(0.0, 0.3 * radius);
    Tent {
        root: random.within(-2.0, 2.0),
        radius,
        floor: [floor(random), floor(random)],
        ends: [random.within(0.5, 16.0), random.within(0.5, 16.0)],
        lain: V3([0.0; 3]),
    }
}

/// Evenly over the tent and beyond its feet.
fn places(tent: &Tent<f64>) -> impl Iterator<Item = f64> + use<> {
    let reach = tent.reach(1.0);
    (0..=PLACES).map(move |n| 1.2 * reach * (2.0 * n as f64 / PLACES as f64 - 1.0))
}

fn over_all_tents(check: impl Fn(&Tent<f64>)) {
    let mut random = Pcg::new(70);
    (0..TENTS).for_each(|_| check(&tent(&mut random)));
}

/// How far the ends of the spine are from a target, as shares of what the sheet spans between them.
fn drawn(tent: &Tent<f64>, x: f64, dz: f64) -> [f64; 2] {
    let across_sq = x * x + tent.height(x) * tent.height(x);
    let [tail, head] = tent.ends;
    let share = |now: f64, end: f64| {
        ((across_sq + now * now) / (tent.radius * tent.radius + end * end)).sqrt()
    };
    [share(tail - dz, tail), share(head + dz, head)]
}

#[test]
fn a_target_lies_within_the_rope_to_both_ends_of_the_spine() {
    over_all_tents(|tent| {
        for x in places(tent).filter(|x| x.abs() <= tent.reach(*x)) {
            let [tail, head] = tent.sideways(x, tent.height(x));
            for dz in [0.0, tail, -head, 0.5 * tail, -0.5 * head] {
                let [to_tail, to_head] = drawn(tent, x, dz);
                assert!(to_tail <= 1.0 && to_head <= 1.0, "{tent:?} at {x}, {dz}");
            }
        }
    });
}

/// Near the gutter of a thick book the top of a block is higher than the node is far from the spine.
#[test]
fn a_target_on_a_thick_block_lies_within_the_rope_too() {
    for thickness in [0.3, 0.4, 0.7, 1.0, 3.0] {
        let tent = Tent {
            root: 0.0,
            radius: 3.6,
            floor: [3.6 * thickness; 2],
            ends: [8.0; 2],
            lain: V3([0.0; 3]),
        };
        for x in places(&tent).filter(|x| x.abs() <= tent.reach(*x)) {
            let [to_tail, to_head] = drawn(&tent, x, 0.0);
            assert!(to_tail <= 1.0 && to_head <= 1.0, "{tent:?} at {x}: {to_tail}");
        }
    }
}

#[test]
fn a_target_beyond_the_rope_is_caught() {
    let mut random = Pcg::new(71);
    let tent = tent(&mut random);
    let [tail, _] = tent.sideways(0.0, tent.height(0.0));
    let far = drawn(&tent, 0.0, tail + tent.radius);
    assert!(far.iter().any(|share| *share > 1.0));
}

#[test]
fn a_target_may_stray_along_the_binding_where_the_sheet_is_slack() {
    over_all_tents(|tent| {
        let square = Tent { ends: [tent.radius, 0.5 * tent.radius], ..*tent };
        let [tail, head] = square.sideways(0.0, square.height(0.0));
        assert!(tail > 0.0 && head > 0.0, "{tent:?}");
        assert!(tail < tent.radius && head < tent.radius, "{tent:?}");
    });
}

#[test]
fn the_tent_is_continuous() {
    over_all_tents(|tent| {
        let step = 1e-3 * tent.reach(1.0);
        let steps: Vec<f64> = (-1200..1200).map(|n| f64::from(n) * step).collect();
        // A root may be steep, but it grows no faster than the root of what is under it.
        let steep = (8.0 * tent.radius * step).sqrt();
        for w in steps.windows(2) {
            let rise = (tent.height(w[1]) - tent.height(w[0])).abs();
            let at = |x: f64| tent.sideways(x, tent.height(x));
            let stray = |n: usize| (at(w[1])[n] - at(w[0])[n]).abs();
            assert!(rise < 1.5 * step, "{tent:?} at {}", w[0]);
            assert!(stray(0).max(stray(1)) < steep, "{tent:?} at {}", w[0]);
        }
    });
}

#[test]
fn the_tent_rises_from_the_blocks_to_its_peak_over_the_binding() {
    over_all_tents(|tent| {
        let reach = tent.reach(1.0);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-9;
        assert!(close(tent.height(-reach), tent.floor[0]), "{tent:?}");
        assert!(close(tent.height(reach), tent.floor[1]), "{tent:?}");
        assert!(places(tent).all(|x| tent.height(x) <= tent.height(0.0)), "{tent:?}");
        assert!(tent.height(0.0) > 0.5 * tent.radius && tent.height(0.0) < tent.radius);
    });
}

#[test]
fn a_tent_and_its_mirror_image_are_the_same_to_the_last_bit() {
    over_all_tents(|tent| {
        let (mut mirror, mut turned) = (*tent, *tent);
        mirror.floor.reverse();
        turned.ends.reverse();
        for x in places(tent).filter(|x| *x != 0.0) {
            assert_eq!(tent.height(x).to_bits(), mirror.height(-x).to_bits());
            let [tail, head] = tent.sideways(x, tent.height(x));
            assert_eq!(turned.sideways(x, turned.height(x)), [head, tail]);
        }
    });
}

fn camera() -> Camera<f64> {
    View::reading(0.13, 0.20, 960, 720).camera(&Units { metres: 0.13 / 12.0, kilograms: 0.002 })
}

/// Where a guide wants its node after a drag to a place of the screen.
fn wanted(tent: &Tent<f64>, node_z: f64, [x, y]: [i32; 2], firm: bool) -> V3<f64> {
    let origin = V3([tent.root + 0.9 * tent.radius, tent.floor[1], node_z]);
    let tent = Tent { lain: origin, ..*tent };
    let reach = Reach { tent, camera: camera(), aside: V3([0.0; 3]), firm };
    let seen = camera().project(origin).expect("in front of the eye");
    let [px, py] = seen.map(|p| (p * 256.0) as i32);
    let finger = |phase, x, y| Sample { t_us: 8000, id: 0, phase, x, y, leaves: 0 };
    let place = Place::at((9, 1));
    let mut guide = Guide::take(&finger(Phase::Down, px, py), (9, 1), place, origin, &reach);
    let _ = guide.drag(&finger(Phase::Move, x, y), &reach);
    let mut at = origin;
    // The leash lets it come two units nearer each time.
    (0..100).for_each(|_| at = guide.advance(at, &reach, 0.0, 0.01, 0.0).target);
    at
}

#[test]
fn wherever_the_finger_goes_the_target_stays_within_the_rope() {
    let mut random = Pcg::new(72);
    for _ in 0..TENTS {
        let (tent, z) = (tent(&mut random), random.within(-4.0, 4.0));
        let any = |r: &mut Pcg| r.word() as i32 >> r.below(24);
        for (x, y) in [(any(&mut random), any(&mut random)), (i32::MIN, i32::MAX)] {
            for firm in [true, false] {
                let at = wanted(&tent, z, [x, y], firm);
                let [to_tail, to_head] = drawn(&tent, at.0[0] - tent.root, at.0[2] - z);
                assert!(
                    to_tail <= 1.0 && to_head <= 1.0,
                    "{tent:?}: {at:?} for ({x}, {y}), {firm}"
                );
            }
        }
    }
}

#[test]
fn a_target_follows_the_finger_across() {
    let tent =
        Tent { root: 0.0, radius: 10.0, floor: [0.5; 2], ends: [8.0; 2], lain: V3([0.0; 3]) };
    for firm in [true, false] {
        let at = |n: i32| wanted(&tent, 0.0, [n * 120 * 256, 400 * 256], firm).0[0];
        let across: Vec<f64> = (1..8).map(at).collect();
        let limit = |x: f64| x.abs() >= tent.reach(x);
        assert!(across.windows(2).all(|w| w[0] < w[1] || limit(w[1])), "{across:?}");
    }
}

fn posed<G: Grid>(random: &mut Pcg) -> Leaf<f64, G> {
    Posed::curved(&PaperSpec::default(), random).leaf
}

fn ray(random: &mut Pcg) -> Ray<f64> {
    let eye = V3([random.within(-10.0, 20.0), random.within(5.0, 40.0), random.within(-9.0, 30.0)]);
    let target = V3([random.within(-2.0, 14.0), 0.0, random.within(-9.0, 9.0)]);
    Ray { from: eye, along: target - eye }
}

/// One segment in from fore-edge, tail or head, and a quarter of the width from the spine.
fn holdable<G: Grid>((i, k): (usize, usize)) -> bool {
    let inner = i < G::NX - 1 && k > 0 && k < G::NZ - 1;
    let ring = i == G::NX - 2 || k == 1 || k == G::NZ - 2;
    inner && ring && 4 * i >= G::NX
}

fn picks_the_nearest<G: Grid>() {
    let mut random = Pcg::new(73);
    for _ in 0..TENTS {
        let (leaf, ray) = (posed::<G>(&mut random), ray(&mut random));
        let (node, distance_sq) = pick(&leaf, &ray);
        assert!(holdable::<G>(node), "{node:?} is one segment in from the border");
        let own = ray.distance_sq(leaf.x.at(node.0, node.1));
        assert_eq!(distance_sq, own, "{node:?} at its own distance");
        let nodes = Field::<f64, G>::nodes().filter(|n| holdable::<G>(*n));
        let least = nodes.map(|(i, k)| ray.distance_sq(leaf.x.at(i, k))).fold(1e30, f64::min);
        assert_eq!(distance_sq, least, "{node:?} is the nearest");
    }
}

#[test]
fn the_node_picked_is_one_in_from_the_border_and_the_nearest_to_the_ray() {
    picks_the_nearest::<G6x5>();
    picks_the_nearest::<G11x8>();
    picks_the_nearest::<G16x12>();
}

#[test]
fn a_ray_through_a_node_picks_it() {
    let leaf = posed::<G11x8>(&mut Pcg::new(74));
    for node in Field::<f64, G11x8>::nodes().filter(|n| holdable::<G11x8>(*n)) {
        let eye = V3([3.0, 40.0, 9.0]);
        let ray = Ray { from: eye, along: leaf.x.at(node.0, node.1) - eye };
        assert_eq!(pick(&leaf, &ray).0, node);
    }
}

#[test]
fn a_ray_of_nothing_or_nan_still_picks_a_node_that_can_be_held() {
    let leaf = posed::<G11x8>(&mut Pcg::new(75));
    for bad in [0.0, f64::NAN, f64::INFINITY] {
        let ray = Ray { from: V3([bad; 3]), along: V3([bad; 3]) };
        assert!(holdable::<G11x8>(pick(&leaf, &ray).0), "{bad}");
    }
}

#[test]
fn a_ray_meets_the_plane_in_front_of_it() {
    let ray = Ray { from: V3([1.0, 10.0, 2.0]), along: V3([0.5, -2.0, 0.0]) };
    let up = V3([0.0, 1.0, 0.0]);
    assert_eq!(ray.meet(V3([7.0, 2.0, 7.0]), up), Some(V3([3.0, 2.0, 2.0])));
    assert_eq!(ray.meet(V3([7.0, 12.0, 7.0]), up), None, "behind the eye");
}

#[test]
fn a_ray_along_a_plane_or_without_a_direction_meets_nothing() {
    let up = V3([0.0, 1.0, 0.0]);
    for along in [[1.0, 0.0, 0.0], [0.0; 3], [1.0, 1e-9, 0.0], [f64::NAN; 3]] {
        let ray = Ray { from: V3([0.0, 5.0, 0.0]), along: V3(along) };
        assert_eq!(ray.meet(V3::zero(), up), None, "{along:?}");
        assert_eq!(ray.meet(V3::zero(), V3([f64::NAN; 3])), None, "a plane of NaN");
    }
}

#[test]
fn what_is_seen_at_a_place_lies_on_the_ray_through_it() {
    let mut random = Pcg::new(76);
    for _ in 0..1000 {
        let p = random.v3() * 12.0;
        let seen = camera().project(p).expect("in front of the eye");
        let [x, y] = seen.map(|v| (v * 256.0).round() as i32);
        // Half a 256th of a pixel, at the distance of the point.
        let far = (p - camera().eye).norm() / camera().focal / 256.0;
        assert!(camera().ray(x, y).distance_sq(p).sqrt() < far, "{p:?}");
    }
}

#[test]
fn what_lies_behind_the_eye_is_not_seen() {
    let c = camera();
    assert_eq!(c.project(c.eye - c.forward), None);
    assert_eq!(c.project(c.eye), None);
}

#[test]
fn the_picture_is_upright_and_not_mirrored() {
    let at = |p: [f64; 3]| camera().project(V3(p)).expect("in front of the eye");
    assert!(at([1.0, 0.0, 0.0])[0] > at([-1.0, 0.0, 0.0])[0], "right is right");
    assert!(at([0.0, 0.0, -5.0])[1] < at([0.0, 0.0, 5.0])[1], "the head is at the top");
    assert!(at([0.0, 1.0, 0.0])[1] < at([0.0, 0.0, 0.0])[1], "up is up");
}

#[test]
fn a_camera_that_sees_nothing_is_refused() {
    let view = View::reading(0.13, 0.20, 960, 720);
    let [x, y, z] = view.target_m;
    let blind = [
        View { eye_m: view.target_m, ..view },
        View { eye_m: [x, y + 0.5, z - 0.0005], ..view },
        View { fov_y_deg: 0.9, ..view },
        View { fov_y_deg: 151.0, ..view },
        View { width_px: 0, ..view },
        View { height_px: 16_385, ..view },
    ];
    for view in blind {
        assert_eq!(view.check(), Err(SpecError::OutOfRange("view")), "{view:?}");
    }
}

#[test]
fn a_camera_that_looks_along_an_axis_sees() {
    let view = View::reading(0.13, 0.20, 960, 720);
    let [x, y, z] = view.target_m;
    for eye_m in [[x + 0.5, y, z], [x, y + 0.5, z], [x, y, z + 0.5], [x, y - 0.5, z]] {
        let view = View { eye_m, ..view };
        assert_eq!(view.check(), Ok(()), "{view:?}");
        let camera = view.camera::<f64>(&Units { metres: 1.0, kilograms: 1.0 });
        let square = [camera.right.dot(camera.up), camera.right.dot(camera.forward)];
        assert!(square.iter().all(|c| c.abs() < 1e-12), "{camera:?}");
        assert_eq!(camera.project(V3(view.target_m)), Some(camera.centre), "{view:?}");
    }
}
