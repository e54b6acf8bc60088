//! A key is pressed, the turn is computed, its key frames are shown as fast as the panel takes them.

use super::prints::Prints;
use super::show::Show;
use crate::error::CliError;
use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Reading;
use dogleaf_core::record::Setup;
use dogleaf_eink::plan::Aloft;
use dogleaf_eink::simulated::{Cell, Counts, Ghost};
use dogleaf_eink::{
    Band, Canvas, Depth, Faces, Panel, Picture, Planner, Policy, Pose, Scene, Sheet, Simulated,
    Stage, Strip, Style, Update, draw,
};

/// Pixels of a band: sixteen rows of the widest panel one asks for.
const CELLS: usize = 2_048 * 17;

/// What is played.
#[derive(Debug)]
pub(super) struct Play {
    pub(super) setup: Setup,
    pub(super) panel: Panel,
    pub(super) policy: Policy,
    pub(super) stage: Stage,
    pub(super) forward: bool,
}

/// A picture that was shown.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shot {
    pub(super) at_us: u64,
    pub(super) update: Update,
    pub(super) progress: Option<u16>,
    pub(super) ghost: Ghost,
}

/// Everything that was shown.
#[derive(Debug)]
pub(super) struct Told {
    pub(super) shots: Vec<Shot>,
    pub(super) counts: Counts,
    pub(super) page: u32,
}

/// Everything that draws.
struct Desk<'a> {
    play: &'a Play,
    prints: &'a Prints,
    planner: Planner,
    sheet: Box<Sheet>,
    band: Box<Band<CELLS>>,
    glass: Simulated<'a>,
    show: Option<Show>,
    shots: Vec<Shot>,
    now_us: u64,
}

impl Play {
    /// Plays one turn from a panel that already shows the open pages.
    pub(super) fn run(&self, prints: &Prints, show: Option<Show>) -> Result<Told, CliError> {
        let mut reading = Box::new(Reading::<f32, G11x8>::EMPTY);
        reading.open(&self.setup)?;
        let mut cells =
            vec![Cell::NEW; usize::from(self.panel.width) * usize::from(self.panel.height)];
        let glass = Simulated::new(self.panel, &mut cells)
            .ok_or_else(|| CliError::Call("the panel has no pixels".into()))?;
        let mut desk = Desk {
            play: self,
            prints,
            planner: Planner::new(self.panel, self.policy, self.stage.pages()),
            sheet: Box::new(Sheet::EMPTY),
            band: Box::new(Band::EMPTY),
            glass,
            show,
            shots: Vec::new(),
            now_us: 0,
        };
        desk.rest(Faces::of(reading.book()))?;
        let mut strip = Box::new(Strip::EMPTY);
        let (panel, policy) = (&self.panel, &self.policy);
        strip
            .turn(&mut reading, self.forward, (panel, policy), &mut ())
            .map_err(|why| CliError::Call(why.to_string()))?;
        for pose in strip.poses() {
            desk.key(pose, *strip.faces())?;
        }
        desk.rest(Faces::of(reading.book()))?;
        desk.end(reading.page())
    }
}

impl Desk<'_> {
    fn key(&mut self, pose: &Pose, faces: Faces) -> Result<(), CliError> {
        self.sheet.look(pose, &self.play.stage);
        let aloft = Aloft {
            progress: pose.progress(),
            reach: self.sheet.reach(),
            edge_x: self.sheet.edge_x(),
            held: false,
        };
        self.now_us = self.planner.busy_until_us();
        let Some(update) = self.planner.look(self.now_us, &faces, Some(&aloft)) else {
            return Ok(());
        };
        let swept = Scene::Swept { edge: self.sheet.edge_x(), from_right: pose.from_right };
        let sheet = self.sheet.clone();
        let scene = match self.play.policy.style {
            Style::Leaf => Scene::Leaf(&sheet),
            Style::Stripe => swept,
        };
        self.put(update, faces, scene, Some(aloft.progress))
    }

    fn rest(&mut self, faces: Faces) -> Result<(), CliError> {
        self.now_us = self.planner.busy_until_us();
        match self.planner.look(self.now_us, &faces, None) {
            Some(update) => self.put(update, faces, Scene::Rest, None),
            None => Ok(()),
        }
    }

    fn put(
        &mut self,
        update: Update,
        faces: Faces,
        scene: Scene<'_>,
        progress: Option<u16>,
    ) -> Result<(), CliError> {
        let hard = update.picture == Picture::Moving;
        let depth = if hard || !self.play.panel.grey { Depth::TwoTone } else { Depth::Sixteen };
        let (stage, print) = (&self.play.stage, self.prints);
        let canvas = Canvas { stage, faces, scene, print, hard };
        // A simulated panel takes everything.
        let Ok(()) = draw(update.rect, &canvas, depth, &mut self.band, &mut self.glass);
        self.glass.refresh(update.rect, update.waveform);
        let ghost = self.glass.ghost();
        self.shots.push(Shot { at_us: self.now_us, update, progress, ghost });
        match &mut self.show {
            Some(show) => show.add(&self.glass, update.busy_us),
            None => Ok(()),
        }
    }

    fn end(self, page: u32) -> Result<Told, CliError> {
        if let Some(show) = self.show {
            show.finish()?;
        }
        Ok(Told { shots: self.shots, counts: self.glass.counts(), page })
    }
}
