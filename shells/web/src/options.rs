//! What a book is opened with, in a page's words: strings where JavaScript has no enums.

use crate::error::Refused;
use crate::view::{Gaze, view};
use dogleaf_core::reading::MotionPolicy;
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{
    BookSpec, Cover, Direction, Fidelity, Handling, Pages, PaperSpec, Preset, WorldSpec,
};

/// A table of words and what they stand for.
pub type Words<T> = [(&'static str, T)];

/// How the boards are made.
pub const COVERS: &Words<Cover> = &[("hard", Cover::Hard), ("soft", Cover::Soft)];
/// Which way one reads.
pub const DIRECTIONS: &Words<Direction> = &[("ltr", Direction::Ltr), ("rtl", Direction::Rtl)];
/// How much of the book is seen.
pub const LAYOUTS: &Words<Pages> = &[("spread", Pages::Spread), ("single", Pages::Single)];
/// From where one looks.
pub const GAZES: &Words<Gaze> = &[("table", Gaze::Table), ("above", Gaze::Above)];

/// What a word stands for.
///
/// # Errors
///
/// One line with all words that may stand there.
pub fn named<T: Copy>(what: &str, word: &str, table: &Words<T>) -> Result<T, Refused> {
    let known = table.iter().find(|(name, _)| *name == word);
    known.map(|&(_, value)| value).ok_or_else(|| {
        let names: Vec<&str> = table.iter().map(|(name, _)| *name).collect();
        Refused::new("refused", format!("{what} is one of {}, not `{word}`", names.join(", ")))
    })
}

/// The word of a value.
pub fn word<T: Copy + PartialEq>(value: T, table: &Words<T>) -> &'static str {
    table.iter().find(|(_, known)| *known == value).map_or("", |(name, _)| name)
}

/// Paper by name.
///
/// # Errors
///
/// As [`named`].
pub fn paper(name: &str) -> Result<PaperSpec, Refused> {
    named("paper", name, &Preset::ALL).map(PaperSpec::from)
}

/// How much motion is shown.
///
/// # Errors
///
/// As [`named`].
pub fn policy(name: &str) -> Result<MotionPolicy, Refused> {
    named("motion.policy", name, &MotionPolicy::ALL)
}

/// Everything a book is opened with; the names and meanings are those of the other shells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BookOptions {
    /// The book.
    pub book: BookSpec,
    /// What the leaves are made of.
    pub paper: PaperSpec,
    /// Size of the view, pixels.
    pub size_px: [u32; 2],
    /// Both pages, or one.
    pub layout: Pages,
    /// From where one looks.
    pub gaze: Gaze,
    /// What accuracy is bought.
    pub fidelity: Fidelity,
    /// How hard the finger holds the paper, 0 to 100.
    pub grip: f64,
    /// Internal step, microseconds.
    pub step_us: u32,
}

impl BookOptions {
    /// A paperback under a finger: a spread, seen by a reader at a table, at sixty steps a second.
    #[must_use]
    pub fn new(pages: u32, width_px: u32, height_px: u32) -> Self {
        Self {
            book: BookSpec { pages, open_at: 0, ..BookSpec::default() },
            paper: Preset::Book.into(),
            size_px: [width_px, height_px],
            layout: Pages::Spread,
            gaze: Gaze::Table,
            fidelity: Fidelity::Fine,
            grip: Handling::FINGER.grip,
            step_us: WorldSpec::TABLE.step_us,
        }
    }

    /// What the core opens.
    #[must_use]
    pub fn setup(&self) -> Setup {
        let [width, height] = self.size_px;
        Setup {
            paper: self.paper,
            world: WorldSpec { step_us: self.step_us, ..WorldSpec::TABLE },
            view: view(&self.book, self.layout, self.gaze, self.size_px),
            fidelity: self.fidelity,
            handling: Handling { grip: self.grip, pages: self.layout },
            ..Setup::reading(self.book, width, height)
        }
    }
}

#[cfg(test)]
mod check {
    use super::{BookOptions, COVERS, named, paper, policy, word};
    use dogleaf_core::scene::Cover;

    #[test]
    fn words_are_known_both_ways_and_others_refused_in_one_line() {
        assert_eq!(named("cover", "soft", COVERS), Ok(Cover::Soft));
        assert_eq!(word(Cover::Soft, COVERS), "soft");
        let why = named("cover", "leather", COVERS).map_err(|e| e.text);
        assert_eq!(why, Err("cover is one of hard, soft, not `leather`".to_owned()));
        assert!(paper("glossy").is_ok() && paper("vellum").is_err());
        assert!(policy("reduced").is_ok() && policy("wild").is_err());
    }

    #[test]
    fn what_apps_open_by_default_is_sound() {
        assert_eq!(BookOptions::new(24, 960, 720).setup().check(), Ok(()));
        assert!(BookOptions::new(0, 960, 720).setup().check().is_err(), "a book without pages");
    }
}
