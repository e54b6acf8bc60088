//! Animated PNG: exact frames.
//!
//! The `png` crate wants the number of frames before the first one. So it only compresses each
//! shot as a picture of its own, and the chunks are laid together here; the number is
//! filled in at the end.

use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};

use super::Film;
use super::shot::Shot;
use crate::error::AnimError;

/// Where `acTL` begins: after the signature and `IHDR`.
const CONTROL_AT: u64 = 8 + 25;

/// An animated PNG in the making.
#[derive(Debug)]
pub(super) struct Apng {
    file: BufWriter<File>,
    frames: u32,
    /// Numbers `fcTL` and `fdAT` chunks in one row.
    sequence: u32,
}

impl Apng {
    pub(super) fn create(
        mut file: BufWriter<File>,
        width: u32,
        height: u32,
    ) -> Result<Self, AnimError> {
        let mut header = Vec::from(width.to_be_bytes());
        header.extend(height.to_be_bytes());
        // Eight bits, RGB, and the only compression, filter and interlace methods there are or we need.
        header.extend([8, 2, 0, 0, 0]);
        said(|| {
            file.write_all(b"\x89PNG\r\n\x1a\n")?;
            chunk(&mut file, b"IHDR", &header)?;
            chunk(&mut file, b"acTL", &[0; 8])?;
            chunk(&mut file, b"sRGB", &[0])
        })?;
        Ok(Self { file, frames: 0, sequence: 0 })
    }

    fn control(&mut self, shot: &Shot) -> io::Result<()> {
        let mut data = Vec::from(self.sequence.to_be_bytes());
        for number in [shot.rect.width, shot.rect.height, shot.rect.x, shot.rect.y] {
            data.extend((number as u32).to_be_bytes());
        }
        let ms = shot.lasts(1000).min(u64::from(u16::MAX)) as u16;
        data.extend(ms.to_be_bytes());
        data.extend(1000_u16.to_be_bytes());
        // Leave the picture as it is afterwards; replace, do not blend.
        data.extend([0, 0]);
        self.sequence += 1;
        chunk(&mut self.file, b"fcTL", &data)
    }

    fn add(&mut self, shot: &Shot, picture: &[u8]) -> io::Result<()> {
        self.control(shot)?;
        for data in chunks(picture).filter(|(name, _)| name == b"IDAT").map(|(_, data)| data) {
            if self.frames == 0 {
                chunk(&mut self.file, b"IDAT", data)?;
            } else {
                let mut numbered = Vec::from(self.sequence.to_be_bytes());
                numbered.extend_from_slice(data);
                self.sequence += 1;
                chunk(&mut self.file, b"fdAT", &numbered)?;
            }
        }
        self.frames += 1;
        Ok(())
    }

    fn end(&mut self) -> io::Result<()> {
        chunk(&mut self.file, b"IEND", &[])?;
        self.file.seek(SeekFrom::Start(CONTROL_AT))?;
        let mut control = Vec::from(self.frames.to_be_bytes());
        control.extend(0_u32.to_be_bytes());
        chunk(&mut self.file, b"acTL", &control)?;
        self.file.flush()
    }
}

impl Film for Apng {
    fn show(&mut self, shot: &Shot) -> Result<(), AnimError> {
        let picture = still(shot.rect.width as u32, shot.rect.height as u32, &shot.pixels)?;
        said(|| self.add(shot, &picture))
    }

    fn close(&mut self) -> Result<(), AnimError> {
        said(|| self.end())
    }
}

/// A picture as a PNG file.
pub(super) fn still(width: u32, height: u32, rgb: &[u8]) -> Result<Vec<u8>, AnimError> {
    let mut bytes = Vec::new();
    let mut encode = || -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Balanced);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(rgb)?;
        writer.finish()
    };
    match encode() {
        Ok(()) => Ok(bytes),
        Err(e) => Err(AnimError::Encoder { format: "PNG", message: e.to_string() }),
    }
}

fn said(work: impl FnOnce() -> io::Result<()>) -> Result<(), AnimError> {
    work().map_err(|e| AnimError::Encoder { format: "PNG", message: e.to_string() })
}

/// The chunks of a PNG file we have just made: name and data.
fn chunks(file: &[u8]) -> impl Iterator<Item = ([u8; 4], &[u8])> {
    let mut rest = file.get(8..).unwrap_or_default();
    std::iter::from_fn(move || {
        let length = u32::from_be_bytes(rest.first_chunk::<4>().copied()?) as usize;
        let name = rest.get(4..8)?.first_chunk::<4>().copied()?;
        let data = rest.get(8..8 + length)?;
        rest = rest.get(12 + length..)?;
        Some((name, data))
    })
}

fn chunk(out: &mut impl Write, name: &[u8; 4], data: &[u8]) -> io::Result<()> {
    out.write_all(&(data.len() as u32).to_be_bytes())?;
    out.write_all(name)?;
    out.write_all(data)?;
    let sum = crc(crc(!0, name), data);
    out.write_all(&(!sum).to_be_bytes())
}

/// The CRC of PNG, continued; begins with all ones and is inverted at the end.
fn crc(start: u32, data: &[u8]) -> u32 {
    const TABLE: [u32; 256] = table();
    data.iter().fold(start, |c, b| TABLE[((c ^ u32::from(*b)) & 0xff) as usize] ^ (c >> 8))
}

const fn table() -> [u32; 256] {
    let mut table = [0; 256];
    let mut n = 0;
    while n < 256 {
        let mut c = n as u32;
        let mut k = 0;
        while k < 8 {
            c = if c & 1 == 1 { 0xedb8_8320 ^ (c >> 1) } else { c >> 1 };
            k += 1;
        }
        table[n] = c;
        n += 1;
    }
    table
}
