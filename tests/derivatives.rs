//! Promise: every gradient, Jacobian and Hessian of a potential or a constraint is the central
//! difference of what it belongs to, and none is zero; alone, and assembled for the whole leaf.

#[path = "derivatives/chain.rs"]
mod chain;
#[path = "derivatives/constraints.rs"]
mod constraints;
#[path = "derivatives/leaf.rs"]
mod leaf;

use dogleaf_core::potential::{bending, contact, glue, gravity, isometry, position};
use dogleaf_core::real::{V2, V3};
use dogleaf_tests::dense::Dense;
use dogleaf_tests::differences::{Doubt, agree, gradient, jacobian};
use dogleaf_tests::random::Pcg;

/// Central differences of these polynomials and roots are good to ten digits.
const CLOSE: f64 = 1e-8;
/// Random configurations asked of each.
const TRIES: usize = 200;

/// A potential: value, gradient, and Hessian row by row.
trait Potential {
    fn value(&self, x: &[f64]) -> f64;
    fn gradient(&self, x: &[f64]) -> Vec<f64>;
    fn hessian(&self, x: &[f64]) -> Vec<f64>;
}

fn doubt(p: &impl Potential, x: &[f64]) -> Result<(), Doubt> {
    agree(&p.gradient(x), &gradient(|x| p.value(x), x), CLOSE)?;
    agree(&p.hessian(x), &jacobian(|x| p.gradient(x), x), CLOSE)
}

/// Asks a potential of `count` numbers at many random places.
fn ask<P: Potential>(count: usize, make: impl Fn(&mut Pcg) -> P) {
    let mut random = Pcg::new(1);
    for _ in 0..TRIES {
        let p = make(&mut random);
        let x: Vec<f64> = random.numbers(count).iter().map(|v| 2.0 * v).collect();
        assert_eq!(doubt(&p, &x), Ok(()), "at {x:?}");
    }
}

fn v3(x: &[f64], n: usize) -> V3<f64> {
    V3([x[3 * n], x[3 * n + 1], x[3 * n + 2]])
}

fn v2(x: &[f64], n: usize) -> V2<f64> {
    V2([x[2 * n], x[2 * n + 1]])
}

/// A symmetric 2x2 matrix from `[xx, xy, yy]`.
fn full([xx, xy, yy]: [f64; 3]) -> Vec<f64> {
    vec![xx, xy, xy, yy]
}

/// `f(n, m) I` for every pair of `nodes` nodes.
fn blocks(nodes: usize, f: impl Fn(usize, usize) -> f64) -> Vec<f64> {
    let size = 3 * nodes;
    let entry = |r: usize, c: usize| if r % 3 == c % 3 { f(r / 3, c / 3) } else { 0.0 };
    (0..size * size).map(|n| entry(n / size, n % size)).collect()
}

/// The two crossing differences of a star: centre, `x⁺`, `x⁻`, `z⁺`, `z⁻`.
struct Crossing {
    a: f64,
    b: f64,
    chi: f64,
}

impl Crossing {
    fn laplacians(&self, x: &[f64]) -> [V3<f64>; 2] {
        let two = |p, m, c| bending::second(v3(x, 0), v3(x, p), v3(x, m), c);
        [two(1, 2, self.a), two(3, 4, self.b)]
    }
    /// Coefficients of a node in the two differences.
    fn shares(&self, node: usize) -> [f64; 2] {
        let (a, b) = (self.a, self.b);
        [[2.0 * a, 2.0 * b], [-a, 0.0], [-a, 0.0], [0.0, -b], [0.0, -b]][node]
    }
}

impl Potential for Crossing {
    fn value(&self, x: &[f64]) -> f64 {
        let [lx, lz] = self.laplacians(x);
        bending::value(lx, lz, self.chi)
    }
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let [lx, lz] = self.laplacians(x);
        let (px, pz) = (lx + lz * self.chi, lz + lx * self.chi);
        let of = |n| {
            let [s, t] = self.shares(n);
            bending::gradient(px, s) + bending::gradient(pz, t)
        };
        (0..5).flat_map(|n| of(n).0).collect()
    }
    fn hessian(&self, _: &[f64]) -> Vec<f64> {
        blocks(5, |n, m| {
            let ([sn, tn], [sm, tm]) = (self.shares(n), self.shares(m));
            let between = bending::hessian(sn, tm) + bending::hessian(tn, sm);
            bending::hessian(sn, sm) + bending::hessian(tn, tm) + self.chi * between
        })
    }
}

#[test]
fn bending_is_its_differences_for_every_cross_term() {
    for chi in [0.0, 0.35, 1.0] {
        ask(15, |r| Crossing { a: r.within(0.5, 3.0), b: r.within(0.5, 3.0), chi });
    }
}

#[test]
fn the_cross_term_of_bending_counts() {
    let x = Pcg::new(7).numbers(15);
    let of = |chi| Crossing { a: 1.0, b: 2.0, chi };
    assert!((of(1.0).value(&x) - of(0.0).value(&x)).abs() > 1e-2);
    assert_ne!(of(1.0).hessian(&x), of(0.0).hessian(&x));
}

/// The mixed difference over a cell: `x_00`, `x_10`, `x_01`, `x_11`.
struct Mixed(f64);

impl Mixed {
    const SIGNS: [f64; 4] = [1.0, -1.0, -1.0, 1.0];
    fn twist(&self, x: &[f64]) -> V3<f64> {
        bending::mixed([v3(x, 0), v3(x, 1), v3(x, 2), v3(x, 3)], self.0)
    }
}

impl Potential for Mixed {
    fn value(&self, x: &[f64]) -> f64 {
        bending::value(self.twist(x), V3::zero(), 0.0)
    }
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let t = self.twist(x);
        Self::SIGNS.iter().flat_map(|s| bending::gradient(t, s * self.0).0).collect()
    }
    fn hessian(&self, _: &[f64]) -> Vec<f64> {
        blocks(4, |n, m| bending::hessian(Self::SIGNS[n] * self.0, Self::SIGNS[m] * self.0))
    }
}

#[test]
fn twist_is_its_differences() {
    ask(12, |r| Mixed(r.within(0.5, 3.0)));
}

/// Glue by the edge's free node.
struct Glued {
    normal: V2<f64>,
    rest: f64,
    weight: f64,
}

impl Glued {
    fn edge(&self, x: &[f64]) -> glue::Glue<f64> {
        glue::edge(v2(x, 0), self.normal, self.rest, self.weight)
    }
}

impl Potential for Glued {
    fn value(&self, x: &[f64]) -> f64 {
        self.edge(x).value
    }
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        self.edge(x).gradient.0.to_vec()
    }
    fn hessian(&self, x: &[f64]) -> Vec<f64> {
        full(self.edge(x).hessian)
    }
}

fn unit(random: &mut Pcg) -> V2<f64> {
    let angle = random.within(0.2, 1.3);
    V2([angle.cos(), angle.sin()])
}

#[test]
fn glue_is_its_differences() {
    ask(2, |r| Glued { normal: unit(r), rest: r.within(0.5, 2.0), weight: r.within(1.0, 600.0) });
}

#[test]
fn glue_is_least_on_an_upright_edge() {
    let upright = glue::edge(V2([0.0, 2.0]), V2([0.0, 1.0]), 2.0, 600.0);
    assert_eq!((upright.value, upright.gradient.0), (0.0, [0.0, 0.0]));
}

#[test]
fn gravity_is_its_differences_and_has_no_hessian() {
    let mut random = Pcg::new(2);
    for _ in 0..TRIES {
        let (a, x, m) = (random.v3(), random.numbers(3), random.within(0.1, 2.0));
        let found = gravity::gradient(m, a).0;
        let value = |x: &[f64]| gravity::value(m, a, v3(x, 0));
        assert_eq!(agree(&found, &gradient(value, &x), CLOSE), Ok(()));
    }
}

#[test]
fn gravity_pulls_down() {
    let down = V3([0.0, -9.81, 0.0]);
    assert_eq!(gravity::value(2.0, down, V3([5.0, 3.0, 7.0])), 2.0 * 9.81 * 3.0);
    assert!(gravity::gradient(2.0, down).0[1] > 0.0);
}

/// One edge by both its nodes.
struct Edge {
    rest_sq: f64,
    weight: f64,
    exact: bool,
}

impl Edge {
    fn edge(&self, x: &[f64]) -> isometry::Edge<f64> {
        isometry::edge(v3(x, 0) - v3(x, 1), self.rest_sq, self.weight, self.exact)
    }
}

impl Potential for Edge {
    fn value(&self, x: &[f64]) -> f64 {
        isometry::value(v3(x, 0) - v3(x, 1), self.rest_sq, self.weight)
    }
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let g = self.edge(x).gradient;
        g.0.into_iter().chain((-g).0).collect()
    }
    fn hessian(&self, x: &[f64]) -> Vec<f64> {
        let h = self.edge(x).hessian;
        let sign = |r: usize, c: usize| if r / 3 == c / 3 { 1.0 } else { -1.0 };
        (0..36).map(|n| (n / 6, n % 6)).map(|(r, c)| sign(r, c) * h[r % 3][c % 3]).collect()
    }
}

#[test]
fn the_exact_isometry_is_its_differences() {
    ask(6, |r| Edge { rest_sq: r.within(0.1, 9.0), weight: r.within(0.5, 4000.0), exact: true });
}

#[test]
fn the_two_values_of_isometry_are_one() {
    let (e, rest) = (V3([1.0, 2.0, 3.0]), 9.0);
    assert_eq!(isometry::value(e, rest, 7.0), isometry::edge(e, rest, 7.0, false).value);
}

#[test]
fn the_projected_isometry_is_exact_on_a_stretched_edge() {
    ask(6, |r| Edge { rest_sq: 1e-3, weight: r.within(0.5, 4000.0), exact: false });
}

#[test]
fn the_projected_isometry_is_never_indefinite() {
    let mut random = Pcg::new(3);
    for _ in 0..TRIES {
        let edge = Edge { rest_sq: random.within(0.1, 9.0), weight: 2.0, exact: false };
        let hessian = Dense::of(edge.hessian(&random.numbers(6)));
        assert!(hessian.norm() > 0.0, "a Hessian that is zero proves nothing");
        assert!(hessian.shifted(1e-12).cholesky().is_some());
    }
}

#[test]
fn the_exact_isometry_of_a_compressed_edge_is_indefinite() {
    let edge = Edge { rest_sq: 9.0, weight: 2.0, exact: true };
    let hessian = Dense::of(edge.hessian(&[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
    assert!(hessian.shifted(1e-12).cholesky().is_none());
}

/// The hand's pull: target and weight.
struct Pull(V3<f64>, f64);

impl Potential for Pull {
    fn value(&self, x: &[f64]) -> f64 {
        position::value(v3(x, 0), self.0, self.1)
    }
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        position::gradient(v3(x, 0), self.0, self.1).0.to_vec()
    }
    fn hessian(&self, _: &[f64]) -> Vec<f64> {
        blocks(1, |_, _| position::hessian(self.1))
    }
}

#[test]
fn the_hands_pull_is_its_differences() {
    ask(3, |r| Pull(r.v3(), r.within(1.0, 400.0)));
}

/// A contact: direction, offset, weight.
struct Touch(V2<f64>, f64, f64);

impl Potential for Touch {
    fn value(&self, x: &[f64]) -> f64 {
        contact::value(v2(x, 0), self.0, self.1, self.2)
    }
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        contact::gradient(v2(x, 0), self.0, self.1, self.2).0.to_vec()
    }
    fn hessian(&self, _: &[f64]) -> Vec<f64> {
        full(contact::hessian(self.0, self.2))
    }
}

#[test]
fn contact_is_its_differences() {
    ask(2, |r| Touch(unit(r), r.within(-1.0, 1.0), r.within(1.0, 4000.0)));
}

/// A potential spoilt on purpose.
struct Spoilt<F>(Crossing, F);

impl<F: Fn(&mut [f64])> Potential for Spoilt<F> {
    fn value(&self, x: &[f64]) -> f64 {
        self.0.value(x)
    }
    fn gradient(&self, x: &[f64]) -> Vec<f64> {
        let mut g = self.0.gradient(x);
        (self.1)(&mut g);
        g
    }
    fn hessian(&self, x: &[f64]) -> Vec<f64> {
        self.0.hessian(x)
    }
}

#[test]
fn a_wrong_gradient_is_caught() {
    let x = Pcg::new(10).numbers(15);
    let spoilt =
        |how: fn(&mut [f64])| doubt(&Spoilt(Crossing { a: 1.0, b: 2.0, chi: 1.0 }, how), &x);
    assert_eq!(spoilt(|_| ()), Ok(()), "the control itself is sound");
    assert!(matches!(spoilt(|g| g[4] = -g[4]), Err(Doubt::Differs(4, _))));
    assert!(matches!(spoilt(|g| g[14] *= 1.000_01), Err(Doubt::Differs(14, _))));
    assert!(matches!(spoilt(|g| g[0] = f64::NAN), Err(Doubt::Differs(..))));
    assert_eq!(spoilt(|g| g.fill(0.0)), Err(Doubt::Zero));
}

#[test]
fn a_zero_function_is_caught_though_its_derivatives_agree() {
    let nothing = Crossing { a: 0.0, b: 0.0, chi: 0.0 };
    assert_eq!(doubt(&nothing, &Pcg::new(11).numbers(15)), Err(Doubt::Zero));
}
