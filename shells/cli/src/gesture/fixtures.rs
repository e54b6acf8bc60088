//! The gestures of `fixtures/gestures`: made here, so that they can be made again.

use super::path::Desk;
use super::{builtin, lines, wild};
use crate::error::CliError;
use crate::scene::PICTURE;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::scene::{BookSpec, PaperSpec, Preset};
use std::path::Path;

/// Seed of the storm.
const SEED: u64 = 20_240_229;

/// The fixture book, open where `dogleaf turn` opens it.
fn fixture_book() -> BookSpec {
    BookSpec { width_m: 0.120, height_m: 0.180, pages: 24, open_at: 8, ..BookSpec::default() }
}

/// Every gesture with the name of its file.
fn all() -> Vec<(&'static str, Vec<Sample>)> {
    let desk = desk(&fixture_book(), Preset::Book.into());
    let seed = PaperSpec { thickness_mm: 0.081_25, ..PaperSpec::default() };
    let seed_desk = self::desk(&BookSpec::default(), seed);
    vec![
        ("slow_turn", builtin::slow_turn(&desk)),
        ("flick", builtin::flick(&desk)),
        ("peek_and_put_back", builtin::peek_and_put_back(&desk)),
        ("corner_turn", builtin::corner_turn(&desk)),
        ("stack", builtin::stack(&desk)),
        ("pull_bookmark", builtin::pull_bookmark(&desk)),
        ("adversarial", wild::storm(SEED, PICTURE)),
        ("seed_turn", builtin::corner_turn(&seed_desk)),
    ]
}

fn desk(book: &BookSpec, paper: PaperSpec) -> Desk {
    let view = View::reading(book.width_m, book.height_m, PICTURE[0], PICTURE[1]);
    Desk::new(&view, book, &paper)
}

/// Writes them all into a folder.
pub(crate) fn write_all(folder: &Path) -> Result<(), CliError> {
    std::fs::create_dir_all(folder).map_err(|e| CliError::write(folder, &e))?;
    for (name, samples) in all() {
        let path = folder.join(name).with_extension("jsonl");
        let text = lines::to_lines(&samples);
        std::fs::write(&path, text).map_err(|e| CliError::write(&path, &e))?;
    }
    Ok(())
}
