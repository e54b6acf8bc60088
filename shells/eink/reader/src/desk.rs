//! The reader's loop: touch in, pictures out, and sleep.

use crate::scene::{PANEL, POLICY};
use crate::{Built, Room, Touches};
use dogleaf_core::reading::{Motion, MotionPolicy};
use dogleaf_core::record::{RecordError, Setup};
use dogleaf_eink::plan::Aloft;
use dogleaf_eink::{
    Canvas, Depth, Faces, Picture, Planner, Pose, Scene, Simulated, Stage, Update, draw,
};

/// Time between two world steps while something moves, microseconds.
const FRAME_US: u64 = 16_667;
/// How often a reader at rest looks whether it is wanted, microseconds. A finger wakes it at once.
const DOZE_US: u64 = 100_000;

/// What the processor is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// World steps, and the pose.
    Physics,
    /// Pixels.
    Raster,
    /// All else.
    Other,
}

/// A picture that was shown.
#[derive(Debug, Clone, Copy)]
pub struct Shot {
    /// When, microseconds.
    pub at_us: u64,
    /// Where and how.
    pub update: Update,
    /// How far over the leaf is, 0 to 1024; none at rest.
    pub progress: Option<u16>,
}

/// Who looks on: counts, prints, sleeps.
pub trait Watch {
    /// The processor turns to something else.
    fn part(&mut self, part: Part);
    /// The panel shows a picture.
    fn shot(&mut self, shot: &Shot, glass: &Simulated<'_>);
    /// Nothing is to be done for so long.
    fn sleep(&mut self, us: u64);
}

/// A reader at its panel. Small: what is large is in the [`Room`].
#[derive(Debug)]
pub struct Desk<'a> {
    room: &'a mut Room,
    glass: Simulated<'a>,
    print: Built<'a>,
    stage: Stage,
    planner: Planner,
    now_us: u64,
    /// Progress of the key frame that is on the panel.
    seen: u16,
    /// A finger holds a leaf.
    held: bool,
}

impl<'a> Desk<'a> {
    /// Opens the book.
    ///
    /// # Errors
    ///
    /// As [`Setup::open`].
    pub fn open(
        room: &'a mut Room,
        glass: Simulated<'a>,
        print: Built<'a>,
        stage: Stage,
        setup: &Setup,
    ) -> Result<Self, RecordError> {
        room.reading.open(setup)?;
        let motion = Motion { policy: MotionPolicy::EInk, ..Motion::FULL };
        room.reading.set_motion(motion)?;
        let planner = Planner::new(PANEL, POLICY, stage.pages());
        Ok(Self { room, glass, print, stage, planner, now_us: 0, seen: 0, held: false })
    }

    /// The book, to look at.
    #[must_use]
    pub fn room(&self) -> &Room {
        self.room
    }

    /// The panel, to look at.
    #[must_use]
    pub fn glass(&self) -> &Simulated<'a> {
        &self.glass
    }

    /// Plays until `end_us`.
    pub fn run(&mut self, touches: &mut Touches<'_>, end_us: u64, watch: &mut impl Watch) {
        while self.now_us < end_us {
            self.touch(touches);
            watch.part(Part::Physics);
            self.physics();
            watch.part(Part::Other);
            self.show(watch);
            let next = if self.moves() { FRAME_US } else { DOZE_US };
            let due = touches.due_us().map_or(next, |t| t.saturating_sub(self.now_us).min(next));
            watch.sleep(due.max(1));
            self.now_us += due.max(1);
        }
    }

    /// Something happens by itself, or waits for the panel.
    fn moves(&self) -> bool {
        let reading = &self.room.reading;
        reading.needs_frame()
            || self.room.fall.waits()
            || self.planner.owes(&Faces::of(reading.book()))
    }

    fn touch(&mut self, touches: &mut Touches<'_>) {
        while let Some(sample) = touches.take(self.now_us) {
            // A bad sample changes nothing.
            let _ = self.room.reading.pointer(sample, &mut ());
            self.held = !matches!(
                sample.phase,
                dogleaf_core::hand::Phase::Up | dogleaf_core::hand::Phase::Cancel
            );
            self.room.fall.forget();
        }
    }

    fn physics(&mut self) {
        let Room { reading, fall, .. } = &mut *self.room;
        if reading.needs_frame() {
            let _ = reading.step(self.now_us, &mut ());
        }
        if !self.held && reading.book().leaf().is_some() {
            fall.compute(reading, self.seen, &PANEL, &POLICY);
        }
        while reading.take_notice().is_some() {}
    }

    /// What the panel is to show now, if anything.
    fn show(&mut self, watch: &mut impl Watch) {
        if self.now_us < self.planner.busy_until_us() {
            return;
        }
        if let Some((pose, faces)) = self.room.fall.take() {
            self.key(&pose, faces, watch);
        } else if let Some(pose) = Pose::of(self.room.reading.book()) {
            self.key(&pose, Faces::of(self.room.reading.book()), watch);
        } else {
            let faces = Faces::of(self.room.reading.book());
            if let Some(update) = self.planner.look(self.now_us, &faces, None) {
                self.seen = 0;
                self.put(update, faces, None, watch);
            }
        }
    }

    fn key(&mut self, pose: &Pose, faces: Faces, watch: &mut impl Watch) {
        let progress = pose.progress();
        if !self.planner.is_due(self.now_us, progress, self.held) {
            return;
        }
        watch.part(Part::Raster);
        self.room.sheet.look(pose, &self.stage);
        watch.part(Part::Other);
        let aloft = Aloft {
            progress,
            reach: self.room.sheet.reach(),
            edge_x: self.room.sheet.edge_x(),
            held: self.held,
        };
        if let Some(update) = self.planner.look(self.now_us, &faces, Some(&aloft)) {
            self.seen = progress;
            self.put(update, faces, Some(progress), watch);
        }
    }

    fn put(&mut self, update: Update, faces: Faces, progress: Option<u16>, watch: &mut impl Watch) {
        watch.part(Part::Raster);
        let Room { sheet, band, .. } = &mut *self.room;
        let hard = update.picture == Picture::Moving;
        let scene = if hard { Scene::Leaf(sheet) } else { Scene::Rest };
        let depth = if hard { Depth::TwoTone } else { Depth::Sixteen };
        let canvas = Canvas { stage: &self.stage, faces, scene, print: &self.print, hard };
        // A simulated panel takes everything.
        let Ok(()) = draw(update.rect, &canvas, depth, band, &mut self.glass);
        watch.part(Part::Other);
        self.glass.refresh(update.rect, update.waveform);
        watch.shot(&Shot { at_us: self.now_us, update, progress }, &self.glass);
    }
}
