//! The midline: a chain's step, its collision, a block's outline.

use crate::Row;
use crate::fold::Fold;
use crate::random::Random;
use crate::work::Pick;
use dogleaf_core::collision::Profile;
use dogleaf_core::collision::block::{self, Ground};
use dogleaf_core::real::Real;
use dogleaf_core::state::strip::{BLOCK, BOARD, Fibre, Strip};
use dogleaf_core::step::strip::{StripAsk, step};

/// Chains of each operation here; a chain of seven nodes is twelve unknowns.
const CHAINS: usize = 200;

/// All of them.
pub(crate) fn table<R: Pick>() -> [Row; 3] {
    [
        ("step.strip", |_| each::<R>("step.strip", moved)),
        ("collision.block", |_| each::<R>("collision.block", lifted)),
        ("collision.profile", |_| each::<R>("collision.profile", outlined)),
    ]
}

fn each<R: Real>(name: &str, run: fn(&mut Random, &mut Fold, Strip<R, BLOCK>)) -> u64 {
    let (mut random, mut fold) = (Random::named(name), Fold::START);
    for _ in 0..CHAINS {
        let strip = random_strip(&mut random);
        run(&mut random, &mut fold, strip);
    }
    fold.value()
}

fn random_strip<R: Real, const N: usize>(random: &mut Random) -> Strip<R, N> {
    let mut strip = Strip::ZERO;
    strip.lay(R::of(0.2), R::of(10.0));
    for n in 1..N {
        strip.x[n] = strip.x[n] + random.v2(0.4);
        strip.v[n] = random.v2(3.0);
        strip.pushed[n] = random.v2(1.0);
        strip.offset[n] = random.within(1.0);
        strip.holding[n] = R::of(f64::from(random.below(2)));
    }
    strip
}

/// The outline of a block that is not quite flat.
pub(crate) fn random_profile<R: Real>(random: &mut Random) -> Profile<R> {
    let strip = random_strip(random);
    Profile::new(&strip, R::of(0.4) + random.within(0.3))
}

fn fold_strip<R: Real, const N: usize>(strip: &Strip<R, N>, fold: &mut Fold) {
    strip.x.iter().chain(&strip.v).chain(&strip.pushed).for_each(|&v| fold.v2(v));
    strip.offset.iter().chain(&strip.holding).for_each(|&v| fold.real(v));
}

fn moved<R: Real>(random: &mut Random, fold: &mut Fold, mut block: Strip<R, BLOCK>) {
    let ask = StripAsk {
        h: R::of(1.0 / 60.0),
        keep: R::of(0.98),
        gravity: random.v2(600.0),
        delta: R::of(1e-6),
        contact: R::of(4000.0),
    };
    let mut board = random_strip::<R, BOARD>(random);
    let edge = |n: usize| R::of(10.0 / (n - 1) as f64);
    let fibre = Fibre { edge: edge(BLOCK), mass: R::of(0.1), bend: R::of(1.5), glue: R::of(20.0) };
    fold.word(u64::from(step::<R, BLOCK, { 2 * (BLOCK - 1) }>(&mut block, &fibre, &ask)));
    let fibre = Fibre { edge: edge(BOARD), ..fibre };
    fold.word(u64::from(step::<R, BOARD, { 2 * (BOARD - 1) }>(&mut board, &fibre, &ask)));
    fold_strip(&block, fold);
    fold_strip(&board, fold);
}

fn lifted<R: Real>(random: &mut Random, fold: &mut Fold, mut block: Strip<R, BLOCK>) {
    let before = block.x;
    let board = random_strip::<R, BOARD>(random);
    for ground in [Ground::table(), Ground::board(&board)] {
        fold.word(u64::from(block::resolve(&mut block, &ground)));
    }
    block::velocities(&mut block, &before, R::of(1.0 / 60.0));
    fold_strip(&block, fold);
}

fn outlined<R: Real>(random: &mut Random, fold: &mut Fold, block: Strip<R, BLOCK>) {
    let profile = Profile::new(&block, R::of(0.5));
    let above = R::of(0.6) + random.within(0.5);
    profile.outline(above).into_iter().for_each(|v| fold.v2(v));
    fold.v2(profile.root(above));
    fold.v2(profile.surface(above, R::of(5.0) + random.within(6.0)));
}
