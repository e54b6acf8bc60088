//! Animated WebP, lossy: the smallest file that still reads well.
//!
//! `webp-rust` (MIT, no `unsafe`) encodes the shots as pictures of their own; the container around
//! them is a few fixed-size headers and is written here. Considered and left: `image-webp` 0.2 is
//! lossless only, ten times larger; `zenwebp` is under the AGPL; `libwebp-sys` needs a C compiler.

use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};

use webp_rust::{ImageBuffer, LossyEncodingConfig};

use super::Film;
use super::shot::Shot;
use crate::error::AnimError;

/// Largest side a lossy frame can have, pixels.
pub(super) const MAX_SIDE: u32 = 16_383;
/// Fine print shows no ringing from the first on. The encoder cannot read back what it made of some rare
/// pictures at one of them; then the next serves.
const QUALITIES: [f32; 4] = [93.0, 95.0, 91.0, 88.0];
/// Smoothing of block borders. The encoder's own default of 60 rounds small letters off and costs
/// 3 dB on a page of print.
const FILTER: u8 = 10;
/// The fastest search: eight times faster than the next for files half as large again.
const METHOD: u8 = 0;

/// Less than this is lost in the coding anyway, levels.
const SLACK: u8 = 2;

/// An animated WebP in the making.
#[derive(Debug)]
pub(super) struct Webp {
    file: BufWriter<File>,
}

impl Webp {
    pub(super) fn create(
        mut file: BufWriter<File>,
        width: u32,
        height: u32,
    ) -> Result<Self, AnimError> {
        let mut head = Vec::from(*b"RIFF\0\0\0\0WEBPVP8X");
        head.extend(10_u32.to_le_bytes());
        // Flags: animation.
        head.extend([2, 0, 0, 0]);
        head.extend(three(width as usize - 1));
        head.extend(three(height as usize - 1));
        head.extend(b"ANIM");
        head.extend(6_u32.to_le_bytes());
        // Background, then repeats: forever.
        head.extend([255, 255, 255, 255, 0, 0]);
        said(file.write_all(&head))?;
        Ok(Self { file })
    }

    fn add(&mut self, shot: &Shot, picture: &[u8]) -> io::Result<()> {
        let mut head = Vec::from(*b"ANMF");
        head.extend((16 + picture.len() as u32).to_le_bytes());
        for number in [shot.rect.x / 2, shot.rect.y / 2, shot.rect.width - 1, shot.rect.height - 1]
        {
            head.extend(three(number));
        }
        head.extend(three(shot.lasts(1000) as usize));
        // Replace, do not blend; leave the picture as it is afterwards.
        head.push(2);
        self.file.write_all(&head)?;
        self.file.write_all(picture)
    }

    fn end(&mut self) -> io::Result<()> {
        let length = self.file.stream_position()?;
        self.file.seek(SeekFrom::Start(4))?;
        self.file.write_all(&((length - 8) as u32).to_le_bytes())?;
        self.file.flush()
    }
}

impl Film for Webp {
    fn show(&mut self, shot: &Shot) -> Result<(), AnimError> {
        let rgba = shot.pixels.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
        let picture = ImageBuffer { width: shot.rect.width, height: shot.rect.height, rgba };
        let file = encoded(&picture)?;
        let chunk =
            picture_chunk(&file).ok_or_else(|| failed(&"no picture in the encoder's answer"))?;
        said(self.add(shot, chunk))
    }

    fn slack(&self) -> u8 {
        SLACK
    }

    fn close(&mut self) -> Result<(), AnimError> {
        said(self.end())
    }
}

/// The picture as a still WebP, at the first quality the encoder manages.
fn encoded(picture: &ImageBuffer) -> Result<Vec<u8>, AnimError> {
    let mut why = failed(&"no quality was tried");
    for quality in QUALITIES {
        let config = LossyEncodingConfig {
            quality,
            method: METHOD,
            filter_strength: FILTER,
            sns_strength: 0,
            segments: 1,
            ..Default::default()
        };
        match webp_rust::encode_lossy_with_config(picture, &config, None) {
            Ok(file) => return Ok(file),
            Err(e) => why = failed(&e),
        }
    }
    Err(why)
}

fn said<T>(result: io::Result<T>) -> Result<T, AnimError> {
    result.map_err(|e| failed(&e))
}

fn failed(what: &impl std::fmt::Display) -> AnimError {
    AnimError::Encoder { format: "WebP", message: what.to_string() }
}

/// A number in three bytes, low first, as the container has them; larger ones are cut to the most.
fn three(number: usize) -> [u8; 3] {
    let [a, b, c, _] = (number.min(0xff_ffff) as u32).to_le_bytes();
    [a, b, c]
}

/// The `VP8 ` chunk of a still WebP, header and padding included.
fn picture_chunk(file: &[u8]) -> Option<&[u8]> {
    let mut rest = file.get(12..)?;
    loop {
        let length = u32::from_le_bytes(rest.get(4..8)?.try_into().ok()?) as usize;
        let whole = 8 + length + length % 2;
        if rest.starts_with(b"VP8 ") {
            return rest.get(..whole);
        }
        rest = rest.get(whole..)?;
    }
}
