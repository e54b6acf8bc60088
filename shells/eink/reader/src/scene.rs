//! The book, the panel and the finger that are played: the same on every target.

use crate::Touches;
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{BookSpec, PaperSpec, Preset};
use dogleaf_eink::{Layout, Panel, Policy, Stage, StageError};

/// Six inches, sixteen greys.
pub const PANEL: Panel = Panel::SIX_INCH;
/// Some four key frames a turn.
pub const POLICY: Policy = Policy::READER;
/// Pages 13 to 16 of `fixtures/books/old-verses.pdf`, made by `cargo ci eink --bless`.
pub const PAGES: &[u8] = include_bytes!("../../../../fixtures/books/old-verses.dlp");
/// A page carried over, one flicked back, one looked under and put back.
pub const FINGER: &str = include_str!("../../../../fixtures/gestures/eink.jsonl");
/// When the last leaf has come to lie and the panel shows it, microseconds.
pub const END_US: u64 = 13_000_000;
/// How long nothing happens after that, microseconds.
pub const REST_US: u64 = 10_000_000;

/// A small book, open where its built-in pages are.
#[must_use]
pub fn book() -> BookSpec {
    BookSpec { width_m: 0.12, height_m: 0.18, pages: 24, open_at: 14, ..BookSpec::default() }
}

/// Where its pages stand on the panel.
///
/// # Errors
///
/// None of this scene's.
pub fn stage() -> Result<Stage, StageError> {
    Stage::new(&book(), &PANEL, Layout::Spread)
}

/// What the book is opened with, seen from the stage.
#[must_use]
pub fn setup(stage: &Stage) -> Setup {
    let (book, paper) = (book(), PaperSpec::from(Preset::Book));
    let thick = f64::from(book.leaves()) * 0.5 * paper.thickness_mm * 1e-3;
    Setup { view: stage.view(thick), paper, ..Setup::reading(book, 1, 1) }
}

/// The recorded finger.
#[must_use]
pub fn touches() -> Touches<'static> {
    Touches::of(FINGER)
}
