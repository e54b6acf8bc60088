//! Promise: a ribbon's gradient is the difference of what it minimises, and its Newton step solves the exact Hessian:
//! the change of the gradient along the step cancels the gradient.

use dogleaf_core::effect::ribbon::body::Body;
use dogleaf_core::effect::ribbon::closure::Hold;
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::sweep::SLOPES;
use dogleaf_core::effect::ribbon::{
    Ask, Bending, Closure, Guide, Loads, Mass, Pull, Ribbon, RibbonSpec, Root, Spring,
};
use dogleaf_core::real::V3;
use dogleaf_tests::random::Pcg;

/// Segments.
const N: usize = 12;

/// A load that is not quadratic: a soft ground.
struct Ground;

impl Loads<f64> for Ground {
    fn energy(&self, _: usize, pair: &[V3<f64>; 2]) -> f64 {
        pair.iter().map(|p| 0.5 * (3.0 * p.0[2]).exp()).sum()
    }
    fn pull(&self, _: usize, pair: &[V3<f64>; 2], pull: &mut Pull<f64>) {
        let up = |s: f64| V3([0.0, 0.0, s]);
        let [a, b] = pair.map(|p| (3.0 * p.0[2]).exp());
        pull.push(up(1.5 * a), up(1.5 * b));
        pull.curve(4.5 * a, [up(1.0), up(0.0)]);
        pull.curve(4.5 * b, [up(0.0), up(1.0)]);
    }
}

/// A ribbon somewhere between two states, with everything pulling at it.
fn body(change: impl Fn(&mut RibbonSpec), seed: u64) -> (Box<Ribbon<f64, N>>, Ask<f64>) {
    let mut random = Pcg::new(seed);
    let mut spec = RibbonSpec {
        segments: N,
        width_m: 0.2,
        rigidity_nm: 0.8,
        areal_mass_gsm: 2000.0,
        regularisation: 0.01,
        ..RibbonSpec::default()
    };
    change(&mut spec);
    let mut ribbon = Box::new(Ribbon::<f64, N>::EMPTY);
    ribbon.open(&spec, [0.0; 3]).expect("a sound spec");
    let base = Frame::at(V3([0.1, -0.2, 0.3])).moved(&[0.3, 0.2, -0.5, 0.1, 0.2, 0.3]);
    let shape: Vec<_> = (0..N).map(|_| [0.5, 0.25].map(|s| s * random.within(-1.0, 1.0))).collect();
    ribbon.lay(&base, |j| Crease { psi: shape[j][0], c: shape[j][1] });
    ribbon.launch(|p| V3([0.3, -0.2 + p.0[0], 0.4 * p.0[1]]));
    ribbon.gravity = [0.0, 0.0, -9.81];
    (ribbon.settings.iterations, ribbon.settings.closure) = (0, f64::INFINITY);
    let h = 0.05;
    ribbon.step(h);
    let body = ribbon.body();
    for s in body.used_mut().iter_mut().skip(1) {
        s.kept.psi += 0.1 * random.within(-1.0, 1.0);
        s.kept.c += 0.05 * random.within(-1.0, 1.0);
    }
    body.stages[0].kept.psi += if body.strip.hinge > 0.0 { 0.2 } else { 0.0 };
    body.part_rulings();
    body.mu = 0.03;
    for s in body.used_mut() {
        s.dual = [0.0; 2];
    }
    body.hold = Hold { lambda: [0.3, -0.2, 0.4, 0.5, 0.1, -0.6], turn: 0.7, shift: 0.9 };
    let mut ask = Ask::NONE;
    let target = random.v3();
    let _ = ask.springs.push(Spring { crease: N, rim: 1, target, stiffness: 2.0 });
    let target = random.v3();
    let _ = ask.springs.push(Spring { crease: 5, rim: 0, target, stiffness: 3.0 });
    let normal = V3([0.6, 0.0, 0.8]);
    let _ = ask.guides.push(Guide { segment: 7, normal, stiffness: 1.5 });
    (ribbon, ask)
}

/// The merit at creases and a twist of the start away from where it was kept.
fn value(body: &mut Body<f64, N>, ask: &Ask<f64>, x: &[f64]) -> f64 {
    at(body, x);
    body.evaluate(ask, &Ground).total(body.mu)
}

fn at(body: &mut Body<f64, N>, x: &[f64]) {
    body.place(0.0);
    for (j, s) in body.used_mut().iter_mut().enumerate() {
        s.crease.psi += x[2 * j];
        s.crease.c += x[2 * j + 1];
    }
    let twist = [0, 1, 2, 3, 4, 5].map(|i| x[2 * N + i]);
    body.base = body.kept_base.moved(&twist);
}

fn gradient(body: &mut Body<f64, N>, ask: &Ask<f64>, x: &[f64]) -> Vec<f64> {
    at(body, x);
    body.evaluate(ask, &Ground);
    let mut g = vec![0.0; 2 * N + 6];
    let start = body.gradient(ask, &Ground, &(), |j, [psi, c]| {
        (g[2 * j], g[2 * j + 1]) = (psi, c);
    });
    g[2 * N..].copy_from_slice(&start);
    g
}

/// Unknowns that may move.
fn free(body: &Body<f64, N>) -> Vec<usize> {
    let hinge = body.strip.hinge > 0.0;
    let start = if body.strip.free { 2 * N..2 * N + 6 } else { 0..0 };
    (0..2 * N).filter(|&i| i > 1 || (i == 0 && hinge)).chain(start).collect()
}

/// Sixth-order central difference.
fn difference(mut f: impl FnMut(f64) -> f64, h: f64) -> f64 {
    let mut d = |k: f64| f(k * h) - f(-k * h);
    (45.0 * d(1.0) - 9.0 * d(2.0) + d(3.0)) / (60.0 * h)
}

/// A change of the spec, and its name.
type Variant = (&'static str, Box<dyn Fn(&mut RibbonSpec)>);

fn variants() -> Vec<Variant> {
    vec![
        ("clamped", Box::new(|_| {})),
        ("segment", Box::new(|s| s.root = Root::Segment)),
        ("free", Box::new(|s| s.root = Root::Free)),
        ("lumped", Box::new(|s| s.mass = Mass::Lumped)),
        ("wunderlich", Box::new(|s| s.bending = Bending::Wunderlich)),
        ("ring", Box::new(|s| (s.closure, s.root) = (Closure::Ring, Root::Free))),
        ("moebius", Box::new(|s| (s.closure, s.root) = (Closure::Moebius, Root::Free))),
        (
            "clamped moebius",
            Box::new(|s| (s.closure, s.bending) = (Closure::Moebius, Bending::Wunderlich)),
        ),
    ]
}

#[test]
fn gradients_are_differences() {
    for (name, change) in variants() {
        for seed in 1..4 {
            let (mut ribbon, ask) = body(&change, seed);
            let body = ribbon.body();
            let zero = vec![0.0; 2 * N + 6];
            let found = gradient(body, &ask, &zero);
            let largest = found.iter().fold(0.0, |m: f64, g| m.max(g.abs()));
            assert!(largest > 1e-2, "{name}: the gradient says nothing");
            let mut worst = (0.0, 0);
            for i in free(body) {
                let along = |t: f64| {
                    let mut x = zero.clone();
                    x[i] = t;
                    x
                };
                let wanted = difference(|t| value(body, &ask, &along(t)), 3e-4);
                let gap = (found[i] - wanted).abs() / largest;
                if gap > worst.0 {
                    worst = (gap, i);
                }
            }
            println!("{name} {seed}: {:.1e} at {} of {largest:.1}", worst.0, worst.1);
            assert!(worst.0 <= 1e-8, "{name}: entry {} is off by {:.1e}", worst.1, worst.0);
        }
    }
}

/// Largest share by which the change of the gradient along the Newton step fails to cancel the gradient.
#[test]
fn the_newton_step_solves_the_exact_hessian() {
    for (name, change) in variants() {
        for seed in 1..4 {
            let (mut ribbon, ask) = body(&change, seed);
            let body = ribbon.body();
            // Closed and balanced, a loop's second derivatives are exact; else they are Gauss and Newton's.
            if body.looped() {
                body.hold = Hold::NONE;
            }
            let zero = vec![0.0; 2 * N + 6];
            let g = gradient(body, &ask, &zero);
            exact_barrier(body);
            body.place(0.0);
            body.evaluate(&ask, &Ground);
            // A shift that makes the model convex is taken off again below.
            let shifts = [0.0, 1.0, 10.0, 100.0, 1000.0];
            let found = shifts.iter().find_map(|&s| Some((s, body.factor(&ask, &Ground, s)?)));
            let (shift, fall) = found.expect("some shift is enough");
            body.solve(false);
            let mut step: Vec<f64> =
                body.used().iter().flat_map(|s| [s.step.psi, s.step.c]).collect();
            step.extend(body.base_step);
            let free = free(body);
            let slope: f64 = free.iter().map(|&i| g[i] * step[i]).sum();
            assert!((slope + fall).abs() <= 1e-9 * fall, "{name}: {slope} is not -{fall}");
            let size = step.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
            let along = |t: f64| step.iter().map(|s| s * t / size).collect::<Vec<_>>();
            let h = 3e-4;
            let curve = {
                let mut f = |t: f64| value(body, &ask, &along(t));
                let (a, b, c) = (f(h), f(2.0 * h), f(3.0 * h));
                let (p, q, r) = (f(-h), f(-2.0 * h), f(-3.0 * h));
                let o = f(0.0);
                (2.0 * (c + r) - 27.0 * (b + q) + 270.0 * (a + p) - 490.0 * o) / (180.0 * h * h)
            };
            let weight = weights(body, shift);
            let shifted: f64 = step.iter().zip(&weight).map(|(s, w)| w * s * s).sum();
            let form = (fall - shifted) / (size * size);
            let gap = (curve / form - 1.0).abs();
            println!("{name} {seed}: form {gap:.1e}, shift {shift}");
            assert!(gap <= 1e-5, "{name} {seed}: the form is off by {gap:.1e}");
            if body.strip.free {
                continue;
            }
            let largest = g.iter().fold(0.0, |m: f64, g| m.max(g.abs()));
            for &i in &free {
                let change = difference(|t| gradient(body, &ask, &along(t))[i], h) * size;
                let gap = (change + weight[i] * step[i] + g[i]).abs() / largest;
                assert!(gap <= 1e-5, "{name} {seed}: row {i} is off by {gap:.1e}");
            }
        }
    }
}

/// What a shift adds to the diagonal.
fn weights(body: &Body<f64, N>, shift: f64) -> Vec<f64> {
    let (unit, length) = (2.0 * body.strip.stiff * shift, body.strip.length());
    let mut weight: Vec<f64> = (0..N).flat_map(|_| [unit, unit * SLOPES]).collect();
    weight.extend([unit; 3]);
    weight.extend([unit / (length * length); 3]);
    weight
}

/// Duals of the barrier itself, not of its primal-dual relaxation.
fn exact_barrier(body: &mut Body<f64, N>) {
    let (mu, limit) = (body.mu, body.strip.limit);
    let far: Vec<f64> = body.used().iter().skip(1).map(|s| s.kept.c).chain([0.0]).collect();
    for (s, far) in body.used_mut().iter_mut().zip(far) {
        let u = (far - s.kept.c) / limit;
        s.dual = [mu / (1.0 - u), mu / (1.0 + u)];
    }
}
