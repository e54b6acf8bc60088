//! Promise: eight numbers side by side behave, lane by lane and bit for bit, as one number does; also
//! for zeros of both signs, subnormals, infinities and NaN.

use dogleaf_core::constraint::dog::Star;
use dogleaf_core::potential::{bending, contact, isometry};
use dogleaf_core::real::{Eight, LANES, Lanes, Num, Real, V2, V3};
use dogleaf_tests::random::Pcg;

/// Random cases asked of each operation.
const CASES: usize = 2000;

/// What rounding and comparing find hard, from the scalar's own bits.
fn hard<R: Real>() -> Vec<R> {
    let (bits, least_normal) = if R::NAME == "f32" { (31, 1 << 23) } else { (63, 1 << 52) };
    let positive = [0, 1, least_normal - 1, least_normal, R::of(1.0).bits()];
    let infinite = R::of(f64::INFINITY).bits();
    let ends = [infinite - 1, infinite, R::of(f64::NAN).bits()];
    let all = positive.into_iter().chain(ends);
    all.flat_map(|b| [b, b | 1 << bits]).map(R::from_bits).collect()
}

/// A number that is often hard, often plain, sometimes any bits at all.
fn any<R: Real>(random: &mut Pcg) -> R {
    let table = hard::<R>();
    match random.below(4) {
        0 => table[random.below(table.len())],
        1 => R::from_bits(random.long()),
        _ => R::of(random.within(-2.0, 2.0)),
    }
}

fn eight<R: Real>(random: &mut Pcg) -> [R; LANES] {
    core::array::from_fn(|_| any(random))
}

/// Bits with every NaN the same, as the state hash sees them.
fn bits<R: Real>(values: [R; LANES]) -> [u64; LANES] {
    values.map(Real::bits)
}

/// Compares an operation of three operands on lanes with the same on each lane alone.
fn same<R: Real>(
    name: &str,
    lanes: impl Fn([R::Eight; 3]) -> R::Eight,
    scalar: impl Fn([R; 3]) -> R,
) {
    let mut random = Pcg::new(50);
    for _ in 0..CASES {
        let [a, b, c] = [(); 3].map(|()| eight::<R>(&mut random));
        let together = lanes([a, b, c].map(R::Eight::from_array)).array();
        let alone = core::array::from_fn(|n| scalar([a[n], b[n], c[n]]));
        let (name, scalar) = (name, R::NAME);
        assert_eq!(bits(together), bits(alone), "{scalar} {name}: {a:?} {b:?} {c:?}");
    }
}

/// One source for both sides: what a kernel writes.
macro_rules! same {
    ($name:ident, $f:expr) => {
        #[test]
        fn $name() {
            same::<f32>(stringify!($name), $f, $f);
            same::<f64>(stringify!($name), $f, $f);
        }
    };
}

same!(sums_are_the_same, |[a, b, _]| a + b);
same!(differences_are_the_same, |[a, b, _]| a - b);
same!(products_are_the_same, |[a, b, _]| a * b);
same!(quotients_are_the_same, |[a, b, _]| a / b);
same!(negatives_are_the_same, |[a, _, _]| -a);
same!(products_and_sums_are_never_fused, |[a, b, c]| a * b + c);
same!(roots_are_the_same, |[a, _, _]| Num::root(a));
same!(the_larger_is_the_same, |[a, b, _]| Num::larger(a, b));
same!(the_smaller_is_the_same, |[a, b, _]| Num::smaller(a, b));
same!(magnitudes_are_the_same, |[a, _, _]| Num::magnitude(a));
same!(picks_are_the_same, |[a, b, c]| Num::pick_less(a, b, c, a));

fn constants<R: Real>() {
    for value in [0.0, -0.0, 0.1, -1e-42, 1e300, f64::INFINITY, f64::NAN] {
        let expected = [R::of(value).bits(); LANES];
        assert_eq!(bits(R::Eight::of(value).array()), expected, "{value}");
        assert_eq!(bits(R::Eight::all(R::of(value)).array()), expected, "{value}");
    }
    assert_eq!(bits(R::Eight::zero().array()), [R::ZERO.bits(); LANES], "zero");
    assert_eq!(bits(R::Eight::one().array()), [R::of(1.0).bits(); LANES], "one");
}

#[test]
fn constants_are_the_same_in_every_lane() {
    constants::<f32>();
    constants::<f64>();
}

fn order_of_sums<R: Real>() {
    let mut random = Pcg::new(51);
    let mut ordered = 0;
    for case in 0..CASES {
        let plain = core::array::from_fn(|_| R::of(random.within(-2.0, 2.0) / 3.0));
        let v = if case % 2 == 0 { plain } else { eight::<R>(&mut random) };
        let [a, b, c, d, e, f, g, h] = v;
        let found = R::Eight::from_array(v).sum();
        let expected = ((a + b) + (c + d)) + ((e + f) + (g + h));
        assert_eq!(found.bits(), expected.bits(), "{v:?}");
        let in_a_row = v[1..].iter().fold(a, |s, &x| s + x);
        ordered += usize::from(in_a_row.bits() != expected.bits());
    }
    assert!(ordered > CASES / 5, "the order shows in the bits");
}

#[test]
fn eight_lanes_are_summed_in_the_order_written_down() {
    order_of_sums::<f32>();
    order_of_sums::<f64>();
}

fn order_of_largest<R: Real>() {
    let mut random = Pcg::new(52);
    for _ in 0..CASES {
        let v = eight::<R>(&mut random);
        let [a, b, c, d, e, f, g, h] = v;
        let expected = a.larger(b).larger(c.larger(d)).larger(e.larger(f).larger(g.larger(h)));
        assert_eq!(R::Eight::from_array(v).largest().bits(), expected.bits(), "{v:?}");
    }
}

#[test]
fn the_largest_lane_is_found_in_the_order_written_down() {
    order_of_largest::<f32>();
    order_of_largest::<f64>();
    let plain = [3.0, -7.0, 2.0, 9.5, -0.0, 9.25, 1.0, 0.0];
    assert_eq!(<f64 as Real>::Eight::from_array(plain).largest(), 9.5);
}

/// `self` only where the comparison holds; NaN and equal zeros give the other.
fn choice<R: Real>() {
    let [zero, minus, one, nan] = [0.0, -0.0, 1.0, f64::NAN].map(R::of);
    let table = [
        (one, zero, one, zero),
        (zero, one, one, zero),
        (minus, zero, zero, zero),
        (zero, minus, minus, minus),
        (nan, one, one, one),
        (one, nan, nan, nan),
    ];
    for (a, b, larger, smaller) in table {
        assert_eq!(a.larger(b).bits(), larger.bits(), "the larger of {a:?} and {b:?}");
        assert_eq!(a.smaller(b).bits(), smaller.bits(), "the smaller of {a:?} and {b:?}");
    }
    assert_eq!(R::pick_less(nan, one, one, zero).bits(), zero.bits(), "NaN is not less");
    assert_eq!(R::pick_less(minus, zero, one, zero).bits(), zero.bits(), "nor is -0");
}

#[test]
fn the_other_is_chosen_where_nothing_is_larger() {
    choice::<f32>();
    choice::<f64>();
}

fn loads_and_stores<R: Real>() {
    let from: Vec<R> = (0..12).map(|n| R::of(f64::from(n))).collect();
    for at in 0..20 {
        let loaded = R::Eight::load(&from, at).array();
        let inside = at + LANES <= from.len();
        for (n, v) in loaded.into_iter().enumerate() {
            assert_eq!(v, if inside { from[at + n] } else { R::ZERO }, "lane {n} from {at}");
        }
        let mut to = vec![R::of(-1.0); 12];
        R::Eight::load(&from, 2).store(&mut to, at);
        let written = to.iter().filter(|v| **v != R::of(-1.0)).count();
        assert_eq!(written, if inside { LANES } else { 0 }, "lanes stored at {at}");
    }
    assert_eq!(R::Eight::load(&from, usize::MAX).array(), [R::ZERO; LANES], "far outside");
}

#[test]
fn reading_outside_gives_zeros_and_writing_there_does_nothing() {
    loads_and_stores::<f32>();
    loads_and_stores::<f64>();
}

fn transposes<R: Real>() {
    let mut random = Pcg::new(53);
    let rows: [[R; LANES]; LANES] = core::array::from_fn(|_| eight(&mut random));
    let columns = R::Eight::transpose(rows.map(R::Eight::from_array)).map(|c| c.array());
    for (r, row) in rows.iter().enumerate() {
        for (c, value) in row.iter().enumerate() {
            assert_eq!(columns[c][r].bits(), value.bits(), "row {r}, column {c}");
        }
    }
}

#[test]
fn rows_become_columns() {
    transposes::<f32>();
    transposes::<f64>();
}

/// What the kernels of a step make of three vectors.
fn kernels<T: Num>([a, b, c]: [V3<T>; 3]) -> Vec<T> {
    let edge = isometry::edge(a, T::of(0.7), T::of(4000.0), false);
    let star = Star::new(a, [b, c, a + c, b - c]).rows([T::of(0.5), T::of(2.0), T::of(3.0)]);
    let bend = bending::gradient(bending::second(a, b, c, T::of(1.3)), T::of(0.9));
    let touch = contact::gradient(V2([a.0[0], b.0[1]]), c.xy(), a.0[2], T::of(4000.0));
    let vectors = [edge.gradient, bend, a.cross(b), -c];
    let rows = star.iter().flat_map(|r| r.gradient).chain(vectors).flat_map(|v| v.0);
    let scalars = [edge.value, a.dot(b), c.norm(), touch.0[0], touch.cross(V2([T::one(); 2]))];
    let values = star.iter().map(|r| r.value).chain(scalars);
    rows.chain(edge.hessian.into_iter().flatten()).chain(values).collect()
}

fn whole_kernels<R: Real>() {
    let mut random = Pcg::new(54);
    for _ in 0..CASES {
        let rows: [[V3<R>; 3]; LANES] =
            core::array::from_fn(|_| [(); 3].map(|()| V3([(); 3].map(|()| any(&mut random)))));
        let lanes = |n: usize, c: usize| R::Eight::from_array(rows.map(|r| r[n].0[c]));
        let together = kernels(core::array::from_fn(|n| V3([0, 1, 2].map(|c| lanes(n, c)))));
        for (lane, row) in rows.into_iter().enumerate() {
            let found = together.iter().map(|v| v.array()[lane].bits());
            let alone = kernels(row).into_iter().map(Real::bits);
            assert!(found.eq(alone), "{} lane {lane}: {row:?}", R::NAME);
        }
    }
}

#[test]
fn whole_kernels_on_eight_rows_are_the_same_as_on_one() {
    whole_kernels::<f32>();
    whole_kernels::<f64>();
}

#[test]
fn a_lane_that_differs_by_one_bit_is_caught() {
    let one = [1.0_f64; LANES];
    let mut other = one;
    other[5] = f64::from_bits(1.0_f64.to_bits() + 1);
    assert_ne!(bits(one), bits(other));
    assert_ne!(bits([0.0; LANES]), bits([-0.0; LANES]), "the sign of zero is seen");
    let payload = f64::from_bits(f64::NAN.to_bits() | 1 << 63 | 7);
    assert_eq!(f64::NAN.bits(), payload.bits(), "NaN is canonical");
}
