//! An open book with all that lies beside it: its mesh, its journal, the notices nobody has read.

use crate::eink::{self, Eink, PanelOptions, PanelUpdate, panel_options};
use crate::error::DogleafError;
use crate::frame::FrameInfo;
use crate::journal::{self, Bytes, Journal};
use crate::mesh::Mesh;
use crate::notice::Notice;
use crate::options::Layout;
use crate::pointer::PointerSample;
use crate::stage::{Gaze, Stage, gaze, stage, view};
use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Reading;
use dogleaf_core::record::Setup;
use std::collections::VecDeque;

/// Notices kept until they are read; older ones are dropped.
const NOTICES: usize = 256;

/// An open book.
#[derive(Debug)]
pub(crate) struct Desk {
    pub(crate) reading: Box<Reading<f32, G11x8>>,
    pub(crate) journal: Journal,
    pub(crate) mesh: Mesh,
    notices: VecDeque<Notice>,
    eink: Eink,
    /// What the book is opened with again after a panic: as of the last call that went well.
    sound: Setup,
}

impl Desk {
    pub(crate) fn open(setup: &Setup) -> Result<Self, DogleafError> {
        let mut reading = Box::new(Reading::EMPTY);
        reading.open(setup)?;
        Ok(Self::of(reading))
    }

    pub(crate) fn restore(bytes: &[u8]) -> Result<Self, DogleafError> {
        let mut reading = Box::new(Reading::EMPTY);
        reading.restore(bytes)?;
        Ok(Self::of(reading))
    }

    fn of(reading: Box<Reading<f32, G11x8>>) -> Self {
        let sound = reading.setup();
        let mut mesh = Mesh::new();
        mesh.make(&reading);
        let eink = Eink::new(&reading, panel_options());
        Self { reading, journal: None, mesh, notices: VecDeque::new(), eink, sound }
    }

    /// The book at rest at the page it was last known at; the mesh keeps its address.
    pub(crate) fn recover(&mut self) -> Result<(), DogleafError> {
        self.journal = None;
        let motion = self.reading.motion();
        *self.reading = Reading::EMPTY;
        self.reading.open(&self.sound)?;
        self.reading.set_motion(motion)?;
        self.eink.again(&self.reading);
        self.mesh.make(&self.reading);
        Ok(())
    }

    /// Notes that a call went well.
    pub(crate) fn keep(&mut self) {
        while let Some(notice) = self.reading.take_notice() {
            if self.notices.len() == NOTICES {
                self.notices.pop_front();
            }
            self.notices.push_back(notice.into());
        }
        self.sound = self.reading.setup();
    }

    pub(crate) fn pointers(&mut self, samples: &[PointerSample]) -> Result<(), DogleafError> {
        for sample in samples {
            self.reading.pointer(sample.sample()?, &mut self.journal)?;
            self.eink.finger(sample);
        }
        Ok(())
    }

    pub(crate) fn step(&mut self, now_us: u64) -> FrameInfo {
        let frame = self.reading.step(now_us, &mut self.journal);
        let (draw, panel) = self.shows(frame.draw, now_us);
        if draw {
            self.mesh.make(&self.reading);
        }
        self.keep();
        FrameInfo {
            draw,
            needs_frame: self.needs_frame(),
            generation: self.mesh.generation,
            pieces_generation: self.mesh.pieces_generation,
            notices: self.notices.len() as u32,
            stretch: self.stretch(),
            through: self.mesh.through[0],
            flying_through: self.mesh.through[1],
            status: frame.report.status.into(),
            panel,
        }
    }

    /// Whether something is to be drawn: on electronic paper its planner says so, else the policy of motion.
    fn shows(&mut self, draw: bool, now_us: u64) -> (bool, Option<PanelUpdate>) {
        if !eink::asked(&self.reading) {
            return (draw, None);
        }
        let panel = self.eink.look(now_us, &self.reading);
        (panel.is_some(), panel)
    }

    /// Whether `step` has to be called again: something moves, or the panel owes a picture.
    pub(crate) fn needs_frame(&self) -> bool {
        let owes = eink::asked(&self.reading) && self.eink.owes(&self.reading);
        self.reading.needs_frame() || (owes && !self.reading.paused())
    }

    /// Another panel, or another wish.
    pub(crate) fn set_panel(&mut self, options: PanelOptions) {
        self.eink = Eink::new(&self.reading, options);
        self.reading.redraw();
    }

    /// What the app has of the picture is lost.
    pub(crate) fn redraw(&mut self) {
        self.eink.again(&self.reading);
        self.reading.redraw();
    }

    fn stretch(&self) -> f32 {
        self.reading.book().leaf().map_or(0.0, |_| self.reading.book().stretch().largest)
    }

    pub(crate) fn notices(&mut self) -> Vec<Notice> {
        self.notices.drain(..).collect()
    }

    /// At most so many of them.
    pub(crate) fn some_notices(&mut self, most: usize) -> Vec<Notice> {
        let count = self.notices.len().min(most);
        self.notices.drain(..count).collect()
    }

    pub(crate) fn look(&mut self, at: Gaze, width: u32, height: u32) -> Result<(), DogleafError> {
        let setup = self.reading.setup();
        let view = view(&setup.book, Layout::from(setup.handling.pages), at, width, height);
        self.reading.look(&view, &mut self.journal)?;
        self.eink.again(&self.reading);
        Ok(())
    }

    pub(crate) fn gaze(&self) -> Gaze {
        gaze(&self.reading.setup())
    }

    pub(crate) fn stage(&self) -> Stage {
        stage(&self.reading.setup())
    }

    pub(crate) fn snapshot(&self) -> Result<Vec<u8>, DogleafError> {
        Ok(self.reading.snapshot(Bytes::default())?.0)
    }

    /// Opens the book of a snapshot in place of this one; the mesh keeps its address.
    pub(crate) fn become_snapshot(&mut self, bytes: &[u8]) -> Result<(), DogleafError> {
        self.reading.restore(bytes)?;
        self.journal = None;
        self.notices.clear();
        self.eink.again(&self.reading);
        self.mesh.make(&self.reading);
        Ok(())
    }

    /// A recording begins with a book that was just opened: so it is opened anew at its page.
    pub(crate) fn start_recording(&mut self) -> Result<(), DogleafError> {
        if self.reading.book().leaf().is_some() || self.reading.book().needs_frame() {
            return Err(DogleafError::Busy);
        }
        if self.reading.paused() {
            return Err(DogleafError::Paused);
        }
        let setup = self.reading.setup();
        self.keep();
        self.reading.open(&setup)?;
        self.journal = journal::start::<f32, G11x8>(&setup)?;
        Ok(())
    }
}
