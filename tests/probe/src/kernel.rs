//! Potentials and constraints: every stencil on eight lanes and, the same cases, on one number after another.

use crate::fold::Fold;
use crate::random::Random;
use crate::work::Pick;
use crate::{CASES, Row};
use dogleaf_core::constraint::{binding, dog, fix, length};
use dogleaf_core::potential::{bending, contact, glue, gravity, isometry, position};
use dogleaf_core::real::{Eight, LANES, Num, Real, V2, V3};

/// Numbers a case has; a kernel reads as many as it wants.
const INPUTS: usize = 18;

/// A stencil, written once for any number.
trait Kernel {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T));
}

/// All of them.
pub(crate) fn table<R: Pick>() -> [Row; 11] {
    [
        ("potential.bending", |_| parity::<R, Bending>("bending")),
        ("potential.isometry", |_| parity::<R, Isometry>("isometry")),
        ("potential.contact", |_| parity::<R, Contact>("contact")),
        ("potential.position", |_| parity::<R, Position>("position")),
        ("potential.gravity", |_| parity::<R, Gravity>("gravity")),
        ("potential.glue", |_| parity::<R, Glue>("glue")),
        ("constraint.dog.values", |_| parity::<R, DogValues>("dog")),
        ("constraint.dog.rows", |_| parity::<R, DogRows>("dog")),
        ("constraint.length", |_| parity::<R, Length>("length")),
        ("constraint.binding", |_| parity::<R, Binding>("binding")),
        ("constraint.fix", |_| parity::<R, Fix>("fix")),
    ]
}

fn parity<R: Real, K: Kernel>(name: &str) -> u64 {
    let (mut random, mut fold) = (Random::named(name), Fold::START);
    for _ in 0..CASES / LANES {
        let rows: [[R; LANES]; INPUTS] = core::array::from_fn(|_| random.eight());
        K::run(&rows.map(R::Eight::from_array), &mut |v| fold.lanes::<R>(v));
        for lane in 0..LANES {
            K::run(&rows.map(|row| row[lane]), &mut |v| fold.real(v));
        }
    }
    fold.value()
}

/// The vector that begins at input `at`.
fn v3<T: Num>(from: &[T; INPUTS], at: usize) -> V3<T> {
    V3([from[at], from[at + 1], from[at + 2]])
}

/// The vector of the plane that begins at input `at`.
fn v2<T: Num>(from: &[T; INPUTS], at: usize) -> V2<T> {
    V2([from[at], from[at + 1]])
}

struct Bending;
impl Kernel for Bending {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        let (a, b, c, d) = (v3(from, 0), v3(from, 3), v3(from, 6), v3(from, 9));
        let second = bending::second(a, b, c, from[12]);
        let mixed = bending::mixed([a, b, c, d], from[13]);
        second.0.into_iter().chain(mixed.0).for_each(&mut *to);
        to(bending::value(second, mixed, from[14]));
        bending::gradient(second, from[15]).0.into_iter().for_each(&mut *to);
        to(bending::hessian(from[16], from[17]));
    }
}

struct Isometry;
impl Kernel for Isometry {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        for exact in [false, true] {
            let e = isometry::edge(v3(from, 0), from[3], from[4], exact);
            to(e.value);
            e.gradient.0.into_iter().chain(e.hessian.into_iter().flatten()).for_each(&mut *to);
        }
        to(isometry::value(v3(from, 5), from[8], from[9]));
    }
}

struct Contact;
impl Kernel for Contact {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        let (x, n, o, w) = (v2(from, 0), v2(from, 2), from[4], from[5]);
        to(contact::value(x, n, o, w));
        contact::gradient(x, n, o, w).0.into_iter().for_each(&mut *to);
        contact::hessian(n, w).into_iter().for_each(to);
    }
}

struct Position;
impl Kernel for Position {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        let (x, p, w) = (v3(from, 0), v3(from, 3), from[6]);
        to(position::value(x, p, w));
        position::gradient(x, p, w).0.into_iter().for_each(&mut *to);
        to(position::hessian(w));
    }
}

struct Gravity;
impl Kernel for Gravity {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        to(gravity::value(from[0], v3(from, 1), v3(from, 4)));
        gravity::gradient(from[0], v3(from, 1)).0.into_iter().for_each(to);
    }
}

struct Glue;
impl Kernel for Glue {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        let g = glue::edge(v2(from, 0), v2(from, 2), from[4], from[5]);
        to(g.value);
        g.gradient.0.into_iter().chain(g.hessian).for_each(to);
    }
}

fn star<T: Num>(from: &[T; INPUTS]) -> dog::Star<T> {
    dog::Star::new(v3(from, 0), [v3(from, 3), v3(from, 6), v3(from, 9), v3(from, 12)])
}

struct DogValues;
impl Kernel for DogValues {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        star(from).values([from[15], from[16], from[17]]).into_iter().for_each(to);
    }
}

struct DogRows;
impl Kernel for DogRows {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        for row in star(from).rows([from[15], from[16], from[17]]) {
            to(row.value);
            row.gradient.into_iter().flat_map(|v| v.0).for_each(&mut *to);
        }
    }
}

struct Length;
impl Kernel for Length {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        let (value, gradient) = length::row(v2(from, 0), from[2]);
        to(value);
        gradient.0.into_iter().for_each(to);
    }
}

struct Binding;
impl Kernel for Binding {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        let r = binding::residual(v2(from, 0), v2(from, 2), v2(from, 4), from[6]);
        r.0.into_iter().chain(binding::gradient(from[6])).for_each(to);
    }
}

struct Fix;
impl Kernel for Fix {
    fn run<T: Num>(from: &[T; INPUTS], to: &mut dyn FnMut(T)) {
        fix::residual(v2(from, 0), v2(from, 2), v2(from, 4)).0.into_iter().for_each(to);
    }
}
