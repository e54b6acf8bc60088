//! What is drawn: triangles of one material.

use dogleaf_core::mesh::Vertex;

use crate::material::Material;

/// A triangle mesh of one material, borrowed from the caller.
///
/// # Shapes and units
///
/// `indices`: three a triangle, counter-clockwise seen from outside; a triangle with an index out
/// of range, or a corner that is not finite or beyond a thousand kilometres, is left out and counted
/// in [`crate::Stats::refused`].
///
/// # Cost
///
/// That of the vertices between the least and the greatest index: patches may share one buffer.
#[derive(Debug, Clone, Copy)]
pub struct Patch<'a> {
    /// Corners, metres in the book frame.
    pub vertices: &'a [Vertex],
    /// Corners of each triangle.
    pub indices: &'a [u16],
    /// How the surface looks.
    pub material: Material<'a>,
}

impl<'a> Patch<'a> {
    /// The vertices that are used, and the number of the first of them.
    pub(crate) fn used(&self) -> (&'a [Vertex], usize) {
        let least = self.indices.iter().min().map_or(0, |&i| usize::from(i));
        let end = self.indices.iter().max().map_or(0, |&i| usize::from(i) + 1);
        let least = least.min(self.vertices.len());
        (&self.vertices[least..end.clamp(least, self.vertices.len())], least)
    }

    /// Corners of each triangle, counted from the first used vertex; `None` for an unsound one.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = Option<[usize; 3]>> + use<'a> {
        let (used, first) = self.used();
        self.indices.chunks_exact(3).map(move |three| {
            let at =
                [three[0], three[1], three[2]].map(|i| usize::from(i) - first.min(usize::from(i)));
            at.iter().all(|&i| used.get(i).is_some_and(is_sound)).then_some(at)
        })
    }
}

/// Whether a vertex can be drawn.
fn is_sound(v: &Vertex) -> bool {
    let bounded = |c: &f32| c.abs() < 1e6;
    v.position.iter().all(bounded) && v.normal.iter().all(bounded) && v.uv.iter().all(bounded)
}
