//! Encoded images to sizes and pictures: declared size first, pixels after.

use crate::fit::{check_shape, fit};
use crate::guard::guarded;
use crate::limits::{MAX_DECODE_BYTES, MAX_ENLARGEMENT, MAX_PIXELS, MAX_SIDE_PX};
use crate::picture::Picture;
use crate::scale::scale;
use image::metadata::Orientation;
use image::{
    DynamicImage, ImageBuffer, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits, Rgb,
    RgbImage, RgbaImage,
};
use std::io::Cursor;

/// Bytes read for a size: enough for the header of nearly every image.
const HEAD_BYTES: u64 = 64 << 10;

/// How much of an image file is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Amount {
    Head,
    Whole,
}

impl Amount {
    /// Bytes after which to stop; `None` for the source's own cap.
    pub(crate) fn limit(self) -> Option<u64> {
        (self == Self::Head).then_some(HEAD_BYTES)
    }
}

/// A source of encoded images, one per page.
pub(crate) trait ImageFiles: Send + Sync {
    fn count(&self) -> usize;
    fn name(&self, i: usize) -> &str;
    fn bytes(&self, i: usize, amount: Amount) -> Result<Vec<u8>, String>;
}

/// A page's size in pixels as it is to be looked at; decodes no pixel.
pub(crate) fn page_size(files: &dyn ImageFiles, i: usize) -> Result<(f32, f32), String> {
    let head = files.bytes(i, Amount::Head)?;
    let cut = head.len() as u64 == HEAD_BYTES;
    match image_size(&head) {
        // The header did not end within the head: long metadata before it.
        Err(_) if cut => image_size(&files.bytes(i, Amount::Whole)?),
        outcome => outcome,
    }
}

/// A page's picture, fitted into the box.
pub(crate) fn page(files: &dyn ImageFiles, i: usize, max: (u32, u32)) -> Result<Picture, String> {
    let bytes = files.bytes(i, Amount::Whole)?;
    let image = guarded(|| decode(&bytes)).map_err(|_| BROKEN.to_owned())??;
    let size = (image.width() as f32, image.height() as f32);
    let (width, height) = fit(size, max, MAX_ENLARGEMENT);
    Ok(opaque(&scale(image, width, height)))
}

const BROKEN: &str = "the image is damaged";

fn image_size(bytes: &[u8]) -> Result<(f32, f32), String> {
    guarded(|| {
        let mut decoder = decoder(bytes)?;
        let (w, h) = decoder.dimensions();
        let size = if is_sideways(orientation(&mut decoder)) { (h, w) } else { (w, h) };
        let size = (size.0 as f32, size.1 as f32);
        check_shape(size).map(|()| size)
    })
    .map_err(|_| BROKEN.to_owned())?
}

/// Opens an image whose declared size is one we accept.
fn decoder(bytes: &[u8]) -> Result<impl ImageDecoder + '_, String> {
    let format = image::guess_format(bytes).ok().filter(is_decodable);
    let format = format.ok_or("it is not a png, jpeg, webp or gif image")?;
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    reader.limits(decode_limits());
    let decoder = reader.into_decoder().map_err(|e| told(&e))?;
    let (w, h) = decoder.dimensions();
    let pixels = u64::from(w) * u64::from(h);
    if w.max(h) > MAX_SIDE_PX || pixels > MAX_PIXELS || decoder.total_bytes() > MAX_DECODE_BYTES {
        return Err(format!("its {w} x {h} pixels are too many"));
    }
    Ok(decoder)
}

fn is_decodable(format: &ImageFormat) -> bool {
    use ImageFormat::{Gif, Jpeg, Png, WebP};
    matches!(format, Png | Jpeg | WebP | Gif)
}

fn decode_limits() -> Limits {
    let mut limits = Limits::default();
    limits.max_image_width = Some(MAX_SIDE_PX);
    limits.max_image_height = Some(MAX_SIDE_PX);
    limits.max_alloc = Some(MAX_DECODE_BYTES);
    limits
}

fn decode(bytes: &[u8]) -> Result<RgbImage, String> {
    let mut decoder = decoder(bytes)?;
    let turn = orientation(&mut decoder);
    let mut image = DynamicImage::from_decoder(decoder).map_err(|e| told(&e))?;
    image.apply_orientation(turn);
    check_shape((image.width() as f32, image.height() as f32))?;
    Ok(on_white(image))
}

fn orientation(decoder: &mut impl ImageDecoder) -> Orientation {
    // Damaged metadata is no reason to lose the page.
    decoder.orientation().unwrap_or(Orientation::NoTransforms)
}

fn is_sideways(turn: Orientation) -> bool {
    use Orientation::{Rotate90, Rotate90FlipH, Rotate270, Rotate270FlipH};
    matches!(turn, Rotate90 | Rotate90FlipH | Rotate270 | Rotate270FlipH)
}

/// Lays the image on white paper. Done before scaling: colours that hide under full transparency
/// must not bleed into their neighbours.
fn on_white(image: DynamicImage) -> RgbImage {
    if !image.color().has_alpha() {
        return image.into_rgb8();
    }
    let sheer: RgbaImage = image.into_rgba8();
    ImageBuffer::from_fn(sheer.width(), sheer.height(), |x, y| {
        let [r, g, b, a] = sheer.get_pixel(x, y).0;
        Rgb([over_white(r, a), over_white(g, a), over_white(b, a)])
    })
}

fn over_white(colour: u8, alpha: u8) -> u8 {
    let (c, a) = (u32::from(colour), u32::from(alpha));
    ((c * a + 255 * (255 - a) + 127) / 255) as u8
}

fn opaque(image: &RgbImage) -> Picture {
    let rgba = image.pixels().flat_map(|p| [p.0[0], p.0[1], p.0[2], 255]).collect();
    Picture { width: image.width(), height: image.height(), rgba }
}

fn told(error: &ImageError) -> String {
    match error {
        ImageError::Limits(_) => "its pixels are too many".into(),
        ImageError::IoError(_) => "the image ends early".into(),
        ImageError::Unsupported(_) => "this variety of its image format is not supported".into(),
        _ => BROKEN.into(),
    }
}
