//! The command line: words, their help, their examples.

use crate::sim::RealName;
use clap::{Args, Parser, Subcommand, ValueEnum};
use dogleaf_core::scene::{Direction, Fidelity, Handling};
use std::path::PathBuf;

/// Turns the pages of real books, as paper turns.
#[derive(Debug, Parser)]
#[command(
    name = "dogleaf",
    version,
    propagate_version = true,
    max_term_width = 100,
    after_help = "Examples:
  dogleaf turn novel.pdf -o out.webp       a page of the book turns
  dogleaf run scene.toml --json -          a scene, frame by frame
  dogleaf replay turn.dlr                  the same bits again?
  dogleaf bench                            what a step costs here
  dogleaf cost --quick                     what accuracy costs in time
  dogleaf eink novel.pdf -o strip.png      a turn on electronic paper

Exit code 0: done; 1: a check failed; 2: bad input."
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Turn(TurnArgs),
    Run(RunArgs),
    Replay(ReplayArgs),
    Bench(BenchArgs),
    Cost(crate::cost::CostArgs),
    Eink(EinkArgs),
    Gestures(GesturesArgs),
}

/// How exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum FidelityName {
    /// One step a frame, one collision pass.
    Draft,
    /// One step a frame.
    #[default]
    Standard,
    /// Four steps a frame.
    Fine,
    /// Sixteen steps a frame: not for readers.
    Reference,
}

impl FidelityName {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Draft => "draft",
            Self::Standard => "standard",
            Self::Fine => "fine",
            Self::Reference => "reference",
        }
    }
}

impl From<FidelityName> for Fidelity {
    fn from(name: FidelityName) -> Self {
        match name {
            FidelityName::Draft => Self::Draft,
            FidelityName::Standard => Self::Standard,
            FidelityName::Fine => Self::Fine,
            FidelityName::Reference => Self::Reference,
        }
    }
}

/// Reading direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum DirectionName {
    /// Leaves turn from right to left.
    #[default]
    Ltr,
    /// Leaves turn from left to right.
    Rtl,
}

impl From<DirectionName> for Direction {
    fn from(name: DirectionName) -> Self {
        match name {
            DirectionName::Ltr => Self::Ltr,
            DirectionName::Rtl => Self::Rtl,
        }
    }
}

/// How a finger holds a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum HandName {
    /// On a spring, as the book paper's: stretches the sheet least.
    #[default]
    Spring,
    /// The paper stays under the finger, as on a touch screen; best with `--fidelity fine`.
    Finger,
}

impl From<HandName> for Handling {
    fn from(name: HandName) -> Self {
        match name {
            HandName::Spring => Self::SPRING,
            HandName::Finger => Self::FINGER,
        }
    }
}

/// Turns a page of a book and shows it.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  dogleaf turn novel.pdf
  dogleaf turn comic.cbz -o frames/ --direction rtl
  dogleaf turn scans/ -o turn.gif --page 42 --size 640x480
  dogleaf turn novel.pdf --gesture flick.jsonl --fidelity fine --json
  dogleaf turn novel.pdf --ribbon          a bookmark lies where the book is open
  dogleaf turn novel.pdf --ribbon=40       it marks page 40")]
pub(crate) struct TurnArgs {
    /// A PDF, a CBZ, or a folder of images.
    pub(crate) book: PathBuf,
    /// Animation (.webp, .gif, .png) or a folder for frames.
    #[arg(short, long, default_value = "turn.webp")]
    pub(crate) out: PathBuf,
    /// Page the book is open at, counted from 1; about a third in if not given.
    #[arg(long, value_name = "N")]
    pub(crate) page: Option<u32>,
    /// Pointer samples, one line of JSON each, made for a view of 960x720; a slow turn if not given.
    #[arg(long, value_name = "FILE")]
    pub(crate) gesture: Option<PathBuf>,
    /// Reading direction.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) direction: DirectionName,
    /// How exact.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) fidelity: FidelityName,
    /// How the finger holds the page.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) hand: HandName,
    /// Sew a ribbon bookmark to the spine: at a page, or where the book is open.
    #[arg(long, value_name = "PAGE", num_args = 0..=1, require_equals = true, default_missing_value = "0")]
    pub(crate) ribbon: Option<u32>,
    /// Pixels of the picture.
    #[arg(long, value_name = "WxH", default_value = "960x720", value_parser = size)]
    pub(crate) size: [u32; 2],
    /// Print one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Runs a scene.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  dogleaf run turn.toml
  dogleaf run lone_leaf.toml --frames 300 --json - | tail -1
  dogleaf run turn.toml --real f64 --fidelity reference --json frames.jsonl
  dogleaf run turn.toml --record turn.dlr --obj meshes/ -o turn.webp")]
pub(crate) struct RunArgs {
    /// The scene, a TOML file.
    pub(crate) scene: PathBuf,
    /// Frames to run; if not given until everything is at rest, at most 20 s after the last sample.
    #[arg(long, value_name = "N")]
    pub(crate) frames: Option<u32>,
    /// Write one line of JSON a frame; - writes to the standard output.
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Write the meshes of every frame into this folder, as Wavefront OBJ.
    #[arg(long, value_name = "DIR")]
    pub(crate) obj: Option<PathBuf>,
    /// Animation (.webp, .gif, .png) or a folder for frames.
    #[arg(short, long)]
    pub(crate) out: Option<PathBuf>,
    /// Write what is heard. No scene of this version sounds.
    #[arg(long, value_name = "FILE")]
    pub(crate) wav: Option<PathBuf>,
    /// Write a recording for `dogleaf replay`.
    #[arg(long, value_name = "FILE.dlr")]
    pub(crate) record: Option<PathBuf>,
    /// Scalar the core runs on.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) real: RealName,
    /// How exact.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) fidelity: FidelityName,
}

/// Runs a recording again and names the first step that diverges.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  dogleaf replay turn.dlr
  dogleaf replay turn.dlr --json

Exit code 1 if a step diverges.")]
pub(crate) struct ReplayArgs {
    /// The recording.
    pub(crate) recording: PathBuf,
    /// Print one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Measures what a step costs on this machine, part by part.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  dogleaf bench
  dogleaf bench --json
  RUSTFLAGS='-C target-cpu=x86-64-v3' cargo run --release -- bench

Exit code 1 if a step allocates memory.")]
pub(crate) struct BenchArgs {
    /// Print one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
    /// Turns of each kind; more are steadier.
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) turns: u32,
}

/// A panel of electronic paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum PanelName {
    /// Six inches, sixteen greys, fast two-tone pictures: readers.
    #[default]
    Reader,
    /// Two tones, 300 ms a picture: bare modules.
    Module,
}

impl From<PanelName> for dogleaf_eink::Panel {
    fn from(name: PanelName) -> Self {
        match name {
            PanelName::Reader => Self::SIX_INCH,
            PanelName::Module => Self::MODULE,
        }
    }
}

/// How many pages a panel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum LayoutName {
    /// Both open pages.
    #[default]
    Spread,
    /// The page that is turned.
    Single,
}

/// What moves over a panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum StyleName {
    /// The leaf itself.
    #[default]
    Leaf,
    /// A stripe of the page after.
    Stripe,
}

/// Turns a page as a panel of electronic paper shows it.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  dogleaf eink novel.pdf -o strip.png
  dogleaf eink novel.pdf -o turn.gif --panel module --style stripe
  dogleaf eink comic.cbz --layout single --size 600x800 --key-frames 2 --json")]
pub(crate) struct EinkArgs {
    /// A PDF, a CBZ, or a folder of images.
    pub(crate) book: PathBuf,
    /// A sheet of all pictures (.png), an animation (.webp, .gif) or a folder for pictures.
    #[arg(short, long)]
    pub(crate) out: Option<PathBuf>,
    /// Page the book is open at, counted from 1; about a third in if not given.
    #[arg(long, value_name = "N")]
    pub(crate) page: Option<u32>,
    /// Reading direction.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) direction: DirectionName,
    /// The panel.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) panel: PanelName,
    /// Pixels of the panel; if not given its own, 800x600 or 800x480.
    #[arg(long, value_name = "WxH", value_parser = panel_size)]
    pub(crate) size: Option<[u16; 2]>,
    /// How many pages are seen.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) layout: LayoutName,
    /// What moves.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) style: StyleName,
    /// Pictures of the turn at most.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(1..=12))]
    pub(crate) key_frames: u8,
    /// Turns back.
    #[arg(long)]
    pub(crate) back: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `800x600`.
fn panel_size(text: &str) -> Result<[u16; 2], String> {
    let sides = size(text).ok().filter(|s| s.iter().all(|s| (64..=2_048).contains(s)));
    sides
        .map(|s| s.map(|side| side as u16))
        .ok_or_else(|| "write it as 800x600, sides of 64 to 2048".to_owned())
}

/// Writes the gestures of `fixtures/gestures` anew.
#[derive(Debug, Args)]
#[command(
    hide = true,
    after_help = "Examples:
  dogleaf gestures fixtures/gestures"
)]
pub(crate) struct GesturesArgs {
    /// Where to.
    pub(crate) folder: PathBuf,
}

/// `960x720`.
fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    let most = dogleaf_render::MAX_SIDE;
    sides
        .filter(|s: &[u32; 2]| s.iter().all(|s| (16..=most).contains(s)))
        .ok_or_else(|| format!("write it as 960x720, sides of 16 to {most}"))
}
