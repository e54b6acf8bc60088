//! `dogleaf eink`: one turn of a real book as a panel of electronic paper shows it.

mod play;
mod prints;
mod report;
mod show;

use crate::args::{EinkArgs, LayoutName, StyleName};
use crate::error::{CliError, shown};
use crate::turn::shape;
use dogleaf_content::Book;
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{BookSpec, Direction, PaperSpec, Preset};
use dogleaf_eink::{Layout, Panel, Policy, Stage, Style};
use play::Play;
use prints::Prints;

/// Turns a page.
pub(crate) fn eink(args: &EinkArgs) -> Result<(), CliError> {
    let content = Book::open(&args.book)?;
    let book = shape::spec(&content, args.page, args.direction.into(), &shown(&args.book))?;
    let panel = Panel::from(args.panel);
    let [width, height] = args.size.unwrap_or([panel.width, panel.height]);
    let panel = Panel { width, height, ..panel };
    let layout = layout(args.layout, &book);
    let stage = Stage::new(&book, &panel, layout).map_err(|e| CliError::Call(e.to_string()))?;
    let prints = Prints::new(content, &stage);
    let show = args.out.as_ref().map(|out| show::Show::create(out, &panel)).transpose()?;
    let policy = Policy { style: args.style.into(), key_frames: args.key_frames, ..Policy::READER };
    let play = Play { setup: setup(&book, &stage), panel, policy, stage, forward: !args.back };
    let told = play.run(&prints, show)?;
    report::print(&told, args.json)
}

/// A page alone is the one that is turned.
fn layout(name: LayoutName, book: &BookSpec) -> Layout {
    match (name, book.direction) {
        (LayoutName::Spread, _) => Layout::Spread,
        (LayoutName::Single, Direction::Ltr) => Layout::Right,
        (LayoutName::Single, Direction::Rtl) => Layout::Left,
    }
}

fn setup(book: &BookSpec, stage: &Stage) -> Setup {
    let paper = PaperSpec::from(Preset::Book);
    let leaves = f64::from(book.leaves()) * 0.5;
    let view = stage.view(leaves * paper.thickness_mm * 1e-3);
    Setup { view, paper, ..Setup::reading(*book, 1, 1) }
}

impl From<StyleName> for Style {
    fn from(name: StyleName) -> Self {
        match name {
            StyleName::Leaf => Self::Leaf,
            StyleName::Stripe => Self::Stripe,
        }
    }
}
