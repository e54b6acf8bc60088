//! How far a leaf has left the page beneath: what a renderer needs to know before light shines through it.

use super::Vertex;
use super::layout::Layout;
use crate::grid::Grid;
use crate::real::Num;

/// Mean gap at which a leaf counts as free, as a share of its width.
const FREE: f32 = 0.12;

/// How far a leaf has left the page beneath, 0 to 1, from the mean gap between the two: both have the same columns.
/// What passes a leaf that lies comes back from the page.
///
/// # Shapes and units
///
/// `leaf`: the vertices of [`Surface::LeafUp`](super::Surface). `block`: those of the top of the block that
/// [`lies_beneath`] names; none if that is not there.
pub fn free<G: Grid>(leaf: &[Vertex], block: &[Vertex]) -> f32 {
    let [x, y, _] = leaf.last().map_or([0.0; 3], |v| v.position);
    let gaps = leaf.chunks_exact(Layout::<G>::ROWS).enumerate().flat_map(|(column, line)| {
        let floor = block.get(2 * column).map_or(0.0, |v| v.position[1]);
        line.iter().map(move |v| (v.position[1] - floor).magnitude())
    });
    let mean = gaps.sum::<f32>() / leaf.len().max(1) as f32;
    let width = (x * x + y * y).root().larger(1e-3);
    let t = (mean / (FREE * width)).smaller(1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The top of the block a leaf leans over.
pub fn lies_beneath(leaf: &[Vertex]) -> super::Surface {
    let left = leaf.last().is_some_and(|v| v.position[0] < 0.0);
    if left { super::Surface::LeftTop } else { super::Surface::RightTop }
}
