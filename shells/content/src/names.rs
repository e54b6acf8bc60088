//! Which names in an archive or a folder are pages.

/// Endings of images; the second half cannot be decoded yet, but leaving such a file out
/// would silently renumber the pages after it, so it counts and is a bad page.
const IMAGE_ENDINGS: [&str; 16] = [
    "png", "jpg", "jpeg", "jpe", "jfif", "webp", "gif", "apng", // decoded
    "avif", "jxl", "heic", "heif", "bmp", "tif", "tiff", "jp2", // not decoded
];

/// Entries that only archives of another kind have.
const FOREIGN_MARKS: [&str; 4] =
    ["mimetype", "[Content_Types].xml", "META-INF/container.xml", "META-INF/MANIFEST.MF"];

/// Whether this is a page: an image by its ending, not hidden, not the litter of some system.
pub(crate) fn is_page(name: &str) -> bool {
    let litter = |part: &str| part.starts_with('.') || part == "__MACOSX";
    if name.split(['/', '\\']).any(litter) {
        return false;
    }
    name.rsplit_once('.').is_some_and(|(_, ending)| {
        IMAGE_ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known))
    })
}

/// Whether this entry tells that the archive is an EPUB, an office document or a program.
pub(crate) fn is_foreign_mark(name: &str) -> bool {
    FOREIGN_MARKS.contains(&name)
}

/// Whether this name would leave the folder it is unpacked into. Nothing is unpacked here, but
/// whoever made such a name meant harm.
pub(crate) fn escapes(name: &str) -> bool {
    name.starts_with(['/', '\\'])
        || name.contains('\0')
        || name.split(['/', '\\']).any(|part| part == "..")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn litter_is_no_page() {
        for page in ["1.png", "a/b.JPG", "x.y.webp", "p.avif"] {
            assert!(is_page(page), "{page} is a page");
        }
        for other in ["__MACOSX/1.png", "a/._1.png", ".DS_Store", "Thumbs.db", "png", "a.txt"] {
            assert!(!is_page(other), "{other} is no page");
        }
    }

    #[test]
    fn names_that_leave_the_archive() {
        for bad in ["../a.png", "a/../../b.png", "a\\..\\b.png", "/a.png", "a\0.png"] {
            assert!(escapes(bad), "{bad:?} leaves the archive");
        }
        assert!(!escapes("a..b/c...png"), "dots in a name are harmless");
    }
}
