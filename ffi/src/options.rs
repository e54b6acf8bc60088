//! What a book is opened with, in the words of an app.

use crate::stage::{Gaze, view};
use dogleaf_core::reading;
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{self, BookSpec, Handling, PaperSpec, Preset, WorldSpec};

/// Paper by name, or by its figures. The names are engineering estimates, not laboratory values.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Enum)]
pub enum Paper {
    /// Copier paper, 80 g/m².
    Office,
    /// Book paper, 65 g/m².
    Book,
    /// Newsprint, 48 g/m².
    Newsprint,
    /// Coated, 120 g/m².
    Coated,
    /// Glossy, 160 g/m².
    Glossy,
    /// Matte, 130 g/m².
    Matte,
    /// Card, 300 g/m².
    Cardboard,
    /// Any other.
    Custom {
        /// Mass per area, g/m².
        areal_mass_gsm: f64,
        /// Thickness, mm.
        thickness_mm: f64,
        /// Young's modulus, GPa.
        youngs_gpa: f64,
        /// Poisson's ratio.
        poisson: f64,
    },
}

impl From<Paper> for PaperSpec {
    fn from(paper: Paper) -> Self {
        match paper {
            Paper::Office => Preset::Office.into(),
            Paper::Book => Preset::Book.into(),
            Paper::Newsprint => Preset::Newsprint.into(),
            Paper::Coated => Preset::Coated.into(),
            Paper::Glossy => Preset::Glossy.into(),
            Paper::Matte => Preset::Matte.into(),
            Paper::Cardboard => Preset::Cardboard.into(),
            Paper::Custom { areal_mass_gsm, thickness_mm, youngs_gpa, poisson } => {
                Self { areal_mass_gsm, thickness_mm, youngs_gpa, poisson, weights: None }
            }
        }
    }
}

/// An enum of the core with a face towards the apps: the same variants, one for one.
macro_rules! mirrored {
    ($(#[$doc:meta])* $name:ident = $core:path { $($(#[$of:meta])* $variant:ident,)+ }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Enum)]
        pub enum $name { $($(#[$of])* $variant,)+ }

        impl From<$name> for $core {
            fn from(value: $name) -> Self {
                match value { $($name::$variant => Self::$variant,)+ }
            }
        }

        impl From<$core> for $name {
            fn from(value: $core) -> Self {
                match value { $(<$core>::$variant => Self::$variant,)+ }
            }
        }
    };
}
pub(crate) use mirrored;

mirrored! {
    /// How the boards are made.
    Cover = scene::Cover {
        /// Two stiff boards hinged at the spine.
        Hard,
        /// The outer leaves are the cover.
        Soft,
    }
}

mirrored! {
    /// Which way one reads.
    Direction = scene::Direction {
        /// Leaves turn from right to left.
        Ltr,
        /// Leaves turn from left to right.
        Rtl,
    }
}

mirrored! {
    /// How much of the book is seen.
    Layout = scene::Pages {
        /// Both open pages.
        Spread,
        /// The page that is turned next fills the view.
        Single,
    }
}

mirrored! {
    /// What accuracy is bought; each costs about two to eight times the one before.
    Fidelity = scene::Fidelity {
        /// For the slowest machines.
        Draft,
        /// One step a frame.
        Standard,
        /// Keeps the paper under the finger: what a touch screen wants.
        Fine,
        /// A reference, not for readers.
        Reference,
    }
}

mirrored! {
    /// How much motion is shown. What becomes of a turn is the same under each.
    MotionPolicy = reading::MotionPolicy {
        /// Every frame.
        Full,
        /// At most one picture between the page before and the page after.
        Reduced,
        /// No picture but the page after.
        None,
        /// A few pictures a second, and the page after.
        EInk,
    }
}

/// What moves, and for how long at most.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Record)]
pub struct Motion {
    /// What is shown.
    pub policy: MotionPolicy,
    /// Longest time from letting a leaf go until it lies, 50,000 to 10,000,000 microseconds; none leaves it to the paper.
    pub cap_us: Option<u32>,
}

impl From<Motion> for reading::Motion {
    fn from(motion: Motion) -> Self {
        Self { policy: motion.policy.into(), cap_us: motion.cap_us }
    }
}

impl From<reading::Motion> for Motion {
    fn from(motion: reading::Motion) -> Self {
        Self { policy: motion.policy.into(), cap_us: motion.cap_us }
    }
}

/// Everything a book is opened with. [`book_options`] fills in what most apps want.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Record)]
pub struct BookOptions {
    /// Printed pages, two a leaf; 1 to 20,000.
    pub pages: u32,
    /// Page the book is open at; 0 is before the first leaf.
    pub open_at: u32,
    /// Width of a page, metres.
    pub width_m: f64,
    /// Height of a page, metres; 0.2 to 5 times the width.
    pub height_m: f64,
    /// Boards.
    pub cover: Cover,
    /// Reading direction.
    pub direction: Direction,
    /// What the leaves are made of.
    pub paper: Paper,
    /// Width of the view, pixels.
    pub width_px: u32,
    /// Height of the view, pixels.
    pub height_px: u32,
    /// Both pages, or one.
    pub layout: Layout,
    /// From where one looks.
    pub gaze: Gaze,
    /// What accuracy is bought.
    pub fidelity: Fidelity,
    /// How hard the finger holds the paper, 0 to 100; 0 is a soft spring.
    pub grip: f64,
    /// Internal step, microseconds: one frame of the display; 100 to 100,000.
    pub step_us: u32,
}

/// A paperback for a touch screen: a spread, seen by a reader at a table, at sixty steps a second.
#[uniffi::export]
#[must_use]
pub fn book_options(pages: u32, width_px: u32, height_px: u32) -> BookOptions {
    let BookSpec { width_m, height_m, .. } = BookSpec::default();
    BookOptions {
        pages,
        open_at: 0,
        width_m,
        height_m,
        cover: Cover::Hard,
        direction: Direction::Ltr,
        paper: Paper::Book,
        width_px,
        height_px,
        layout: Layout::Spread,
        gaze: Gaze::Table,
        fidelity: Fidelity::Fine,
        grip: Handling::FINGER.grip,
        step_us: WorldSpec::TABLE.step_us,
    }
}

impl From<&BookOptions> for Setup {
    fn from(o: &BookOptions) -> Self {
        let book = BookSpec {
            width_m: o.width_m,
            height_m: o.height_m,
            pages: o.pages,
            open_at: o.open_at,
            cover: o.cover.into(),
            direction: o.direction.into(),
        };
        let handling = Handling { grip: o.grip, pages: o.layout.into() };
        let view = view(&book, o.layout, o.gaze, o.width_px, o.height_px);
        let world = WorldSpec { step_us: o.step_us, ..WorldSpec::TABLE };
        let seen = Setup::reading(book, o.width_px, o.height_px);
        Self { paper: o.paper.into(), world, view, fidelity: o.fidelity.into(), handling, ..seen }
    }
}
