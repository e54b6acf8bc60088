//! Prints pages of a book for a firmware: `print BOOK FIRST PAGES OUT`. Pages are counted from 0 and are as large as the
//! reader's panel wants them.

use dogleaf_content::{Book, Picture};
use dogleaf_eink_reader::built::{HEAD, MAGIC, SIDE};
use dogleaf_eink_reader::scene;
use std::error::Error;

/// A page's levels, row by row.
struct Page {
    levels: Vec<u8>,
    width: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [book, first, pages, out] = &args[..] else { return Err("BOOK FIRST PAGES OUT".into()) };
    let (first, pages): (u16, u16) = (first.parse()?, pages.parse()?);
    let content = Book::open(book.as_ref())?;
    let size = scene::stage().map_err(|e| e.to_string())?.page();
    let mut file = MAGIC.to_vec();
    for n in [size[0], size[1], first, pages] {
        file.extend(n.to_le_bytes());
    }
    let mut bodies = Vec::new();
    let start = HEAD + 4 * usize::from(pages);
    for page in first..first + pages {
        file.extend(u32::try_from(start + bodies.len())?.to_le_bytes());
        let [w, h] = size.map(u32::from);
        bodies.extend(packed(&levels(&content.page(usize::from(page), w, h)?, size))?);
    }
    file.extend(bodies);
    std::fs::write(out, &file)?;
    println!("{out}: {pages} pages of {}x{}, {} bytes", size[0], size[1], file.len());
    Ok(())
}

/// The nearest of sixteen greys; the picture in the middle of the page.
fn levels(picture: &Picture, [w, h]: [u16; 2]) -> Page {
    let (w, h) = (u32::from(w), u32::from(h));
    let [left, top] = [w.saturating_sub(picture.width) / 2, h.saturating_sub(picture.height) / 2];
    let cells = (0..h).flat_map(|y| (0..w).map(move |x| (x, y)));
    let level = |(x, y): (u32, u32)| {
        let inside = x.checked_sub(left).zip(y.checked_sub(top));
        let pixel = inside.and_then(|(x, y)| picture.pixel(x, y));
        pixel.map_or(15, |[r, g, b, _]| {
            let luma = (u32::from(r) * 54 + u32::from(g) * 183 + u32::from(b) * 19) / 256;
            ((luma + 8) / 17) as u8
        })
    };
    Page { levels: cells.map(level).collect(), width: w as usize }
}

/// Strips, then tiles.
fn packed(page: &Page) -> Result<Vec<u8>, Box<dyn Error>> {
    let (mut strips, mut tiles) = (Vec::new(), Vec::new());
    let (mut count, across) = (0_usize, page.width.div_ceil(SIDE));
    for strip in 0..(page.levels.len() / page.width).div_ceil(SIDE) {
        strips.extend(u16::try_from(count)?.to_le_bytes());
        let before = count;
        for group in 0..across.div_ceil(8) {
            let (mut there, from) = (0_u8, u8::try_from(count - before)?);
            for bit in 0..8 {
                let tile = tile(page, group * 8 + bit, strip);
                if tile.iter().any(|&level| level != 15) {
                    there |= 1 << bit;
                    count += 1;
                    tiles.extend(tile.chunks_exact(2).map(|p| p[0] | p[1] << 4));
                }
            }
            strips.extend([there, from]);
        }
    }
    strips.extend(tiles);
    Ok(strips)
}

/// Levels of a tile, row by row; white beyond the page.
fn tile(page: &Page, column: usize, strip: usize) -> Vec<u8> {
    let cells = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    let level = |(x, y)| {
        let x = column * SIDE + x;
        let row = page.levels.chunks_exact(page.width).nth(strip * SIDE + y);
        row.and_then(|r| r.get(x)).copied().unwrap_or(15)
    };
    cells.map(level).collect()
}
