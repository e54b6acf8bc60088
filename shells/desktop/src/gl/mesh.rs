//! Triangles on the card: indices given once, vertices every frame.

use super::Gl;
use dogleaf_core::mesh::Vertex;
use glow::HasContext;
use std::ops::Range;

/// Bytes of a vertex.
const STRIDE: i32 = size_of::<Vertex>() as i32;

/// A vertex array with its two buffers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mesh {
    array: glow::NativeVertexArray,
    vertices: glow::NativeBuffer,
}

impl Gl {
    /// Room for so many vertices, and the triangles between them.
    ///
    /// # Errors
    ///
    /// The driver has no room.
    pub(crate) fn mesh(&self, vertices: usize, indices: &[u16]) -> Result<Mesh, String> {
        let indices: Vec<u8> = indices.iter().flat_map(|i| i.to_ne_bytes()).collect();
        // SAFETY: the context is current; offsets and stride are those of `Vertex`.
        unsafe {
            let array = self.raw.create_vertex_array()?;
            self.raw.bind_vertex_array(Some(array));
            let buffer = self.raw.create_buffer()?;
            self.raw.bind_buffer(glow::ARRAY_BUFFER, Some(buffer));
            let bytes = vertices as i32 * STRIDE;
            self.raw.buffer_data_size(glow::ARRAY_BUFFER, bytes, glow::DYNAMIC_DRAW);
            for (location, size, offset) in [(0, 3, 0), (1, 3, 12), (2, 2, 24)] {
                self.raw.enable_vertex_attrib_array(location);
                let kind = glow::FLOAT;
                self.raw.vertex_attrib_pointer_f32(location, size, kind, false, STRIDE, offset);
            }
            let elements = self.raw.create_buffer()?;
            self.raw.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, Some(elements));
            self.raw.buffer_data_u8_slice(glow::ELEMENT_ARRAY_BUFFER, &indices, glow::STATIC_DRAW);
            self.raw.bind_vertex_array(None);
            Ok(Mesh { array, vertices: buffer })
        }
    }

    /// Replaces all vertices. The buffer is given up first, so that nobody waits for the last frame.
    pub(crate) fn fill(&self, mesh: Mesh, vertices: &[Vertex]) {
        // SAFETY: a vertex is `repr(C)`, eight numbers without a gap, so its bytes are all set; the context is
        // current and the buffer its own.
        unsafe {
            let bytes = std::slice::from_raw_parts(vertices.as_ptr().cast(), size_of_val(vertices));
            self.raw.bind_buffer(glow::ARRAY_BUFFER, Some(mesh.vertices));
            self.raw.buffer_data_u8_slice(glow::ARRAY_BUFFER, bytes, glow::DYNAMIC_DRAW);
        }
    }

    /// Draws these indices of it, three a triangle.
    pub(crate) fn draw(&self, mesh: Mesh, indices: Range<usize>) {
        // SAFETY: the context is current, the mesh its own; the pieces of a book lie inside its indices.
        unsafe {
            self.raw.bind_vertex_array(Some(mesh.array));
            let (count, offset) = (indices.len() as i32, (2 * indices.start) as i32);
            self.raw.draw_elements(glow::TRIANGLES, count, glow::UNSIGNED_SHORT, offset);
        }
    }

    /// Draws a triangle that the vertex shader makes from nothing.
    pub(crate) fn draw_everywhere(&self, mesh: Mesh) {
        // SAFETY: the context is current; the shader reads no array.
        unsafe {
            self.raw.disable(glow::DEPTH_TEST);
            self.raw.disable(glow::CULL_FACE);
            self.raw.bind_vertex_array(Some(mesh.array));
            self.raw.draw_arrays(glow::TRIANGLES, 0, 3);
        }
    }
}
