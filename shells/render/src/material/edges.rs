//! The cut side of a page block: one thin line a leaf.

use glam::Vec3;

use super::noise::{hash, survives, value};
use super::reach;
use crate::fast::floor;
use crate::texture::Footprint;

/// Colour at a place of the stack.
///
/// The leaves are drawn as noise across the stack in octaves, from single leaves up to whole
/// quires. An octave finer than a pixel fades to its mean, so that the lines neither flicker nor make
/// moiré however far the book is, and some of them are seen at any distance.
pub(super) fn colour(leaves: f32, tint: Vec3, foot: &Footprint) -> Vec3 {
    let leaves = leaves.clamp(1.0, 20_000.0);
    let pixel = reach(foot).y * leaves;
    // No stack is cut perfectly: leaves wander a little along their length.
    let place = foot.uv.y * leaves + 1.2 * (value(foot.uv.x * 9.0, foot.uv.y * 6.0) - 0.5);
    let gap = gap(place) * survives(1.0, pixel);
    let mut shade = 0.0;
    let mut period = 1.0;
    for octave in 0..7 {
        let weight = 0.15 * survives(2.0 * period, pixel);
        let along = foot.uv.x * (14.0 / (1.0 + octave as f32));
        shade += weight * (value(place / period, along + 17.0 * octave as f32) - 0.5);
        period *= 2.0;
    }
    // Gaps too fine to see still take light away.
    tint * (0.90 + shade - 0.20 * gap)
}

/// Darkness of the slit between two leaves, 0..1, wider for some leaves than for others.
fn gap(place: f32) -> f32 {
    let leaf = floor(place);
    let away = (place - leaf as f32 - 0.5).abs() * 2.0;
    let width = 0.25 + 0.5 * hash(leaf, 3);
    ((away - (1.0 - width)) / width).clamp(0.0, 1.0)
}
