//! What is drawn: triangles of one material.

use dogleaf_core::mesh::Vertex;

use crate::material::Material;

/// A triangle mesh of one material, borrowed from the caller.
///
/// # Shapes and units
///
/// `indices`: three a triangle, counter-clockwise seen from outside; a triangle with an index out
/// of range or a corner that is not finite is left out and counted in
/// [`crate::Stats::refused`].
#[derive(Debug, Clone, Copy)]
pub struct Patch<'a> {
    /// Corners, metres in the book frame.
    pub vertices: &'a [Vertex],
    /// Corners of each triangle.
    pub indices: &'a [u16],
    /// How the surface looks.
    pub material: Material<'a>,
}
