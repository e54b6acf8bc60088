//! `dogleaf turn`: a page of a real book is lifted, carried over the spine and laid down.

mod play;
mod report;
mod sewn;
pub(crate) mod shape;

use crate::args::TurnArgs;
use crate::error::{CliError, shown};
use crate::gesture::{self, builtin, path::Desk};
use crate::picture::{Look, PageSource, Pages, Set};
use crate::scene::PICTURE;
use dogleaf_content::Book;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::scene::{BookSpec, PaperSpec, Preset};
use dogleaf_render::anim::Writer;
use play::Play;

/// Frames of the animation a second: every second step.
pub(crate) const FPS: u32 = 30;

/// Turns a page.
pub(crate) fn turn(args: &TurnArgs) -> Result<(), CliError> {
    let content = Book::open(&args.book)?;
    let book = shape::spec(&content, args.page, args.direction.into(), &shown(&args.book))?;
    let paper = PaperSpec::from(Preset::Book);
    // Fingers move in the view their gesture was made for, whatever the size of the picture.
    let hand_view = View::reading(book.width_m, book.height_m, PICTURE[0], PICTURE[1]);
    let samples = samples(args, &Desk::new(&hand_view, &book, &paper))?;
    let mut look = look(args, content, &book, &paper)?;
    // Before the work, so that a place nobody can write to is refused at once.
    let [width, height] = args.size;
    let writer = Writer::create(&args.out, width, height, FPS)?;
    let (fidelity, handling) = (args.fidelity.into(), args.hand.into());
    let ribbon = args.ribbon.map(|page| sewn::place(page, &book)).transpose()?;
    let play = Play { book, paper, view: hand_view, fidelity, handling, ribbon };
    let (film, figures) = play.run(&samples)?;
    film.write(&mut look, writer)?;
    report::print(&figures, args.json, &shown(&args.out))
}

fn samples(args: &TurnArgs, desk: &Desk) -> Result<Vec<Sample>, CliError> {
    match &args.gesture {
        Some(file) => gesture::load(file),
        None => Ok(builtin::corner_turn(desk)),
    }
}

fn look(
    args: &TurnArgs,
    content: Book,
    book: &BookSpec,
    paper: &PaperSpec,
) -> Result<Look, CliError> {
    let [width, height] = args.size;
    let set = Set {
        view: View::reading(book.width_m, book.height_m, width, height),
        direction: book.direction,
        cover: Some(book.cover),
        floor_m: None,
        thickness_m: (paper.thickness_mm * 1e-3) as f32,
    };
    let size = shape::page_pixels(&set.view, book);
    Look::new(set, Pages::new(Some(PageSource { book: content, size })))
}
