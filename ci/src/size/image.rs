//! What stands in a linked image: bytes by kind of memory, and names that must not be there.

use object::{Object, ObjectSection, ObjectSymbol, SectionKind};

/// Parts of the names of functions that only a panic needs; mangled names hold them as they are.
const PANICS: [&str; 6] = [
    "panicking",
    "unwrap_failed",
    "expect_failed",
    "slice_index_fail",
    "rust_begin_unwind",
    "panic_bounds",
];
/// The same for an allocator.
const ALLOCATORS: [&str; 4] =
    ["__rust_alloc", "__rust_realloc", "__rdl_alloc", "handle_alloc_error"];

/// Rooms of the core, as mangled names hold them, that the firmware did not ask for.
const UNASKED: [&str; 4] =
    ["dogleaf_core4mesh", "dogleaf_core4seed", "dogleaf_core6effect", "5fault"];

/// An image, looked at.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Image {
    /// Code and constants.
    pub(crate) text: u64,
    /// Statics that begin with a value: in RAM, and once more in flash.
    pub(crate) data: u64,
    /// Statics that begin as zero.
    pub(crate) zero: u64,
    pub(crate) panics: Vec<String>,
    pub(crate) allocators: Vec<String>,
    /// Functions of effects that were not asked for.
    pub(crate) unasked: Vec<String>,
}

impl Image {
    /// Reads an ELF file.
    pub(crate) fn read(path: &std::path::Path) -> Result<Self, String> {
        let bytes = std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()))?;
        let file = object::File::parse(&*bytes).map_err(|e| format!("{}: {e}", path.display()))?;
        let mut image = Self::default();
        for section in file.sections() {
            match section.kind() {
                SectionKind::Text | SectionKind::ReadOnlyData | SectionKind::ReadOnlyString => {
                    image.text += section.size();
                }
                SectionKind::Data => image.data += section.size(),
                SectionKind::UninitializedData => image.zero += section.size(),
                _ => {}
            }
        }
        for name in file.symbols().filter_map(|s| s.name().ok()) {
            image.note(name);
        }
        if image.text == 0 || file.symbols().next().is_none() {
            return Err(format!("{}: no code or no symbols to look at", path.display()));
        }
        Ok(image)
    }

    fn note(&mut self, name: &str) {
        if PANICS.iter().any(|p| name.contains(p)) {
            self.panics.push(name.to_owned());
        }
        if ALLOCATORS.iter().any(|p| name.contains(p)) {
            self.allocators.push(name.to_owned());
        }
        if UNASKED.iter().any(|p| name.contains(p)) {
            self.unasked.push(name.to_owned());
        }
    }

    /// Bytes of RAM that are never given back.
    pub(crate) fn statics(&self) -> u64 {
        self.data + self.zero
    }
}

#[cfg(test)]
mod check {
    use super::Image;

    #[test]
    fn forbidden_names_are_known_in_their_mangled_form() {
        let mut image = Image::default();
        image.note("_ZN4core9panicking18panic_bounds_check17h0123456789abcdefE");
        image.note("_RNvNtCs0123_4core9panicking9panic_fmt");
        image.note("__rust_alloc");
        image.note("_ZN12dogleaf_core4book4Book4step17h0123456789abcdefE");
        image.note("_ZN12dogleaf_core4mesh7indices7indices17h0123456789abcdefE");
        image.note("_ZN12dogleaf_core6effect6ribbon4life6Ribbon4step17h0123456789abcdefE");
        let found = [image.panics.len(), image.allocators.len(), image.unasked.len()];
        assert_eq!(found, [2, 1, 2], "{image:?}");
    }

    #[test]
    fn what_is_no_image_is_refused() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
        assert!(Image::read(&path).is_err(), "a manifest is no image");
    }
}
