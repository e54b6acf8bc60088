//! What a book calls itself.

use crate::error::one_line;
use std::path::Path;

/// Letters of a title that are kept.
const MAX_LETTERS: usize = 200;

/// The file's name without its ending.
pub(crate) fn from_path(path: &Path) -> String {
    let name = if path.is_dir() { path.file_name() } else { path.file_stem() };
    one_line(&name.unwrap_or(path.as_os_str()).to_string_lossy())
}

/// A PDF text string: UTF-16 or UTF-8 if it is marked so, else Latin-1, which is what the format's
/// own encoding is for all but a few signs. `None` if nothing readable is left.
pub(crate) fn from_pdf(bytes: &[u8]) -> Option<String> {
    let text = match bytes {
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes),
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => String::from_utf8_lossy(rest).into_owned(),
        plain => plain.iter().copied().map(char::from).collect(),
    };
    let kept: String = one_line(text.trim_matches(['\0', ' '])).chars().take(MAX_LETTERS).collect();
    (!kept.trim().is_empty()).then_some(kept)
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units: Vec<u16> = bytes.chunks_exact(2).map(|b| unit([b[0], b[1]])).collect();
    String::from_utf16_lossy(&units)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_three_encodings() {
        assert_eq!(from_pdf(b"Caf\xe9").as_deref(), Some("Caf\u{e9}"), "latin-1");
        assert_eq!(from_pdf(b"\xfe\xff\x05\xd0\x00a").as_deref(), Some("\u{5d0}a"), "utf-16");
        assert_eq!(from_pdf(b"\xef\xbb\xbf\xc3\xa9").as_deref(), Some("\u{e9}"), "utf-8");
        assert_eq!(from_pdf(b"\xfe\xff"), None, "empty");
        assert_eq!(from_pdf(b"a\nb").as_deref(), Some("a\u{fffd}b"), "one line");
    }
}
