//! Promise: contact pushes with the slope and the curvature of its energy, distances are distances, and no way that was
//! called free leads through anything.

use dogleaf_core::effect::ribbon::contact::distance::{Meeting, Parts, Quad, apart, meetings};
use dogleaf_core::effect::ribbon::contact::push::barrier;
use dogleaf_core::effect::ribbon::contact::surface::{Field, HalfSpace, Surface};
use dogleaf_core::effect::ribbon::contact::{Cushion, Near, Touch, advance, step_all};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::{Ribbon, RibbonSpec, Root, Status};
use dogleaf_core::real::V3;
use dogleaf_tests::chains::cross;
use dogleaf_tests::random::Pcg;
use dogleaf_tests::ribbons::{finite, open, spec, start, stretch};

const FLOOR: HalfSpace<f64> = HalfSpace { point: V3([0.0; 3]), normal: V3([0.0, 0.0, 1.0]) };

#[test]
fn a_barriers_derivatives_are_differences() {
    let cushion = Cushion::default();
    for k in 1..200 {
        let d = 2.1e-3 * f64::from(k) / 200.0 - 1e-4;
        let h = 1e-3 * d.abs().min((d - 2e-3).abs()).min((d - 1e-4).abs());
        let f = |k: f64, i: usize| barrier(&cushion, d + k * h, 0.05)[i];
        let [_, slope, curve] = barrier(&cushion, d, 0.05);
        let difference = |i| (8.0 * (f(1.0, i) - f(-1.0, i)) - f(2.0, i) + f(-2.0, i)) / (12.0 * h);
        assert!((difference(0) - slope).abs() <= 1e-6 * slope.abs(), "slope at {d}");
        assert!((difference(1) - curve).abs() <= 1e-6 * curve.abs(), "curvature at {d}");
        assert!(slope <= 0.0 && curve >= 0.0, "it pushes, and harder the nearer: {d}");
    }
    assert_eq!(barrier(&cushion, 2e-3, 0.05), [0.0; 3], "and not from afar");
}

/// A flat trapezoid somewhere.
fn quad(random: &mut Pcg) -> Quad<f64> {
    let (p, t, n) = (random.v3(), random.v3(), random.v3());
    let t = t * (1.0 / t.norm());
    let b = n.cross(t) * (1.0 / n.cross(t).norm());
    let [c, d] = [random.within(-0.4, 0.4), random.within(-0.4, 0.4)];
    let at = |x: f64, y: f64| p + t * x + b * y;
    [at(-0.5 * c, -0.5), at(0.5 * c, 0.5), at(1.0 - 0.5 * d, -0.5), at(1.0 + 0.5 * d, 0.5)]
}

fn crossed([a, b, c, d]: &Quad<f64>, [e, f, g, h]: &Quad<f64>) -> bool {
    let there = [[*e, *f, *g], [*f, *h, *g]];
    [[*a, *b, *c], [*b, *d, *c]].iter().any(|s| there.iter().any(|t| cross(s, t)))
}

/// A point of a quadrilateral, by shares along it and across.
fn point([a, b, c, d]: &Quad<f64>, x: f64, y: f64) -> V3<f64> {
    (*a * (1.0 - y) + *b * y) * (1.0 - x) + (*c * (1.0 - y) + *d * y) * x
}

#[test]
fn distances_are_those_of_the_nearest_of_many_points() {
    let mut random = Pcg::new(3);
    for case in 0..200 {
        let (a, b) = (quad(&mut random), quad(&mut random));
        if crossed(&a, &b) {
            continue;
        }
        let found = apart(&a, &b);
        let steps = || (0..=12).map(|k| f64::from(k) / 12.0);
        let many = |q: &Quad<f64>| -> Vec<_> {
            steps()
                .flat_map(|x| steps().map(move |y| (x, y)))
                .map(|(x, y)| point(q, x, y))
                .collect()
        };
        let (p, q) = (many(&a), many(&b));
        let least = p.iter().flat_map(|p| q.iter().map(|q| (*p - *q).norm())).fold(9.0, f64::min);
        // Neighbouring points are a twelfth apart.
        assert!(least >= found - 1e-12 && least <= found + 0.15, "{case}: {found}, {least}");
        let check = |m: &Meeting<f64>| {
            let mix = |q: &Quad<f64>, w: &[f64; 4]| {
                q.iter().zip(w).fold(V3([0.0; 3]), |s, (&p, &w)| s + p * w)
            };
            let gap = (mix(&a, &m.here) - mix(&b, &m.there) - m.way).norm();
            assert!(gap < 1e-12, "shares are where the way begins and ends");
        };
        meetings([&a, &b], [Parts::ALL; 2], check);
    }
}

#[test]
fn a_way_that_is_called_free_meets_nothing() {
    let (mut random, mut blocked, mut missed) = (Pcg::new(5), 0, 0);
    let mut early = 0;
    for case in 0..500 {
        let (a, b) = (quad(&mut random), quad(&mut random));
        if crossed(&a, &b) || apart(&a, &b) < 0.05 {
            continue;
        }
        // Each goes through where the other is.
        let shift = (b[0] - a[0]) * random.within(0.5, 3.0) + random.v3() * 0.3;
        let to = a.map(|p| p + shift + random.v3() * 0.1);
        let after = b.map(|p| p + random.v3() * 0.1);
        let share = advance::free([&a, &to], [&b, &after], 1.0, 0.0);
        let at = |from: &Quad<f64>, to: &Quad<f64>, t: f64| {
            let mut q = *from;
            q.iter_mut().zip(to).for_each(|(p, &q)| *p = *p + (q - *p) * t);
            q
        };
        let distance = |t: f64| apart(&at(&a, &to, t), &at(&b, &after, t));
        for k in 0..=200 {
            let t = share * f64::from(k) / 200.0;
            assert!(distance(t) > 1e-3, "{case}: {} apart at {t} of {share}", distance(t));
        }
        if share < 1.0 {
            blocked += 1;
            early += usize::from(distance(share) > 0.2 * distance(0.0));
        }
        let met = (0..=200)
            .map(|k| f64::from(k) / 200.0)
            .any(|t| crossed(&at(&a, &to, t), &at(&b, &after, t)));
        assert!(!met || share < 1.0, "{case}: they meet");
        missed += usize::from(met);
    }
    println!("{blocked} of 500 ways blocked, {missed} led through; {early} stopped early");
    assert!(missed > 50, "the control: ways that are not limited do lead through");
    assert!(early * 10 < blocked, "and few stop before the gap is a fifth: {early}");
}

#[test]
fn fields_and_half_spaces_agree_where_both_are_flat() {
    let normal = V3([0.6, 0.0, 0.8]);
    let plane = HalfSpace { point: V3([0.0, 0.0, 0.1]), normal };
    let field = Field { height: |p: V3<f64>| (0.1 - 0.75 * p.0[0], normal), up: 2 };
    let mut random = Pcg::new(9);
    for _ in 0..50 {
        let p = random.v3();
        let ((d, n), (e, m)) = (plane.above(p), field.above(p));
        assert!((d - e).abs() < 1e-14 && n == m, "{d}, {e}");
    }
    let both = [plane, FLOOR];
    assert!((both.above(V3([0.0, 0.0, 1.0])).0 - 0.72).abs() < 1e-14, "the nearer of two");
}

type Around = Near<f64, HalfSpace<f64>, 20, 64, 1024>;

/// A ribbon folded near itself, over the floor and beside another; and what is near it.
fn pressed() -> (Box<Ribbon<f64, 20>>, Box<Around>) {
    let free = RibbonSpec { root: Root::Free, width_m: 0.1, perturbation: 1e-3, ..spec(20) };
    let mut ribbon = open::<f64, 20>(&free);
    let base = start::<f64>().moved(&[0.1, 0.05, 0.0, 0.0, 0.0, 0.08]);
    let fold = |j: usize| if (5..15).contains(&j) { 0.32 } else { 0.02 };
    ribbon.lay(&base, |j| Crease { psi: fold(j), c: 0.1 * (j as f64).sin() });
    let mut other = open::<f64, 20>(&free);
    let aside = start::<f64>().moved(&[0.0, 0.4, 1.2, 0.05, -0.5, 0.13]);
    other.lay(&aside, |j| Crease { psi: 0.02, c: 0.1 * (j as f64).cos() });
    let cushion = Cushion { reach_m: 0.2, stiffness: 3.0 };
    let mut near = Box::new(Near::over(FLOOR, cushion));
    near.begin(&ribbon, 0.05);
    near.add(&other);
    assert!(!near.full() && near.counts.others > 0, "{:?}", near.counts);
    (ribbon, near)
}

#[test]
fn the_gradient_of_contact_is_a_difference() {
    let (mut ribbon, mut near) = pressed();
    let ask = ribbon.ask.clone();
    let body = ribbon.body();
    body.place(0.0);
    // Statics without weight, bending as it comes: what is compared is the sum.
    body.motion.kappa = 0.0;
    let at = |body: &mut dogleaf_core::effect::ribbon::body::Body<f64, 20>, i: usize, x: f64| {
        body.place(0.0);
        let s = &mut body.stages[i / 2].crease;
        *(if i.is_multiple_of(2) { &mut s.psi } else { &mut s.c }) += x;
    };
    body.evaluate(&ask, &());
    let stored = near.energy(&body.pose());
    near.press(&body.pose());
    assert!(stored > 1e-6 && near.counts.pushes > 40, "{stored}: {:?}", near.counts);
    let mut found = vec![0.0; 40];
    body.gradient(&ask, &(), &*near, |j, [psi, c]| {
        (found[2 * j], found[2 * j + 1]) = (psi, c);
    });
    let mut without = vec![0.0; 40];
    body.gradient(&ask, &(), &(), |j, [psi, c]| {
        (without[2 * j], without[2 * j + 1]) = (psi, c);
    });
    let largest = found.iter().fold(0.0, |m: f64, g| m.max(g.abs()));
    let (mut off, mut told) = (0.0_f64, 0.0_f64);
    for i in 2..40 {
        let h = 1e-5;
        let mut f = |k: f64| {
            at(body, i, k * h);
            body.evaluate(&ask, &()).total(body.mu) + near.energy(&body.pose())
        };
        let difference = (8.0 * (f(1.0) - f(-1.0)) - f(2.0) + f(-2.0)) / (12.0 * h);
        off = off.max((difference - found[i]).abs() / largest);
        told = told.max((found[i] - without[i]).abs() / largest);
    }
    println!("off by {off:.1e} of the largest; contact is {told:.2} of it");
    assert!(off < 1e-6, "{off}");
    assert!(told > 0.1, "contact is felt: {told}");
}

#[test]
fn the_curvature_of_contact_bounds_its_change() {
    let (mut ribbon, mut near) = pressed();
    let ask = ribbon.ask.clone();
    let body = ribbon.body();
    body.place(0.0);
    (body.motion.kappa, body.strip.free) = (0.0, false);
    body.evaluate(&ask, &());
    near.press(&body.pose());
    let mut fall = None;
    for k in 0..20 {
        fall = body.factor_touching(&ask, &(), &*near, 1e-3 * 4_f64.powi(k));
        if fall.is_some() {
            break;
        }
    }
    let fall = fall.expect("some shift is enough");
    let _ = body.solve(false);
    let mut total = |s: f64| {
        body.place(s);
        body.evaluate(&ask, &()).total(body.mu) + near.energy(&body.pose())
    };
    let h = 1e-4;
    let [low, middle, high] = [-h, 0.0, h].map(&mut total);
    let (slope, curve) = ((high - low) / (2.0 * h), (high - 2.0 * middle + low) / (h * h));
    println!("along the step: slope {slope:.4e}, curvature {curve:.4e}; told {fall:.4e}");
    assert!((slope / -fall - 1.0).abs() < 1e-3, "{slope} against {fall}");
    // Left out is what turns contacts about one another, which only takes away, and a shift comes on top.
    assert!(curve > 0.1 * fall && curve < 1.001 * fall, "{curve} against {fall}");
}

/// Two ribbons across each other, one above; the upper one flies at the lower.
fn crossing(speed: f64) -> Vec<Ribbon<f64, 20>> {
    let free = RibbonSpec { root: Root::Free, width_m: 0.1, ..spec(20) };
    let mut lower = open::<f64, 20>(&free);
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(V3);
    lower.lay(&Frame::leaning(x * -0.5 + z, x, z), |_| Crease::default());
    let mut upper = open::<f64, 20>(&free);
    upper.lay(&Frame::leaning(y * -0.5 + z * 1.1, y, z), |_| Crease::default());
    upper.launch(|_| V3([0.0, 0.0, -speed]));
    vec![*lower, *upper]
}

/// Height of the upper's middle over the lower's.
fn over(both: &[Ribbon<f64, 20>]) -> f64 {
    let middle = |r: &Ribbon<f64, 20>| r.pairs().nth(10).map_or(0.0, |p| p[0].0[2] + p[1].0[2]);
    0.5 * (middle(&both[1]) - middle(&both[0]))
}

#[test]
fn a_fast_ribbon_is_stopped_by_a_thin_one() {
    for speed in [1.0, 10.0, 100.0] {
        let mut near = Box::new(Around::over(FLOOR, Cushion::default()));
        let mut both = crossing(speed);
        for step in 0..20 {
            let s = step_all(&mut both, 0.01, &mut near);
            assert_eq!(s.held, 0, "{speed} m/s, step {step}: {s:?}");
            assert!(over(&both) > 0.0, "{speed} m/s, step {step}: it passed through");
            assert!(
                both.iter().all(|r| finite(r) && stretch(r) < 1e-9),
                "{speed} m/s, step {step}"
            );
        }
        let mut ghosts = crossing(speed);
        for _ in 0..20 {
            ghosts.iter_mut().for_each(|r| assert_ne!(r.step(0.01).status, Status::Held));
        }
        assert!(over(&ghosts) < 0.0, "the control: without contact it does pass through");
    }
}

#[test]
fn a_list_that_is_too_short_stops_all_that_moves() {
    let mut near = Box::new(Near::<_, _, 20, 2, 8>::over(FLOOR, Cushion::default()));
    let mut both = crossing(10.0);
    let before = both[1].pairs().collect::<Vec<_>>();
    let s = step_all(&mut both, 0.02, &mut near);
    assert!(s.held > 0 && s.crowded > 0, "{s:?}");
    assert_eq!(both[1].pairs().collect::<Vec<_>>(), before, "it waits where it was");
}

#[test]
fn a_ribbon_lies_on_what_is_below_it() {
    let hill = |p: V3<f64>| {
        let x = p.0[0] - 0.5;
        (0.1 - 0.4 * x * x, V3([0.8 * x, 0.0, 1.0]) * (1.0 / (1.0 + 0.64 * x * x).sqrt()))
    };
    let field = Field { height: hill, up: 2 };
    let mut near = Box::new(Near::<_, _, 50, 4, 512>::over(field, Cushion::default()));
    let limp = RibbonSpec { root: Root::Free, damping_per_s: 5.0, ..spec(50) };
    let mut ribbon = open::<f64, 50>(&limp);
    ribbon.gravity = [0.0, 0.0, -9.81];
    ribbon.lay(&start::<f64>().moved(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.15]), |_| Crease::default());
    let mut one = vec![*ribbon];
    let mut lowest = f64::INFINITY;
    for _ in 0..100 {
        let s = step_all(&mut one, 0.01, &mut near);
        assert_eq!(s.held, 0, "{s:?}");
        let heights = one[0].pairs().flatten().map(|p| field.above(p).0);
        lowest = heights.fold(lowest, f64::min);
    }
    let highest = one[0].pairs().flatten().map(|p| field.above(p).0).fold(0.0, f64::max);
    println!("never nearer than {lowest:.1e} m; at the end everywhere within {highest:.1e} m");
    assert!(lowest > 0.0, "it never went in: {lowest}");
    assert!(highest < 5e-3, "and lies: {highest}");
}
