//! The factors of Eq. 15-17 and the lobes they weigh.

use std::f32::consts::PI;

use dogleaf_render::PAPER_ALPHA;
use dogleaf_render::shade::{
    PAPER_IOR, cook_torrance, environment_share, factors, ggx, normal_reflectance, passing,
    schlick, smith,
};

#[test]
fn no_light_is_made() {
    let f0 = normal_reflectance(PAPER_IOR);
    for i in 0..=20 {
        for j in 0..=20 {
            let fresnel = schlick(f0, i as f32 / 20.0);
            let k = factors(fresnel, fresnel, j as f32 / 20.0);
            let sum = k.diffuse + k.specular + k.transmitted;
            assert!((sum - 1.0).abs() < 1e-6, "cos {i}/20, passing {j}/20: sum {sum}");
            assert!(
                k.diffuse >= 0.0 && k.specular >= 0.0 && k.transmitted >= 0.0,
                "all shares are positive"
            );
        }
    }
}

#[test]
fn equations_16_and_17_literally() {
    let (f, f_back, alpha, t) = (0.1_f32, 0.3_f32, 9000.0_f32, 0.000_12_f32);
    let k = factors(f, f_back, passing(alpha, t));
    assert!((k.transmitted - (1.0 - f_back) * (-alpha * t).exp()).abs() < 1e-7, "k_t");
    assert!((k.diffuse - (1.0 - f) * (1.0 - (-alpha * t).exp())).abs() < 1e-7, "k_d");
    assert!((k.specular - f).abs() < 1e-7, "k_s");
}

#[test]
fn thick_paper_is_opaque_and_no_paper_is_clear() {
    assert_eq!(passing(PAPER_ALPHA, f32::INFINITY), 0.0, "a block lets nothing through");
    assert_eq!(passing(PAPER_ALPHA, 0.0), 1.0, "nothing keeps nothing");
    assert_eq!(passing(PAPER_ALPHA, -1.0), 1.0, "less than nothing neither");
    assert_eq!(passing(0.0, f32::INFINITY), 0.0, "undefined counts as opaque");
    let sheet = passing(PAPER_ALPHA, 0.000_1);
    assert!((0.2..0.3).contains(&sheet), "office paper passes about a quarter, not {sheet}");
}

#[test]
fn fresnel_runs_from_four_percent_to_all() {
    let f0 = normal_reflectance(PAPER_IOR);
    assert!((f0 - 0.04).abs() < 1e-6, "glass-like size mirrors 4 %, not {f0}");
    assert_eq!(schlick(f0, 1.0), f0, "head on");
    assert_eq!(schlick(f0, 0.0), 1.0, "grazing");
    assert_eq!(schlick(f0, -2.0), 1.0, "from below counts as grazing");
}

/// Mean over the hemisphere of `f` of the direction's height, times its solid angle.
fn hemisphere(f: impl Fn(f32) -> f32) -> f32 {
    let n = 20_000;
    (0..n).map(|i| f((i as f32 + 0.5) / n as f32)).sum::<f32>() / n as f32 * 2.0 * PI
}

#[test]
fn ggx_is_a_density() {
    for roughness in [0.4_f32, 0.6, 0.8, 1.0] {
        let sum = hemisphere(|cos| ggx(cos, roughness.powi(4)) * cos);
        assert!((sum - 1.0).abs() < 0.01, "roughness {roughness}: {sum}");
    }
}

#[test]
fn smith_only_masks() {
    for i in 0..=20 {
        let g = smith(i as f32 / 20.0, 0.3);
        assert!((0.0..=1.0).contains(&g), "cos {i}/20: {g}");
    }
    assert!((smith(1.0, 0.3) - 1.0).abs() < 1e-6, "nothing is masked head on");
}

/// Light a lobe sends to `view` from a white room, by summing over directions.
fn summed(f0: f32, roughness: f32, n_v: f32) -> f32 {
    let (n, view) = (256, [(1.0 - n_v * n_v).sqrt(), n_v, 0.0]);
    let mut sum = 0.0;
    for i in 0..n {
        for j in 0..n {
            let (y, turn) = ((i as f32 + 0.5) / n as f32, (j as f32 + 0.5) / n as f32 * 2.0 * PI);
            let r = (1.0 - y * y).sqrt();
            let half = [view[0] + r * turn.cos(), view[1] + y, r * turn.sin()];
            let length = (half[0] * half[0] + half[1] * half[1] + half[2] * half[2]).sqrt();
            let v_h = (half[0] * view[0] + half[1] * view[1]) / length;
            sum += schlick(f0, v_h) * cook_torrance(y, n_v, half[1] / length, roughness) * y;
        }
    }
    sum * 2.0 * PI / (n * n) as f32
}

#[test]
fn the_split_sum_is_close_to_the_sum() {
    for (roughness, allowed) in [(0.5, 0.04), (0.7, 0.02), (0.9, 0.02)] {
        for n_v in [0.2, 0.5, 0.9] {
            let (fit, truth) =
                (environment_share(0.04, roughness, n_v), summed(0.04, roughness, n_v));
            assert!(
                (fit - truth).abs() < allowed,
                "roughness {roughness}, cos {n_v}: {fit} for {truth}"
            );
        }
    }
}
