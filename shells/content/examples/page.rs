//! Writes one page of a book as a PNG: `cargo run -p dogleaf-content --example page BOOK 3 out.png`.

use dogleaf_content::Book;
use std::error::Error;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match write_page(&args) {
        Ok(line) => {
            println!("{line}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn write_page(args: &[String]) -> Result<String, Box<dyn Error>> {
    let [book, page, out, rest @ ..] = args else {
        return Err("usage: page BOOK PAGE OUT.png [MAX_WIDTH MAX_HEIGHT]".into());
    };
    let side = |i: usize| rest.get(i).map_or(Ok(1200), |text| text.parse());
    let book = Book::open(book.as_ref())?;
    let index = page.parse::<usize>()?.checked_sub(1).ok_or("pages are counted from 1")?;
    let picture = book.page(index, side(0)?, side(1)?)?;
    let (width, height) = (picture.width, picture.height);
    image::save_buffer(out, &picture.rgba, width, height, image::ColorType::Rgba8)?;
    Ok(format!("{book:?}, aspect {:.3}: page {page} as {width} x {height}", book.aspect()))
}
