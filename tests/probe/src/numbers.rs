//! Operations of the room `real`: one number, eight lanes, vectors.

use crate::fold::Fold;
use crate::random::Random;
use crate::work::Pick;
use crate::{CASES, Row};
use dogleaf_core::real::{Eight, LANES, Lanes, Num, Real, V2, V3};
use dogleaf_core::state::Fnv;

/// All of them.
pub(crate) fn table<R: Pick>() -> [Row; 19] {
    [
        ("real.arithmetic", |_| {
            two::<R>("arithmetic", |a, b, f| {
                [a + b, a - b, a * b, a / b, -a].into_iter().for_each(|v| f.real(v));
            })
        }),
        ("real.of_wide_narrow", |_| {
            one::<R>("casts", |a, f| {
                f.word(a.wide().to_bits() & ignore_nan(a.wide()));
                f.real(a.narrow());
                f.real(R::of(a.wide()));
            })
        }),
        ("real.root", |_| one::<R>("root", |a, f| f.real(a.magnitude().root()))),
        ("real.sine", |_| one::<R>("sine", |a, f| f.real(a.sine()))),
        ("real.cosine", |_| one::<R>("cosine", |a, f| f.real(a.cosine()))),
        ("real.exponential", |_| one::<R>("exponential", |a, f| f.real(a.exponential()))),
        ("real.larger", |_| two::<R>("larger", |a, b, f| f.real(a.larger(b)))),
        ("real.smaller", |_| two::<R>("smaller", |a, b, f| f.real(a.smaller(b)))),
        ("real.magnitude", |_| one::<R>("magnitude", |a, f| f.real(a.magnitude()))),
        ("real.finite", |_| one::<R>("finite", |a, f| f.word(u64::from(a.finite())))),
        ("lanes.arithmetic", |_| {
            pair::<R>("lanes.arithmetic", |a, b, f| {
                [a + b, a - b, a * b, a / b, -a].into_iter().for_each(|v| f.lanes::<R>(v));
            })
        }),
        ("lanes.root", |_| pair::<R>("lanes.root", |a, _, f| f.lanes::<R>(a.magnitude().root()))),
        ("lanes.larger_smaller", |_| {
            pair::<R>("lanes.larger", |a, b, f| {
                f.lanes::<R>(a.larger(b));
                f.lanes::<R>(a.smaller(b));
            })
        }),
        ("lanes.pick_less", |_| {
            pair::<R>("lanes.pick_less", |a, b, f| {
                f.lanes::<R>(R::Eight::pick_less(a, b, a + b, a - b));
            })
        }),
        ("lanes.sum", |_| pair::<R>("lanes.sum", |a, _, f| f.real(a.sum()))),
        ("lanes.largest", |_| pair::<R>("lanes.largest", |a, _, f| f.real(a.largest()))),
        ("lanes.transpose", |_| transpose::<R>()),
        ("vectors", |_| vectors::<R>()),
        ("state.hash", |_| fnv::<R>()),
    ]
}

/// Bits of a NaN are the target's own; that it is one is not.
fn ignore_nan(value: f64) -> u64 {
    if value.is_nan() { 0x7ff0_0000_0000_0000 } else { u64::MAX }
}

fn one<R: Real>(name: &str, run: fn(R, &mut Fold)) -> u64 {
    let (mut random, mut fold) = (Random::named(name), Fold::START);
    for _ in 0..CASES {
        run(random.wild(), &mut fold);
    }
    fold.value()
}

fn two<R: Real>(name: &str, run: fn(R, R, &mut Fold)) -> u64 {
    let (mut random, mut fold) = (Random::named(name), Fold::START);
    for _ in 0..CASES {
        let a = random.wild();
        run(a, random.wild(), &mut fold);
    }
    fold.value()
}

fn pair<R: Real>(name: &str, run: fn(R::Eight, R::Eight, &mut Fold)) -> u64 {
    let (mut random, mut fold) = (Random::named(name), Fold::START);
    for _ in 0..CASES / LANES {
        let a = R::Eight::from_array(random.eight());
        run(a, R::Eight::from_array(random.eight()), &mut fold);
    }
    fold.value()
}

fn transpose<R: Real>() -> u64 {
    let (mut random, mut fold) = (Random::named("transpose"), Fold::START);
    for _ in 0..CASES / LANES {
        let rows = core::array::from_fn(|_| R::Eight::from_array(random.eight()));
        R::Eight::transpose(rows).into_iter().for_each(|v| fold.lanes::<R>(v));
    }
    fold.value()
}

fn vectors<R: Real>() -> u64 {
    let (mut random, mut fold) = (Random::named("vectors"), Fold::START);
    for _ in 0..CASES {
        let mut v = || V3([random.wild::<R>(), random.wild(), random.wild()]);
        let (a, b) = (v(), v());
        fold.v3(a.cross(b));
        fold.real(a.dot(b));
        fold.real(a.norm());
        let (p, q): (V2<R>, V2<R>) = (a.xy(), b.xy());
        fold.v2(p.left());
        fold.real(p.cross(q));
    }
    fold.value()
}

fn fnv<R: Real>() -> u64 {
    let (mut random, mut hash) = (Random::named("fnv"), Fnv::default());
    for _ in 0..CASES {
        hash.real(random.wild::<R>());
        hash.word(u64::from(random.next()));
    }
    hash.value()
}
