//! The shaders every GL shell shares, as they stand in `shells/glsl`.

/// What stands before each of them.
const COMMON: &str = include_str!("../../glsl/common.glsl");

/// A vertex shader and a fragment shader.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair([&'static str; 2]);

/// The book and the table.
pub(crate) const PAGE: Pair =
    Pair([include_str!("../../glsl/page.vert"), include_str!("../../glsl/page.frag")]);
/// One map of the lamp or the sky.
pub(crate) const SHADOW: Pair =
    Pair([include_str!("../../glsl/shadow.vert"), include_str!("../../glsl/shadow.frag")]);
/// The wood of the table.
pub(crate) const GRAIN: Pair =
    Pair([include_str!("../../glsl/grain.vert"), include_str!("../../glsl/grain.frag")]);

impl Pair {
    /// Both sources, complete.
    pub(crate) fn sources(self) -> [String; 2] {
        self.0.map(|own| format!("{COMMON}{own}"))
    }
}
