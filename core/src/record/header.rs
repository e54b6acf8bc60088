//! The head of a recording: everything a book is opened with.

use super::code::Presence;
use super::error::RecordError;
use super::wire::{Done, Wire};
use super::{KIND, VERSION};
use crate::book::Book;
use crate::grid::Grid;
use crate::hand::View;
use crate::real::Real;
use crate::scene::{
    BookSpec, Fidelity, Formulation, Handling, PaperSpec, SpecError, Weights, WorldSpec,
};
use crate::state::Fnv;
use core::fmt;

/// What decides the bits beside the input: this crate and the arithmetic it stands on. A recording keeps
/// its hash, so that a divergence between two builds can be told from a divergence within one.
pub const MADE_BY: &str = concat!(
    "dogleaf-core ",
    env!("CARGO_PKG_VERSION"),
    ", libm 0.2.16, nalgebra 0.35.0, wide 1.7.1"
);

/// Numbers a book is simulated in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Tier {
    /// `f32`.
    F32,
    /// `f64`.
    F64,
}

impl Tier {
    /// The tier of a scalar.
    pub fn of<R: Real>() -> Self {
        if size_of::<R>() == size_of::<f32>() { Self::F32 } else { Self::F64 }
    }
}

impl fmt::Display for Tier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        })
    }
}

/// All that a book is opened with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setup {
    /// The book.
    pub book: BookSpec,
    /// Its paper.
    pub paper: PaperSpec,
    /// The world.
    pub world: WorldSpec,
    /// Where the reader looks from at first.
    pub view: View,
    /// How exact.
    pub fidelity: Fidelity,
    /// Which equations.
    pub formulation: Formulation,
    /// How a finger and a page meet.
    pub handling: Handling,
}

impl Setup {
    /// A setup no book opens with: there is no view yet.
    pub(crate) const NONE: Self = Self {
        book: BookSpec::ONE_LEAF,
        paper: PaperSpec::OFFICE,
        world: WorldSpec::TABLE,
        view: View::NONE,
        fidelity: Fidelity::Standard,
        formulation: Formulation::Condensed,
        handling: Handling::SPRING,
    };

    /// What a reader at a table sees of a book in a picture of given size; everything else as by default.
    pub fn reading(book: BookSpec, width_px: u32, height_px: u32) -> Self {
        Self {
            book,
            paper: PaperSpec::default(),
            world: WorldSpec::default(),
            view: View::reading(book.width_m, book.height_m, width_px, height_px),
            fidelity: Fidelity::default(),
            formulation: Formulation::default(),
            handling: Handling::default(),
        }
    }

    /// The same for fingers on a screen: the paper stays under them, at [`Fidelity::Fine`].
    pub fn fingers(book: BookSpec, width_px: u32, height_px: u32) -> Self {
        let (fidelity, handling) = (Fidelity::Fine, Handling::FINGER);
        Self { fidelity, handling, ..Self::reading(book, width_px, height_px) }
    }

    /// Refuses what no book could be opened with.
    ///
    /// # Errors
    ///
    /// The first bad field.
    pub fn check(&self) -> Result<(), SpecError> {
        self.book.check()?;
        self.paper.check()?;
        self.world.check()?;
        self.view.check()?;
        self.handling.check()
    }

    /// Opens a book with it, in place.
    ///
    /// # Errors
    ///
    /// As [`Book::open`]; and [`RecordError::Formulation`] for one that [`Book`] does not solve.
    pub fn open<R: Real, G: Grid>(&self, book: &mut Book<R, G>) -> Result<(), RecordError> {
        if self.formulation != Formulation::Condensed {
            return Err(RecordError::Formulation);
        }
        self.handling.check()?;
        book.open(&self.book, &self.paper, &self.world, &self.view, self.fidelity)?;
        book.handle(self.handling)?;
        Ok(())
    }

    fn fields(&mut self, wire: &mut impl Wire) -> Done {
        let Self { book, paper, world, view, fidelity, formulation, handling } = self;
        book_fields(book, wire)?;
        paper_fields(paper, wire)?;
        world_fields(world, wire)?;
        view_fields(view, wire)?;
        wire.code(fidelity)?;
        wire.code(formulation)?;
        let Handling { grip, pages } = handling;
        wire.f64(grip)?;
        wire.code(pages)
    }
}

/// The head of a recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Header {
    /// Numbers it was made with.
    pub tier: Tier,
    /// Nodes of the leaf, across and along.
    pub grid: [u8; 2],
    /// Hash of the [`MADE_BY`] of the build that made it.
    pub made_by: u64,
    /// What the book was opened with.
    pub setup: Setup,
}

impl Header {
    /// The head of a recording of such a book, made by this build.
    pub fn of<R: Real, G: Grid>(setup: &Setup) -> Self {
        Self { tier: Tier::of::<R>(), grid: nodes::<G>(), made_by: this_build(), setup: *setup }
    }

    /// Whether this very build made it: same version of the core, same arithmetic.
    pub fn same_build(&self) -> bool {
        self.made_by == this_build()
    }

    /// Refuses a book of other numbers or on another grid.
    ///
    /// # Errors
    ///
    /// [`RecordError::Tier`] or [`RecordError::Grid`].
    pub fn fits<R: Real, G: Grid>(&self) -> Result<(), RecordError> {
        let (tier, grid) = (Tier::of::<R>(), nodes::<G>());
        if self.tier != tier {
            return Err(RecordError::Tier { recorded: self.tier, here: tier });
        }
        if self.grid != grid {
            return Err(RecordError::Grid { recorded: self.grid, here: grid });
        }
        Ok(())
    }

    /// For a reader to fill in.
    pub(super) fn blank() -> Self {
        let setup = Setup::reading(BookSpec::default(), 1, 1);
        Self { tier: Tier::F32, grid: [0; 2], made_by: 0, setup }
    }

    /// All fields from the magic on. Reading refuses another magic or version before it goes on.
    pub(super) fn fields(&mut self, wire: &mut impl Wire) -> Done {
        preamble::<KIND, VERSION>(wire)?;
        let Self { tier, grid, made_by, setup } = self;
        wire.code(tier)?;
        grid.iter_mut().try_for_each(|n| wire.u8(n))?;
        wire.u64(made_by)?;
        setup.fields(wire)
    }
}

/// Magic and version; the magic as its four bytes, little end first, so that each kind of recording has its own code and counts its own versions.
pub(crate) fn preamble<const KIND: u32, const VERSION: u16>(wire: &mut impl Wire) -> Done {
    let (mut magic, mut version) = (KIND.to_le_bytes(), VERSION);
    wire.bytes(&mut magic)?;
    if magic != KIND.to_le_bytes() {
        return Err(RecordError::NotARecording);
    }
    wire.u16(&mut version)?;
    if version == VERSION { Ok(()) } else { Err(RecordError::Version(version)) }
}

/// The hash of [`MADE_BY`].
pub(crate) fn this_build() -> u64 {
    let mut hash = Fnv::default();
    MADE_BY.bytes().for_each(|byte| hash.word(u64::from(byte)));
    hash.value()
}

fn nodes<G: Grid>() -> [u8; 2] {
    [G::NX, G::NZ].map(|n| u8::try_from(n).unwrap_or(u8::MAX))
}

// Every spec is taken apart field by field, so that a field added to it does not compile here until it
// has a place in the format.

fn book_fields(spec: &mut BookSpec, wire: &mut impl Wire) -> Done {
    let BookSpec { width_m, height_m, pages, open_at, cover, direction } = spec;
    wire.f64(width_m)?;
    wire.f64(height_m)?;
    wire.u32(pages)?;
    wire.u32(open_at)?;
    wire.code(cover)?;
    wire.code(direction)
}

fn paper_fields(spec: &mut PaperSpec, wire: &mut impl Wire) -> Done {
    let PaperSpec { areal_mass_gsm, thickness_mm, youngs_gpa, poisson, weights } = spec;
    for field in [areal_mass_gsm, thickness_mm, youngs_gpa, poisson] {
        wire.f64(field)?;
    }
    let mut presence = if weights.is_some() { Presence::Present } else { Presence::Absent };
    wire.code(&mut presence)?;
    if presence == Presence::Absent {
        *weights = None;
        return Ok(());
    }
    let Weights { bend_3d, bend_2d, glue, iso_3d, position } =
        weights.get_or_insert_with(Weights::default);
    [bend_3d, bend_2d, glue, iso_3d, position].into_iter().try_for_each(|field| wire.f64(field))
}

fn world_fields(spec: &mut WorldSpec, wire: &mut impl Wire) -> Done {
    let WorldSpec { gravity, damping_per_s, step_us, seed } = spec;
    wire.point(gravity)?;
    wire.f64(damping_per_s)?;
    wire.u32(step_us)?;
    wire.u64(seed)
}

/// Also the fields of a look in the stream.
pub(super) fn view_fields(view: &mut View, wire: &mut impl Wire) -> Done {
    let View { eye_m, target_m, fov_y_deg, width_px, height_px } = view;
    wire.point(eye_m)?;
    wire.point(target_m)?;
    wire.f64(fov_y_deg)?;
    wire.u32(width_px)?;
    wire.u32(height_px)
}
