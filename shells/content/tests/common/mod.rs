//! Small books made on the spot, and what every refusal has to look like.

// Each test file uses its own part of this.
#![allow(dead_code)]

use dogleaf_content::{Book, ContentError, Picture};
use image::{DynamicImage, ImageFormat, Rgba, RgbaImage};
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// A folder of its own, gone when the test is over.
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    pub(crate) fn new() -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("dogleaf-content-{}-{number}", std::process::id());
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).expect("the temporary folder is writable");
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().expect("a file has a parent")).expect("writable");
        // Some file systems wait for the disk where a file is written over, not where it is new.
        let _ = fs::remove_file(&path);
        fs::write(&path, bytes).expect("the temporary folder is writable");
        path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Opens what must open.
pub(crate) fn open(path: &Path) -> Book {
    Book::open(path).unwrap_or_else(|e| panic!("must open: {e}"))
}

/// Opens what must not open, and checks that the refusal is fit for a reader.
pub(crate) fn refused(path: &Path) -> ContentError {
    let error = match Book::open(path) {
        Ok(book) => panic!("{} must be refused but opened as {book:?}", path.display()),
        Err(error) => error,
    };
    check_line(&error, path);
    error
}

/// One line, lower case, with the file's name and with advice after a colon.
pub(crate) fn check_line(error: &ContentError, path: &Path) {
    let line = error.to_string();
    let file = path.display().to_string();
    assert!(line.contains(&file), "it does not name the file: {line}");
    assert_eq!(line.lines().count(), 1, "it is not one line: {line:?}");
    let words = line.replace(&file, "");
    assert!(words.contains(": "), "it does not say what to do: {line}");
    assert!(!words.contains(char::is_uppercase) || words.contains("MiB"), "not lower case: {line}");
    assert!(line.len() < file.len() + 200, "it is too long: {line}");
}

pub(crate) fn encode(image: &RgbaImage, format: ImageFormat) -> Vec<u8> {
    let image = DynamicImage::from(image.clone());
    let image = if format == ImageFormat::Jpeg { image.into_rgb8().into() } else { image };
    let mut out = Cursor::new(Vec::new());
    image.write_to(&mut out, format).expect("an image can be encoded");
    out.into_inner()
}

pub(crate) fn png(width: u32, height: u32, colour: [u8; 4]) -> Vec<u8> {
    encode(&RgbaImage::from_pixel(width, height, Rgba(colour)), ImageFormat::Png)
}

/// A page that says its number in its red channel.
pub(crate) fn numbered(number: u8) -> Vec<u8> {
    png(20, 30, [number, 7, 7, 255])
}

/// The number of a [`numbered`] page.
pub(crate) fn number_of(picture: &Picture) -> u8 {
    picture.pixel(picture.width / 2, picture.height / 2).expect("the middle is inside")[0]
}

pub(crate) fn numbers(book: &Book) -> Vec<u8> {
    (0..book.page_count()).map(|i| number_of(&book.page(i, 40, 40).expect("sound"))).collect()
}

pub(crate) fn zip_of<N: AsRef<str>, B: AsRef<[u8]>>(entries: &[(N, B)]) -> Vec<u8> {
    zip_with(entries, CompressionMethod::Deflated)
}

/// A zip that packs nothing: for images that would pack like a bomb.
pub(crate) fn stored<N: AsRef<str>, B: AsRef<[u8]>>(entries: &[(N, B)]) -> Vec<u8> {
    zip_with(entries, CompressionMethod::Stored)
}

pub(crate) fn zip_with<N: AsRef<str>, B: AsRef<[u8]>>(
    entries: &[(N, B)],
    method: CompressionMethod,
) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(method);
    for (name, bytes) in entries {
        let name = name.as_ref();
        if name.ends_with('/') {
            zip.add_directory(name, options).expect("a folder entry");
        } else {
            zip.start_file(name, options).expect("a file entry");
            zip.write_all(bytes.as_ref()).expect("its bytes");
        }
    }
    zip.finish().expect("a finished archive").into_inner()
}

/// Every position at which these bytes stand.
pub(crate) fn positions(bytes: &[u8], wanted: &[u8]) -> Vec<usize> {
    let hits = bytes.windows(wanted.len()).enumerate().filter(|(_, w)| *w == wanted);
    hits.map(|(at, _)| at).collect()
}

/// The headers of a zip: where each local one and each one of the directory begins.
pub(crate) fn zip_headers(zip: &[u8]) -> (Vec<usize>, Vec<usize>) {
    (positions(zip, b"PK\x03\x04"), positions(zip, b"PK\x01\x02"))
}

/// Objects, numbered from 1 with the catalogue first, to a PDF.
pub(crate) fn pdf_of(objects: &[Vec<u8>], trailer: &str) -> Vec<u8> {
    let mut out = b"%PDF-1.7\n".to_vec();
    let mut table = String::new();
    for (i, object) in objects.iter().enumerate() {
        table += &format!("{:010} 00000 n \n", out.len());
        out.extend_from_slice(format!("{} 0 obj\n", i + 1).as_bytes());
        out.extend_from_slice(object);
        out.extend_from_slice(b"\nendobj\n");
    }
    let (size, start) = (objects.len() + 1, out.len());
    out.extend_from_slice(format!("xref\n0 {size}\n0000000000 65535 f \n{table}").as_bytes());
    out.extend_from_slice(
        format!("trailer\n<</Size {size}/Root 1 0 R{trailer}>>\nstartxref\n{start}\n%%EOF\n")
            .as_bytes(),
    );
    out
}

pub(crate) fn stream(dict: &str, data: &[u8]) -> Vec<u8> {
    let mut out = format!("<<{dict}/Length {}>>\nstream\n", data.len()).into_bytes();
    out.extend_from_slice(data);
    out.extend_from_slice(b"\nendstream");
    out
}

/// A PDF with one page for each of these boxes, its lower left quarter painted.
pub(crate) fn pdf_pages(boxes: &[(u32, u32)]) -> Vec<u8> {
    let kids: String = (0..boxes.len()).map(|i| format!("{} 0 R ", 3 + 2 * i)).collect();
    let mut objects = vec![
        b"<</Type/Catalog/Pages 2 0 R>>".to_vec(),
        format!("<</Type/Pages/Kids[{kids}]/Count {}>>", boxes.len()).into_bytes(),
    ];
    for (i, (w, h)) in boxes.iter().enumerate() {
        let contents = 4 + 2 * i;
        let page = format!(
            "<</Type/Page/Parent 2 0 R/MediaBox[0 0 {w} {h}]/Contents {contents} 0 R/Resources<<>>>>"
        );
        objects.push(page.into_bytes());
        objects.push(stream("", format!("1 0 0 rg 0 0 {} {} re f", w / 2, h / 2).as_bytes()));
    }
    pdf_of(&objects, "")
}

/// A PDF of one page, 200 by 300 points, with these resources, contents and further objects (the
/// first of them is number 5).
pub(crate) fn pdf_page(resources: &str, contents: &[u8], further: &[Vec<u8>]) -> Vec<u8> {
    let page = format!(
        "<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 300]/Contents 4 0 R/Resources<<{resources}>>>>"
    );
    let mut objects = vec![
        b"<</Type/Catalog/Pages 2 0 R>>".to_vec(),
        b"<</Type/Pages/Kids[3 0 R]/Count 1>>".to_vec(),
        page.into_bytes(),
        stream("", contents),
    ];
    objects.extend_from_slice(further);
    pdf_of(&objects, "")
}
