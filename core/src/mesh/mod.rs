//! Triangles for a shell to draw; never fed back into the state.

pub mod vertex;

pub use vertex::Vertex;
