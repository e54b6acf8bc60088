//! Promise: the table of thresholds is the one the void-and-cluster method gives (Ulichney 1993), its tones are even, and
//! exact greys stay exact.

mod support;

use dogleaf_eink::dither::Depth;
use support::blue_noise;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src/dither/table.rs");

#[test]
fn the_table_is_generated() {
    let text = blue_noise::table();
    if std::env::var_os("DOGLEAF_BLESS").is_some_and(|v| v == "1") {
        std::fs::write(FILE, &text).expect("the table can be written");
    }
    let kept = std::fs::read_to_string(FILE).expect("the table is there").replace("\r\n", "\n");
    assert!(kept == text, "src/dither/table.rs is not what this test generates");
}

#[test]
fn a_tone_is_its_share_of_white() {
    for luma in 0..=255_u8 {
        let white = pixels().filter(|&(x, y)| Depth::TwoTone.level(luma, x, y) == 15).count();
        let share = white as f64 / (32.0 * 32.0) * 255.0;
        assert!((share - f64::from(luma)).abs() <= 1.0, "luma {luma} looks like {share}");
        let sum: u32 = pixels().map(|(x, y)| u32::from(Depth::Sixteen.level(luma, x, y))).sum();
        let mean = f64::from(sum) / (32.0 * 32.0) * 17.0;
        assert!((mean - f64::from(luma)).abs() <= 1.0, "luma {luma} looks like {mean} in greys");
    }
}

#[test]
fn exact_greys_are_exact_everywhere() {
    for level in 0..=15_u8 {
        let wrong = pixels().filter(|&(x, y)| Depth::Sixteen.level(17 * level, x, y) != level);
        assert_eq!(wrong.count(), 0, "grey {level}");
    }
}

/// No tone makes lines: white and black pixels of a mid tone stand alone or in small groups, as they do in noise whose
/// low frequencies were taken out.
#[test]
fn tones_are_free_of_large_groups() {
    for luma in [32, 64, 96, 128, 160, 192, 224] {
        let spread = lumpiness(|x, y| Depth::TwoTone.level(luma, x, y) == 15);
        let bare = lumpiness(|x, y| hash(x, y) % 255 < u32::from(luma));
        assert!(spread < 0.35 * bare, "luma {luma}: {spread} beside {bare} of white noise");
    }
}

/// Variance of the mean of 8x8 pixels.
fn lumpiness(white: impl Fn(u16, u16) -> bool) -> f64 {
    let means: Vec<f64> = pixels()
        .map(|(x0, y0)| {
            let block = (0..64).filter(|n| white((x0 + n % 8) % 32, (y0 + n / 8) % 32));
            block.count() as f64 / 64.0
        })
        .collect();
    let mean = means.iter().sum::<f64>() / means.len() as f64;
    means.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / means.len() as f64
}

fn hash(x: u16, y: u16) -> u32 {
    let mut h = u32::from(x).wrapping_mul(0x9E37_79B1) ^ u32::from(y).wrapping_mul(0x85EB_CA77);
    h ^= h >> 15;
    h = h.wrapping_mul(0xC2B2_AE3D);
    h ^ (h >> 13)
}

fn pixels() -> impl Iterator<Item = (u16, u16)> {
    (0..32).flat_map(|y| (0..32).map(move |x| (x, y)))
}
