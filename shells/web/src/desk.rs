//! An open book with all that lies beside it: its mesh, its recording, what is known of the last step.

use crate::error::Refused;
use crate::mesh::{Mesh, Paper};
use crate::options::BookOptions;
use crate::view::{Gaze, view};
use dogleaf_core::hand::Sample;
use dogleaf_core::reading::{Frame, Notice, Tick};
use dogleaf_core::record::{RecordError, Recorder, Sink};
use dogleaf_core::step::StepReport;

/// Bytes in memory.
#[derive(Debug, Default)]
pub struct Bytes(pub Vec<u8>);

impl Sink for Bytes {
    fn put(&mut self, bytes: &[u8]) -> Result<(), RecordError> {
        self.0.extend_from_slice(bytes);
        Ok(())
    }
}

/// Numbers of what a step answers beside its bits: see [`Desk::figures`].
pub const FIGURES: usize = 12;

/// An open book.
#[derive(Debug)]
pub struct Desk {
    paper: Box<Paper>,
    /// A recording, while one is wanted.
    journal: Option<Recorder<Bytes>>,
    /// What a renderer uploads.
    pub mesh: Mesh,
    report: StepReport,
}

impl Desk {
    /// Opens a book, at rest at its page. Its mesh is there at once.
    ///
    /// # Errors
    ///
    /// `refused`, with the option at fault.
    pub fn open(options: &BookOptions) -> Result<Self, Refused> {
        let mut desk = Self::empty();
        desk.paper.open(&options.setup())?;
        desk.mesh.make(&desk.paper);
        Ok(desk)
    }

    /// Opens the book of a snapshot.
    ///
    /// # Errors
    ///
    /// `recording`: these bytes are no snapshot of this version.
    pub fn from_snapshot(bytes: &[u8]) -> Result<Self, Refused> {
        let mut desk = Self::empty();
        desk.restore(bytes)?;
        Ok(desk)
    }

    fn empty() -> Self {
        Self {
            paper: Box::new(Paper::EMPTY),
            journal: None,
            mesh: Mesh::default(),
            report: StepReport::default(),
        }
    }

    /// The book, to look at.
    #[must_use]
    pub fn paper(&self) -> &Paper {
        &self.paper
    }

    /// The book, for what is not recorded.
    pub fn paper_mut(&mut self) -> &mut Paper {
        &mut self.paper
    }

    /// Takes a pointer sample.
    ///
    /// # Errors
    ///
    /// `pointer`; the book is unchanged.
    pub fn pointer(&mut self, sample: Sample) -> Result<(), Refused> {
        Ok(self.paper.pointer(sample, &mut self.journal)?)
    }

    /// Lets time pass until `now_us`, and makes the mesh if it changed.
    pub fn step(&mut self, now_us: u64) -> Frame {
        let frame = self.paper.step(now_us, &mut self.journal);
        if frame.draw {
            self.mesh.make(&self.paper);
        }
        self.report = frame.report;
        frame
    }

    /// What is known of the mesh and of the last step.
    ///
    /// ```text
    /// generation  pieces_generation  stretch  through  flying_through  status
    /// steps  newton_steps  cuts  passes  chain_solves  parted
    /// ```
    #[must_use]
    pub fn figures(&self) -> [f64; FIGURES] {
        let r = &self.report;
        let stretch = f64::from(self.paper.book().stretch().largest);
        let [through, flying] = self.mesh.through.map(f64::from);
        let counts = [r.steps, r.newton_steps, r.cuts, r.passes, r.chain_solves, r.parted];
        let [steps, newton, cuts, passes, solves, parted] = counts.map(f64::from);
        let [generation, pieces] =
            [self.mesh.generation, self.mesh.pieces_generation].map(f64::from);
        let status = f64::from(r.status as u8);
        [
            generation, pieces, stretch, through, flying, status, //
            steps, newton, cuts, passes, solves, parted,
        ]
    }

    /// Looks from elsewhere, in a view of this size.
    ///
    /// # Errors
    ///
    /// `refused`: a view without pixels, or above 16,384.
    pub fn look(&mut self, gaze: Gaze, size_px: [u32; 2]) -> Result<(), Refused> {
        let setup = self.paper.setup();
        let view = view(&setup.book, setup.handling.pages, gaze, size_px);
        Ok(self.paper.look(&view, &mut self.journal)?)
    }

    /// Lets the leaf that nobody holds come to lie at once.
    pub fn skip(&mut self) {
        self.paper.skip(&mut self.journal);
    }

    /// The page goes into the background.
    pub fn pause(&mut self) {
        self.paper.pause(&mut self.journal);
    }

    /// What [`Desk::restore`] needs.
    ///
    /// # Errors
    ///
    /// None that bytes in memory could have.
    pub fn snapshot(&self) -> Result<Vec<u8>, Refused> {
        Ok(self.paper.snapshot(Bytes::default())?.0)
    }

    /// Opens the book of a snapshot in place of this one; the buffers stay where they are.
    ///
    /// # Errors
    ///
    /// `recording`, and nothing was changed.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), Refused> {
        self.paper.restore(bytes)?;
        self.journal = None;
        self.mesh.make(&self.paper);
        Ok(())
    }

    /// A recording begins with a book that was just opened: so it is opened anew at its page.
    ///
    /// # Errors
    ///
    /// `busy` unless everything is at rest; `paused`.
    pub fn start_recording(&mut self) -> Result<(), Refused> {
        if self.paper.paused() {
            return Err(Refused::new("paused", "the book is paused"));
        }
        if self.paper.book().needs_frame() {
            return Err(Refused::new("busy", "a leaf is in the air"));
        }
        let setup = self.paper.setup();
        self.paper.open(&setup)?;
        let grid = Recorder::start::<f32, dogleaf_core::grid::G11x8>(Bytes::default(), &setup)?;
        self.journal = Some(grid);
        Ok(())
    }

    /// Ends the recording: the bytes of a `.dlr` file.
    ///
    /// # Errors
    ///
    /// `recording`: none was started, or a restore dropped it.
    pub fn stop_recording(&mut self) -> Result<Vec<u8>, Refused> {
        let journal = self.journal.take();
        let none = || Refused::new("recording", "nothing is being recorded");
        Ok(journal.ok_or_else(none)?.finish()?.0)
    }

    /// The notices waiting, three numbers each: what, and its one or two values.
    pub fn notices(&mut self) -> Vec<u32> {
        std::iter::from_fn(|| self.paper.take_notice()).flat_map(coded).collect()
    }
}

fn coded(notice: Notice) -> [u32; 3] {
    match notice {
        Notice::Lifted { from_right, leaves } => [0, leaves, u32::from(from_right)],
        Notice::Held { leaves } => [1, leaves, 0],
        Notice::Committed { page } => [2, page, 0],
        Notice::Cancelled => [3, 0, 0],
        Notice::Announce { page, pages } => [4, page, pages],
        Notice::Tick(Tick::Lift) => [5, 0, 0],
        Notice::Tick(Tick::Over) => [5, 1, 0],
        Notice::Tick(Tick::Land) => [5, 2, 0],
        Notice::Tick(Tick::Flip) => [5, 3, 0],
        Notice::Asleep => [6, 0, 0],
    }
}
