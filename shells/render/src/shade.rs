//! The seed's shading: how much of the light is reflected, scattered back and let through.
//!
//! ```text
//! f   = k_d f_Lambert + k_s f_CookTorrance + k_t f_LambertBack        (15)
//! k_t = (1 - F_back) e^(-α t)                                         (16)
//! k_d = (1 - F)(1 - e^(-α t))                                         (17)
//! k_s = F
//! ```
//!
//! | symbol | name here | meaning |
//! |---|---|---|
//! | F | `fresnel` | Schlick's share of mirrored light on the lit side |
//! | F_back | `fresnel_back` | the same where the light enters on the other side |
//! | e^(-α t) | `passing` | share of the entering light that leaves on the other side |
//! | t, α | `thickness_m`, `alpha` | leaf thickness, extinction |
//!
//! Source: Book, Eq. 15-17. Checked by `tests/shading.rs`.

use std::f32::consts::PI;

/// Index of refraction of the size and filler of paper, close to glass.
pub const PAPER_IOR: f32 = 1.5;

/// The three weights of Eq. 15.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// Share scattered back on the lit side.
    pub diffuse: f32,
    /// Share mirrored.
    pub specular: f32,
    /// Share that came in from the other side and leaves here.
    pub transmitted: f32,
}

/// Share of light that leaves a leaf on the other side, `e^(-α t)`.
///
/// # Shapes and units
///
/// `alpha`: 1/metre, `thickness_m`: metres. A leaf of office paper (0.1 mm) passes about a quarter.
///
/// # Errors
///
/// None: the answer is always in [0, 1]; NaN and negative depth count as opaque and as nothing.
#[must_use]
pub fn passing(alpha: f32, thickness_m: f32) -> f32 {
    let depth = alpha * thickness_m;
    if depth.is_nan() { 0.0 } else { (-depth.max(0.0)).exp() }
}

/// Mirrored share at normal incidence, `((n - 1) / (n + 1))²`.
#[must_use]
pub fn normal_reflectance(ior: f32) -> f32 {
    let ratio = (ior - 1.0) / (ior + 1.0);
    ratio * ratio
}

/// Schlick's approximation of the mirrored share.
///
/// ```text
/// F = F0 + (1 - F0)(1 - cos θ)⁵
/// ```
#[must_use]
pub fn schlick(f0: f32, cos: f32) -> f32 {
    let m = 1.0 - cos.clamp(0.0, 1.0);
    let m2 = m * m;
    f0 + (1.0 - f0) * m2 * m2 * m
}

/// The three weights for light that meets the near side with `fresnel` and the far side with
/// `fresnel_back`.
///
/// # Hard case
///
/// The sum is at most 1 when both Fresnel shares agree. When they differ it can reach
/// `1 + passing · (fresnel - fresnel_back)`: the seed's weights belong to light of two sides.
#[must_use]
pub fn factors(fresnel: f32, fresnel_back: f32, passing: f32) -> Factors {
    Factors {
        diffuse: (1.0 - fresnel) * (1.0 - passing),
        specular: fresnel,
        transmitted: (1.0 - fresnel_back) * passing,
    }
}

/// GGX density of microfacet normals, `D`.
///
/// # Shapes and units
///
/// `alpha2`: fourth power of the perceived roughness. `∫ D (n·h) dω = 1` over the hemisphere.
#[must_use]
pub fn ggx(n_h: f32, alpha2: f32) -> f32 {
    let d = n_h * n_h * (alpha2 - 1.0) + 1.0;
    alpha2 / (PI * d * d)
}

/// Smith's masking of one direction for GGX, in [0, 1].
#[must_use]
pub fn smith(n_x: f32, alpha2: f32) -> f32 {
    let c = n_x.max(1e-4);
    2.0 * c / (c + (alpha2 + (1.0 - alpha2) * c * c).sqrt())
}

/// Cook-Torrance lobe without its Fresnel factor (that one is `k_s`): `D G / 4 (n·l)(n·v)`.
#[must_use]
pub fn cook_torrance(n_l: f32, n_v: f32, n_h: f32, roughness: f32) -> f32 {
    let alpha = (roughness * roughness).max(1e-3);
    let alpha2 = alpha * alpha;
    let g = smith(n_l, alpha2) * smith(n_v, alpha2);
    ggx(n_h, alpha2) * g / (4.0 * n_l.max(1e-4) * n_v.max(1e-4))
}

/// Mirrored share of the pre-integrated environment: the second half of the split sum.
///
/// ```text
/// ∫ f_CookTorrance F (n·l) dω  ≈  F0 · a + b
/// ```
///
/// # Accuracy
///
/// A fit in closed form instead of a table; within 0.02 of the integral where paper is (roughness 0.7
/// to 0.9), within 0.04 at 0.5 and a flat view.
///
/// # Source
///
/// The split sum with the fit of the "physically based shading on mobile" course notes.
#[must_use]
pub fn environment_share(f0: f32, roughness: f32, n_v: f32) -> f32 {
    let r = [
        -roughness + 1.0,
        -0.0275 * roughness + 0.0425,
        -0.572 * roughness + 1.04,
        0.022 * roughness - 0.04,
    ];
    let grazing = (-9.28 * n_v).exp2();
    let a = (r[0] * r[0]).min(grazing) * r[0] + r[1];
    (f0 * (-1.04 * a + r[2]) + (1.04 * a + r[3])).clamp(0.0, 1.0)
}
