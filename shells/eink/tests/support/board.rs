//! A book, a planner and a simulated panel, played as a device would.

use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Reading;
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{BookSpec, Direction};
use dogleaf_eink::plan::Aloft;
use dogleaf_eink::simulated::{Cell, Ghost};
use dogleaf_eink::{
    Band, Canvas, Depth, Faces, Layout, Panel, Picture, Planner, Policy, Pose, Print, Scene, Sheet,
    Simulated, Stage, Strip, Style, Update, draw,
};

/// Pages of print: lines of grey letters, another pattern on each.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lines;

impl Print for Lines {
    fn luma(&self, page: u32, x: u16, y: u16) -> u8 {
        let (x, y) = (u32::from(x), u32::from(y));
        let letter = ((x / 3 + 7 * (y / 14) + 5 * page).wrapping_mul(2_654_435_761) >> 13) & 3;
        let inked = y % 14 < 8 && x % 3 != 2 && letter != 0;
        if inked { 17 * (letter as u8 * 3) } else { 255 }
    }
}

/// A picture that was shown.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shot {
    pub(crate) update: Update,
    pub(crate) progress: Option<u16>,
    pub(crate) edge_x: u16,
    pub(crate) ghost: Ghost,
}

/// Everything a device has.
pub(crate) struct Board {
    pub(crate) panel: Panel,
    pub(crate) policy: Policy,
    pub(crate) stage: Stage,
    pub(crate) planner: Planner,
    pub(crate) reading: Box<Reading<f32, G11x8>>,
    pub(crate) cells: Vec<Cell>,
    pub(crate) shots: Vec<Shot>,
    /// What the panel is told instead of what the planner says: for controls.
    pub(crate) spoil: fn(Update, Option<&Sheet>) -> Update,
    /// The time, if it is not the panel's.
    pub(crate) now_us: Option<u64>,
    /// Pictures are only planned.
    pub(crate) blind: bool,
    sheet: Box<Sheet>,
    band: Box<Band<{ 800 * 17 }>>,
}

impl Board {
    pub(crate) fn new(panel: Panel, policy: Policy, layout: Layout, direction: Direction) -> Self {
        let book = BookSpec { pages: 120, open_at: 40, direction, ..BookSpec::default() };
        let stage = Stage::new(&book, &panel, layout).expect("a page fits");
        let setup = Setup { view: stage.view(0.003), ..Setup::fingers(book, 1, 1) };
        let mut reading = Box::new(Reading::EMPTY);
        reading.open(&setup).expect("it opens");
        let mut board = Self {
            panel,
            policy,
            stage,
            planner: Planner::new(panel, policy, stage.pages()),
            reading,
            cells: vec![Cell::NEW; usize::from(panel.width) * usize::from(panel.height)],
            shots: Vec::new(),
            spoil: |update, _| update,
            now_us: None,
            blind: false,
            sheet: Box::new(Sheet::EMPTY),
            band: Box::new(Band::EMPTY),
        };
        board.rest();
        board
    }

    /// A reader's panel, both pages.
    pub(crate) fn reader() -> Self {
        Self::new(Panel::SIX_INCH, Policy::READER, Layout::Spread, Direction::Ltr)
    }

    /// A key is pressed.
    pub(crate) fn turn(&mut self, forward: bool) {
        let mut strip = Box::new(Strip::EMPTY);
        let to = (&self.panel, &self.policy);
        strip.turn(&mut self.reading, forward, to, &mut ()).expect("there is a page");
        for pose in strip.poses() {
            self.key(pose, *strip.faces(), false);
        }
        self.rest();
    }

    /// The leaf as it is now, if the planner wants it.
    pub(crate) fn key(&mut self, pose: &Pose, faces: Faces, held: bool) {
        self.sheet.look(pose, &self.stage);
        let (progress, reach) = (pose.progress(), self.sheet.reach());
        let aloft = Aloft { progress, reach, edge_x: self.sheet.edge_x(), held };
        let now = self.now_us.unwrap_or(self.planner.busy_until_us());
        let Some(update) = self.planner.look(now, &faces, Some(&aloft)) else { return };
        let sheet = self.sheet.clone();
        let swept = Scene::Swept { edge: sheet.edge_x(), from_right: pose.from_right };
        let scene = if self.policy.style == Style::Leaf { Scene::Leaf(&sheet) } else { swept };
        let update = (self.spoil)(update, Some(&sheet));
        self.put(update, faces, scene, Some(progress));
    }

    /// The open pages, if the planner wants them.
    pub(crate) fn rest(&mut self) {
        let faces = Faces::of(self.reading.book());
        let now = self.now_us.unwrap_or(self.planner.busy_until_us());
        if let Some(update) = self.planner.look(now, &faces, None) {
            let update = (self.spoil)(update, None);
            self.put(update, faces, Scene::Rest, None);
        }
    }

    fn put(&mut self, update: Update, faces: Faces, scene: Scene<'_>, progress: Option<u16>) {
        let edge_x = self.sheet.edge_x();
        if self.blind {
            self.shots.push(Shot { update, progress, edge_x, ghost: Ghost::default() });
            return;
        }
        let hard = update.picture == Picture::Moving;
        let canvas = Canvas { stage: &self.stage, faces, scene, print: &Lines, hard };
        let depth = if hard || !self.panel.grey { Depth::TwoTone } else { Depth::Sixteen };
        let fresh = self.shots.is_empty();
        let mut glass = if fresh {
            Simulated::new(self.panel, &mut self.cells).expect("enough pixels")
        } else {
            Simulated::again(self.panel, &mut self.cells).expect("enough pixels")
        };
        let Ok(()) = draw(update.rect, &canvas, depth, &mut self.band, &mut glass);
        glass.refresh(update.rect, update.waveform);
        self.shots.push(Shot { update, progress, edge_x, ghost: glass.ghost() });
    }

    /// The panel, to look at.
    pub(crate) fn glass(&mut self) -> Simulated<'_> {
        Simulated::again(self.panel, &mut self.cells).expect("enough pixels")
    }

    /// What the open pages look like without any error.
    pub(crate) fn ideal(&mut self) -> Vec<u8> {
        let faces = Faces::of(self.reading.book());
        let pages = self.stage.pages();
        let (w, h) = (self.panel.width, self.panel.height);
        let cell = |x: u16, y: u16| {
            for (area, page) in pages.iter().zip([faces.left, faces.right]) {
                let inside = (area.x0..area.x1).contains(&x) && (area.y0..area.y1).contains(&y);
                if let Some(page) = page.filter(|_| inside) {
                    return Lines.luma(page, x - area.x0, y - area.y0) / 17;
                }
            }
            15
        };
        (0..h).flat_map(|y| (0..w).map(move |x| cell(x, y))).collect()
    }

    /// Key frames of the last turn.
    pub(crate) fn keys(&self) -> Vec<Shot> {
        let rest = |s: &Shot| s.update.picture == Picture::Settled;
        let end = self.shots.len().saturating_sub(1);
        let start = self.shots[..end].iter().rposition(rest).map_or(0, |n| n + 1);
        self.shots[start..end].to_vec()
    }
}
