//! Materials: what a caller says about a surface, and what the light needs to know of a point on it.

mod edges;
mod noise;
mod table;

use glam::{Vec2, Vec3};

use crate::shade::passing;
use crate::texture::{Footprint, Texture};

/// Extinction of paper, 1/m: a sheet of 0.1 mm then passes a quarter of the light.
pub const PAPER_ALPHA: f32 = 14_000.0;

/// How a surface looks.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Material<'a> {
    /// A printed side of a leaf, or the uppermost page of a block.
    Paper {
        /// The picture on this side; none is a blank page.
        front: Option<&'a Texture>,
        /// The picture on the other side, as its own reader sees it; it shines through.
        back: Option<&'a Texture>,
        /// Thickness the light has to pass, metres; infinite for a page of a block.
        thickness_m: f32,
        /// Extinction `α`, 1/m; [`PAPER_ALPHA`] for office paper.
        alpha: f32,
        /// Colour of the bare paper, linear RGB.
        tint: Vec3,
        /// Perceived roughness, 0..1; paper is about 0.8.
        roughness: f32,
    },
    /// The cut sides of a page block: leaf upon leaf. `uv.y` runs 0..1 across the leaves, `uv.x`
    /// along them.
    PageEdges {
        /// Leaves in the stack.
        leaves: f32,
        /// Colour of the bare paper, linear RGB.
        tint: Vec3,
    },
    /// A board covered in cloth.
    Board {
        /// Colour of the cloth, linear RGB.
        colour: Vec3,
        /// Perceived roughness, 0..1.
        roughness: f32,
    },
    /// The table beneath. It receives shadows and casts none.
    Table {
        /// Mean colour, linear RGB.
        colour: Vec3,
        /// How much the grain of the wood shows, 0 (felt) to 1.
        grain: f32,
    },
}

impl Material<'_> {
    /// Paper of a usual book: a little warm, rough, a quarter of the light passes.
    #[must_use]
    pub fn paper<'a>(
        front: Option<&'a Texture>,
        back: Option<&'a Texture>,
        thickness_m: f32,
    ) -> Material<'a> {
        Material::Paper {
            front,
            back,
            thickness_m,
            alpha: PAPER_ALPHA,
            tint: PAPER_TINT,
            roughness: 0.8,
        }
    }

    /// Whether the surface keeps light from others.
    pub(crate) fn casts(&self) -> bool {
        !matches!(self, Material::Table { .. })
    }

    /// What is the same all over a patch.
    pub(crate) fn paint(&self) -> Paint {
        match *self {
            Material::Paper { thickness_m, alpha, tint, roughness, .. } => {
                // Far below what a byte can show counts as nothing and saves the way to the far side.
                let passing = passing(alpha, thickness_m);
                let passing = if passing < 1e-3 { 0.0 } else { passing };
                Paint { pale: tint, roughness, passing, thickness_m: thickness_m.clamp(0.0, 0.001) }
            }
            Material::PageEdges { tint, .. } => Paint::solid(tint, 0.9),
            Material::Board { colour, roughness } => Paint::solid(colour, roughness),
            Material::Table { colour, .. } => Paint::solid(colour, 0.8),
        }
    }

    /// Colours at one point; `thin` if light passes through.
    pub(crate) fn at(&self, spot: &Spot, thin: bool) -> Optics {
        match *self {
            Material::Paper { front, back, tint, .. } => {
                let (near, far) = if spot.outside { (front, back) } else { (back, front) };
                let foot = if spot.outside { spot.foot } else { spot.foot.mirrored() };
                let albedo = near.map_or(tint, |t| tint * t.sample(&foot));
                // The paper blurs what shines through: the plain filter will do.
                let reverse = match far {
                    Some(t) if thin => t.sample_soft(foot.mirrored().uv, t.texels(&foot)),
                    _ => Vec3::ONE,
                };
                Optics { albedo, through: tint * albedo * reverse }
            }
            Material::PageEdges { leaves, tint } => {
                Optics::solid(edges::colour(leaves, tint, &spot.foot))
            }
            Material::Board { colour, .. } => {
                Optics::solid(colour * noise::cloth(spot.position, spot.pixel_m))
            }
            Material::Table { colour, grain } => Optics::solid(colour * table::shade(grain, spot)),
        }
    }
}

/// Colour of bare paper in [`Material::paper`].
pub const PAPER_TINT: Vec3 = Vec3::new(0.905, 0.885, 0.835);

/// A point on a surface as a material sees it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spot {
    /// World place, metres.
    pub(crate) position: Vec3,
    /// Texture place and what the pixel covers of it.
    pub(crate) foot: Footprint,
    /// Side of the pixel on the surface, metres.
    pub(crate) pixel_m: f32,
    /// Whether the eye is on the side the triangles face.
    pub(crate) outside: bool,
}

/// Colours of a point on a surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Optics {
    /// Of the light scattered back.
    pub(crate) albedo: Vec3,
    /// Of the light let through.
    pub(crate) through: Vec3,
}

impl Optics {
    /// A surface that lets nothing through.
    fn solid(albedo: Vec3) -> Self {
        Self { albedo, through: Vec3::ZERO }
    }
}

/// What of a material is the same all over a patch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Paint {
    /// Colour apart from print and grain.
    pub(crate) pale: Vec3,
    /// Perceived roughness.
    pub(crate) roughness: f32,
    /// Share let through, `e^(-α t)`.
    pub(crate) passing: f32,
    /// Way to the far side, metres, at most a millimetre.
    pub(crate) thickness_m: f32,
}

impl Paint {
    /// Lets nothing through.
    fn solid(pale: Vec3, roughness: f32) -> Self {
        Self { pale, roughness, passing: 0.0, thickness_m: 0.0 }
    }
}

/// Longest change of `uv` along one pixel's side, by component.
fn reach(foot: &Footprint) -> Vec2 {
    foot.dx.abs().max(foot.dy.abs())
}
