//! From light to bytes: a mild shoulder, a slight vignette, sRGB.

use glam::Vec3;

/// Where the shoulder begins; below it the picture is proportional to the light.
const KNEE: f32 = 0.72;
/// Share of light lost in the picture's corners.
const VIGNETTE: f32 = 0.22;
/// Entries of the encoding table, spaced by square root so that the dark end is fine enough.
const ENTRIES: usize = 4096;

/// sRGB byte to linear light.
pub(crate) fn decode_srgb(byte: u8) -> f32 {
    let c = f32::from(byte) / 255.0;
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

/// Linear light in 0..1 to the sRGB value in 0..255, not yet rounded.
fn encode_srgb(light: f32) -> f32 {
    let c =
        if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    c.clamp(0.0, 1.0) * 255.0
}

/// Linear light to an sRGB byte, exactly; for tables and mip levels.
pub(crate) fn encode_byte(light: f32) -> u8 {
    (encode_srgb(light) + 0.5) as u8
}

/// Compresses light above the knee so that nothing clips hard.
fn shoulder(light: f32) -> f32 {
    if light <= KNEE {
        return light.max(0.0);
    }
    let room = 1.0 - KNEE;
    KNEE + room * (1.0 - (-(light - KNEE) / room).exp())
}

/// Turns the light of a pixel into three bytes.
#[derive(Debug)]
pub(crate) struct Tone {
    table: Vec<f32>,
    centre: [f32; 2],
    vignette: f32,
}

impl Tone {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let entry = |i: usize| {
            let root = i as f32 / (ENTRIES - 1) as f32 * 2.0;
            encode_srgb(shoulder(root * root))
        };
        let centre = [width as f32 * 0.5, height as f32 * 0.5];
        let far = centre[0] * centre[0] + centre[1] * centre[1];
        Self { table: (0..ENTRIES).map(entry).collect(), centre, vignette: VIGNETTE / far }
    }

    /// Encodes `light` for pixel (`x`, `y`). A fixed pattern of half a level hides banding without
    /// making still parts of the picture change from frame to frame.
    pub(crate) fn pixel(&self, light: Vec3, x: usize, y: usize) -> [u8; 3] {
        let dx = x as f32 + 0.5 - self.centre[0];
        let dy = y as f32 + 0.5 - self.centre[1];
        let dim = 1.0 - self.vignette * (dx * dx + dy * dy);
        let offset = pattern(x, y);
        (light * dim).to_array().map(|c| (self.encode(c) + offset) as u8)
    }

    fn encode(&self, light: f32) -> f32 {
        let place = light.max(0.0).sqrt() * (0.5 * (ENTRIES - 1) as f32);
        self.table[(place as usize).min(ENTRIES - 1)]
    }
}

/// Ordered dither of 4x4 pixels around one half, a quarter level each way.
fn pattern(x: usize, y: usize) -> f32 {
    const BAYER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
    0.25 + f32::from(BAYER[y & 3][x & 3]) / 30.0
}
