//! Page pictures drawn from a tiny font, so that the example needs no file.

const WIDTH: usize = 1000;
const HEIGHT: usize = 1538;
/// Pixels a font dot takes.
const DOT: f32 = 2.6;

/// Five columns a letter, low bit on top; `a` to `z`.
const FONT: [[u8; 5]; 26] = [
    [0x20, 0x54, 0x54, 0x54, 0x78],
    [0x7f, 0x48, 0x44, 0x44, 0x38],
    [0x38, 0x44, 0x44, 0x44, 0x28],
    [0x38, 0x44, 0x44, 0x48, 0x7f],
    [0x38, 0x54, 0x54, 0x54, 0x18],
    [0x08, 0x7e, 0x09, 0x01, 0x02],
    [0x18, 0xa4, 0xa4, 0xa4, 0x7c],
    [0x7f, 0x08, 0x04, 0x04, 0x78],
    [0x00, 0x44, 0x7d, 0x40, 0x00],
    [0x40, 0x80, 0x84, 0x7d, 0x00],
    [0x7f, 0x10, 0x28, 0x44, 0x00],
    [0x00, 0x41, 0x7f, 0x40, 0x00],
    [0x7c, 0x04, 0x18, 0x04, 0x78],
    [0x7c, 0x08, 0x04, 0x04, 0x78],
    [0x38, 0x44, 0x44, 0x44, 0x38],
    [0xfc, 0x24, 0x24, 0x24, 0x18],
    [0x18, 0x24, 0x24, 0x18, 0xfc],
    [0x7c, 0x08, 0x04, 0x04, 0x08],
    [0x48, 0x54, 0x54, 0x54, 0x20],
    [0x04, 0x3f, 0x44, 0x40, 0x20],
    [0x3c, 0x40, 0x40, 0x20, 0x7c],
    [0x1c, 0x20, 0x40, 0x20, 0x1c],
    [0x3c, 0x40, 0x30, 0x40, 0x3c],
    [0x44, 0x28, 0x10, 0x28, 0x44],
    [0x1c, 0xa0, 0xa0, 0xa0, 0x7c],
    [0x44, 0x64, 0x54, 0x4c, 0x44],
];

const WORDS: &str = "a leaf of paper has two pages and no thickness to speak of until many lie upon each other then \
they make a block with a spine and three cut edges whoever lifts a corner feels the sheet bend but never stretch it \
carries its own shadow over the gutter and comes to rest on the other side where its reverse is read the hand is gone \
long before the page lies still";

/// Page number `n`: width, height, RGBA.
pub(crate) fn page(n: usize) -> (u32, u32, Vec<u8>) {
    let mut ink = vec![0.0_f32; WIDTH * HEIGHT];
    let mut words = WORDS.split_whitespace().cycle().skip(n * 17);
    let (left, right) = (120.0, WIDTH as f32 - 110.0);
    let mut y = 150.0;
    if n == 3 {
        line(&mut ink, &["love", "among", "the", "leaves"], 230.0, y, 2.0);
        y += 170.0;
    }
    while y < HEIGHT as f32 - 170.0 {
        let mut x = if (y as usize / 10).is_multiple_of(13) { left + 50.0 } else { left };
        for word in words.by_ref() {
            let wide = word.len() as f32 * 6.0 * DOT;
            if x + wide > right {
                break;
            }
            line(&mut ink, &[word], x, y, 1.0);
            x += wide + 3.4 * DOT;
        }
        y += 36.0;
    }
    if n == 1 {
        picture(&mut ink);
    }
    let bytes = ink.iter().flat_map(|&i| shade(i)).collect();
    (WIDTH as u32, HEIGHT as u32, bytes)
}

fn shade(ink: f32) -> [u8; 4] {
    let v = (255.0 - 232.0 * ink.min(1.0)) as u8;
    [v, v, v, 255]
}

fn line(ink: &mut [f32], words: &[&str], mut x: f32, y: f32, scale: f32) {
    let dot = DOT * scale;
    for word in words {
        for letter in word.bytes().filter(u8::is_ascii_lowercase) {
            glyph(ink, FONT[usize::from(letter - b'a')], x, y, dot);
            x += 6.0 * dot;
        }
        x += 4.0 * dot;
    }
}

/// Draws one letter as overlapping round dots.
fn glyph(ink: &mut [f32], columns: [u8; 5], x: f32, y: f32, dot: f32) {
    for (i, column) in columns.into_iter().enumerate() {
        for j in (0..8).filter(|j| column >> j & 1 == 1) {
            blot(ink, x + (i as f32 + 0.5) * dot, y + (j as f32 + 0.5) * dot, 0.62 * dot);
        }
    }
}

fn blot(ink: &mut [f32], cx: f32, cy: f32, radius: f32) {
    let span = |c: f32, n: usize| {
        ((c - radius - 1.0).max(0.0) as usize, ((c + radius + 1.0) as usize).min(n - 1))
    };
    let ((x0, x1), (y0, y1)) = (span(cx, WIDTH), span(cy, HEIGHT));
    for y in y0..=y1 {
        for x in x0..=x1 {
            let away = (x as f32 + 0.5 - cx).hypot(y as f32 + 0.5 - cy);
            let cover = (radius - away + 0.5).clamp(0.0, 1.0);
            let at = &mut ink[y * WIDTH + x];
            *at = at.max(cover);
        }
    }
}

/// A grey plate with rings, to see what shines through and how fine lines fare.
fn picture(ink: &mut [f32]) {
    for y in 560..980 {
        for x in 220..780 {
            let (dx, dy) = (x as f32 - 500.0, y as f32 - 770.0);
            let ring = 0.5 + 0.5 * (dx.hypot(dy) * 0.16).sin();
            ink[y * WIDTH + x] = 0.15 + 0.6 * ring;
        }
    }
}
