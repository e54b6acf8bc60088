//! One corner of a triangle, as a shell uploads it.

/// Position, normal and texture place of one corner: 32 bytes, little-endian on every target we ship to.
///
/// # Shapes and units
///
/// `position`: metres, book frame. `normal`: unit length, outwards. `uv`: 0..1, `u` from the
/// page picture's left edge, `v` from its top.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vertex {
    /// Place in the book frame, metres.
    pub position: [f32; 3],
    /// Outward unit normal.
    pub normal: [f32; 3],
    /// Place in the page picture.
    pub uv: [f32; 2],
}
