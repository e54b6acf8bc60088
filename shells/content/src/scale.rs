//! Resampling of page images.

use image::RgbImage;
use image::imageops::{FilterType, resize};

/// Beyond this many source pixels per target pixel, whole blocks are averaged first: the sharp
/// filter's cost grows with the ratio, and past a few pixels nobody sees which filter it was.
const BLOCKS_FROM: u32 = 4;

/// Brings an image to the given size.
///
/// # Accuracy
///
/// Lanczos (three lobes) where it shrinks, Catmull-Rom where it grows: small print stays sharp and
/// enlarged print does not ring. Sums are of sRGB values, which keeps thin strokes dark.
pub(crate) fn scale(image: RgbImage, width: u32, height: u32) -> RgbImage {
    if (image.width(), image.height()) == (width, height) {
        return image;
    }
    let ratio = (image.width() / width).min(image.height() / height);
    let image = if ratio >= BLOCKS_FROM { block_average(&image, ratio / 2) } else { image };
    let grows = width > image.width();
    let filter = if grows { FilterType::CatmullRom } else { FilterType::Lanczos3 };
    resize(&image, width, height, filter)
}

/// Averages blocks of `n` by `n` pixels; a block over the right or lower border is narrower.
fn block_average(image: &RgbImage, n: u32) -> RgbImage {
    let (width, height) = image.dimensions();
    RgbImage::from_fn(width.div_ceil(n), height.div_ceil(n), |bx, by| {
        let (x0, y0) = (bx * n, by * n);
        let (x1, y1) = ((x0 + n).min(width), (y0 + n).min(height));
        let mut sum = [0_u32; 3];
        for y in y0..y1 {
            for x in x0..x1 {
                let pixel = image.get_pixel(x, y).0;
                for (total, channel) in sum.iter_mut().zip(pixel) {
                    *total += u32::from(channel);
                }
            }
        }
        let count = (x1 - x0) * (y1 - y0);
        image::Rgb(sum.map(|total| ((total + count / 2) / count) as u8))
    })
}
