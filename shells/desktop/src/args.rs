//! The command line.

use clap::{Parser, ValueEnum};
use dogleaf_core::reading::{Motion, MotionPolicy};
use dogleaf_core::scene::{Direction, Fidelity, Handling, Pages};
use dogleaf_desktop::Options;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  dogleaf-desktop novel.pdf
  dogleaf-desktop manga.cbz --direction rtl --page 40
  dogleaf-desktop novel.pdf --single --size 600x900
  dogleaf-desktop novel.pdf --record reading.dlr
  dogleaf-desktop novel.pdf --screenshot turn.png --gesture corner_turn.jsonl --at 0.55

Keys: arrows, Space, Page Up, Page Down turn; Home, End turn all; with a leaf under the mouse, Shift and an arrow or
the wheel takes one more leaf or gives one back; Escape puts the leaf back, or leaves; F11 fills the screen.";

/// Reads a book as paper, in a window.
#[derive(Debug, Parser)]
#[command(name = "dogleaf-desktop", version, after_help = EXAMPLES)]
pub(crate) struct Args {
    /// A PDF, a CBZ, or a folder of images.
    pub(crate) book: PathBuf,
    /// Page to open at, counted from 1 [default: a third of the book].
    #[arg(long)]
    pub(crate) page: Option<u32>,
    /// Which way one reads.
    #[arg(long, value_enum, default_value = "ltr")]
    direction: Way,
    /// What is seen of a turn.
    #[arg(long, value_enum, default_value = "full")]
    policy: Policy,
    /// How exact the paper is.
    #[arg(long, value_enum, default_value = "fine")]
    fidelity: Exact,
    /// How hard a hand holds, 0 (a spring, as in the paper on books) to 100.
    #[arg(long, default_value_t = Handling::FINGER.grip)]
    grip: f64,
    /// Shows one page instead of two.
    #[arg(long)]
    single: bool,
    /// Window, or picture, in pixels.
    #[arg(long, value_parser = size, default_value = "960x720")]
    size: [u32; 2],
    /// Records everything the book is handed.
    #[arg(long, value_name = "FILE.dlr")]
    pub(crate) record: Option<PathBuf>,
    /// Plays a recorded gesture; the window closes after it. Places are those of a picture of 960x720.
    #[arg(long, value_name = "FILE.jsonl")]
    pub(crate) gesture: Option<PathBuf>,
    /// Saves a picture and opens no window.
    #[arg(long, value_name = "FILE.png")]
    pub(crate) screenshot: Option<PathBuf>,
    /// When the picture is taken, seconds into the gesture.
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, allow_hyphen_values = true)]
    pub(crate) at: f64,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Way {
    Ltr,
    Rtl,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Policy {
    Full,
    Reduced,
    None,
    Eink,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Exact {
    Draft,
    Standard,
    Fine,
    Reference,
}

impl Args {
    /// How the book is opened. A gesture is played in the picture it was made for.
    pub(crate) fn options(&self) -> Options {
        let policy = match self.policy {
            Policy::Full => MotionPolicy::Full,
            Policy::Reduced => MotionPolicy::Reduced,
            Policy::None => MotionPolicy::None,
            Policy::Eink => MotionPolicy::EInk,
        };
        let fidelity = match self.fidelity {
            Exact::Draft => Fidelity::Draft,
            Exact::Standard => Fidelity::Standard,
            Exact::Fine => Fidelity::Fine,
            Exact::Reference => Fidelity::Reference,
        };
        Options {
            direction: match self.direction {
                Way::Ltr => Direction::Ltr,
                Way::Rtl => Direction::Rtl,
            },
            fidelity,
            handling: Handling {
                grip: self.grip,
                pages: if self.single { Pages::Single } else { Pages::Spread },
            },
            motion: Motion { policy, cap_us: None },
            page: self.page,
            size: if self.screenshot.is_some() { Options::default().size } else { self.size },
        }
    }

    /// Size of the window or the picture.
    pub(crate) fn size(&self) -> [u32; 2] {
        self.size
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').map(|(w, h)| [w.parse::<u32>(), h.parse()]);
    match sides {
        Some([Ok(w), Ok(h)]) if [w, h].iter().all(|s| (64..=8192).contains(s)) => Ok([w, h]),
        _ => Err("wanted WIDTHxHEIGHT in pixels, 64 to 8192 each".to_owned()),
    }
}
