//! The index buffer: filled once, true for every frame.

use super::layout::{Layout, MeshError, Patch, Surface, enough};
use crate::grid::Grid;

/// Fills the indices of all parts, three a triangle, counter-clockwise seen from outside.
///
/// # Shapes and units
///
/// `out`: at least [`Layout::INDICES`]. Draw [`Part::indices`](super::Part::indices) of the visible parts.
///
/// # Errors
///
/// [`MeshError::TooSmall`]: nothing was written.
pub fn indices<G: Grid>(out: &mut [u16]) -> Result<(), MeshError> {
    enough(out.len(), Layout::<G>::INDICES)?;
    let counts = Layout::<G>::counts();
    for (part, surface) in counts.parts.iter().zip(Surface::ALL) {
        let mut base = part.vertices.start;
        let mut triangles =
            out.get_mut(part.indices.clone()).unwrap_or_default().chunks_exact_mut(3);
        for patch in surface.patches::<G>() {
            for (corners, slots) in corners(base, patch).zip(triangles.by_ref()) {
                for (slot, corner) in slots.iter_mut().zip(corners) {
                    *slot = corner as u16;
                }
            }
            base += patch.columns * patch.rows;
        }
    }
    Ok(())
}

/// The corners of a patch's triangles.
fn corners(base: usize, patch: Patch) -> impl Iterator<Item = [usize; 3]> {
    let Patch { columns, rows, flip } = patch;
    let cells = (1..columns).flat_map(move |j| (1..rows).map(move |r| (j, r)));
    cells.flat_map(move |(j, r)| {
        let c = base + j * rows + r;
        let (a, b, d) = (c - rows - 1, c - 1, c - rows);
        let turn = |[x, y, z]: [usize; 3]| if flip { [x, z, y] } else { [x, y, z] };
        [turn([a, b, c]), turn([a, c, d])]
    })
}
