//! The gestures of `fixtures/gestures`: made here, so that they can be made again.

use super::path::Desk;
use super::{builtin, lines, wild};
use crate::error::CliError;
use crate::scene::PICTURE;
use dogleaf_core::hand::{Sample, View};
use dogleaf_core::scene::{BookSpec, PaperSpec};
use std::path::Path;

/// The fixture book: its size, its pages, and where `dogleaf turn` opens it.
const BOOK: (f64, f64, u32, u32) = (0.120, 0.180, 32, 10);
/// Seed of the storm.
const SEED: u64 = 20_240_229;

/// Every gesture with the name of its file.
pub(crate) fn all() -> Vec<(&'static str, Vec<Sample>)> {
    let (width_m, height_m, pages, open_at) = BOOK;
    let book = BookSpec { width_m, height_m, pages, open_at, ..BookSpec::default() };
    let view = View::reading(width_m, height_m, PICTURE[0], PICTURE[1]);
    let desk = Desk::new(&view, &book, &PaperSpec::default());
    vec![
        ("slow_turn", builtin::slow_turn(&desk)),
        ("flick", builtin::flick(&desk)),
        ("peek_and_put_back", builtin::peek_and_put_back(&desk)),
        ("corner_turn", builtin::corner_turn(&desk)),
        ("stack", builtin::stack(&desk)),
        ("adversarial", wild::storm(SEED, PICTURE)),
    ]
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
