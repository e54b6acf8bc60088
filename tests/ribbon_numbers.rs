//! Promise: a ribbon is isometric by construction, the same in both precisions for as long as it is not chaotic, the same
//! bits each time, and as large as it says.

use dogleaf_core::effect::ribbon::{Closure, Ribbon, RibbonSpec, Root};
use dogleaf_core::real::Real;
use dogleaf_tests::ribbons::{helix, open, pulled, spec, stretch, twist};

/// The largest distance between the vertices of two ribbons.
fn apart<A: Real, B: Real, const N: usize>(a: &Ribbon<A, N>, b: &Ribbon<B, N>) -> f64 {
    let pairs = a.pairs().flatten().zip(b.pairs().flatten());
    let gap = |(x, y): (dogleaf_core::real::V3<A>, dogleaf_core::real::V3<B>)| {
        (0..3).map(|i| (x.0[i].wide() - y.0[i].wide()).abs()).fold(0.0, f64::max)
    };
    pairs.map(gap).fold(0.0, f64::max)
}

#[test]
fn rims_keep_their_lengths() {
    let mut double = helix::<f64, 50>(&spec(50));
    let mut single = helix::<f32, 50>(&spec(50));
    for _ in 0..50 {
        double.step(0.01);
        single.step(0.01);
        assert!(stretch(&double) < 1e-12, "{}", stretch(&double));
        // One rounding of a coordinate of a metre is 6e-8, and a cell is two centimetres.
        assert!(stretch(&single) * 0.02 < 1e-6, "{}", stretch(&single));
    }
}

/// How far apart single precision ends from double, of twelve ribbons after so many steps.
fn parted(steps: u32) -> Vec<f64> {
    let ribbon = |k: i32| {
        let stiff = RibbonSpec { rigidity_nm: 0.03 * 1.2_f64.powi(k), ..spec(50) };
        let (mut double, mut single) = (helix::<f64, 50>(&stiff), helix::<f32, 50>(&stiff));
        for _ in 0..steps {
            double.step(0.01);
            single.step(0.01);
        }
        apart(&double, &single)
    };
    (0..12).map(ribbon).collect()
}

/// A step ends where single precision cannot tell a lower merit: where that is flat, tenths of a millimetre away.
#[test]
fn single_precision_takes_the_same_steps() {
    for steps in [1, 20] {
        let apart = parted(steps);
        let mean = (apart.iter().map(|a| a.ln()).sum::<f64>() / apart.len() as f64).exp();
        let worst = apart.iter().copied().fold(0.0, f64::max);
        println!("{steps} steps: apart by {mean:.1e} m, {worst:.1e} m at most");
        assert!(mean <= 2e-5 && worst <= 1e-3, "{steps} steps: {mean}, {worst}, {apart:?}");
    }
}

#[test]
fn the_same_bits_each_time() {
    let play = || {
        let mut ribbon = helix::<f32, 50>(&spec(50));
        let mut hashes = Vec::new();
        for k in 0..30 {
            twist(&mut ribbon, 0.05 * f64::from(k), 1.0);
            ribbon.step(0.01);
            hashes.push(ribbon.state_hash());
        }
        let mut band = pulled::<f32, 50>(50, Closure::Moebius, 10.0);
        band.step(0.01);
        hashes.push(band.state_hash());
        hashes
    };
    let (first, second) = (play(), play());
    assert_eq!(first, second, "equal inputs, equal bits");
    assert!(first.windows(2).all(|w| w[0] != w[1]), "and the hash sees every step");
}

#[test]
fn other_seeds_are_other_ribbons() {
    let hash = |seed| open::<f32, 50>(&RibbonSpec { seed, ..spec(50) }).state_hash();
    assert_ne!(hash(1), hash(2), "the perturbation is the seed's");
}

#[test]
fn a_free_ribbon_falls_as_a_stone() {
    let free = RibbonSpec { root: Root::Free, ..spec(50) };
    let mut ribbon = helix::<f64, 50>(&free);
    let height = |r: &Ribbon<f64, 50>| {
        let pairs: Vec<_> = r.pairs().map(|p| 0.5 * (p[0].0[1] + p[1].0[1])).collect();
        pairs.windows(2).map(|w| 0.5 * (w[0] + w[1])).sum::<f64>() / 50.0
    };
    let before = height(&ribbon);
    for _ in 0..50 {
        ribbon.step(0.01);
    }
    // Implicit Euler falls half a step further.
    let wanted = -0.5 * 9.81 * 0.5 * (0.5 + 0.01);
    let fell = height(&ribbon) - before;
    assert!((fell / wanted - 1.0).abs() < 0.02, "{fell} against {wanted}");
}

#[test]
fn it_is_as_large_as_it_says() {
    let single = size_of::<Ribbon<f32, 150>>();
    let double = size_of::<Ribbon<f64, 150>>();
    println!("150 segments: {single} B in f32, {double} B in f64");
    assert!(single <= 92_000 && double <= 184_000, "{single}, {double}");
}
