//! Electronic paper: which pictures of a turn are worth a refresh of the panel, where and how. What the planner of
//! `dogleaf-eink` says, in the pixels of the app's view.

use crate::error::DogleafError;
use crate::options::mirrored;
use crate::pointer::{Phase, PointerSample};
use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::{MotionPolicy, Reading};
use dogleaf_core::real::V3;
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::state::Field;
use dogleaf_eink::panel;
use dogleaf_eink::plan::Aloft;
use dogleaf_eink::{Faces, Picture, Planner, Policy, Pose, Rect, Update};

mirrored! {
    /// How a panel brings a picture about.
    Waveform = panel::Waveform {
        /// Fast, black and white, from black and white.
        A2,
        /// To black and white, from any grey.
        Du,
        /// Greys on white.
        Gl16,
        /// The same, and white is cleaned about what was black.
        Glr16,
        /// Greys, cleaned: every pixel, with a flash.
        Gc16,
    }
}

/// How long a panel takes, and how much of a turn one wants to see on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Record)]
pub struct PanelOptions {
    /// Shows greys, not only black and white.
    pub grey: bool,
    /// Microseconds of its fastest update; none if it has none faster than `du_us`.
    pub a2_us: Option<u32>,
    /// Microseconds of an update to black and white.
    pub du_us: u32,
    /// Microseconds of an update in greys.
    pub gl16_us: u32,
    /// The same where white is driven anew; none if the panel cannot.
    pub glr16_us: Option<u32>,
    /// Microseconds of a full refresh.
    pub gc16_us: u32,
    /// Pictures of a turn at most, before the page after; 1 to 12.
    pub key_frames: u8,
    /// Updates after which the next page at rest is a full refresh.
    pub full_after: u16,
}

/// One picture for the panel: draw the mesh as it is, hand the rectangle to the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, uniffi::Record)]
pub struct PanelUpdate {
    /// Left edge, pixels of the view; like the right one a multiple of eight, or the view's own.
    pub x: u32,
    /// Top edge.
    pub y: u32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// How.
    pub waveform: Waveform,
    /// The whole view, with a flash, to clean what is left of earlier pictures.
    pub full: bool,
    /// The page at rest; else a picture of the turn.
    pub settled: bool,
    /// How long the panel is busy with it, microseconds. No other picture comes before.
    pub busy_us: u32,
}

/// A panel of six inches in sixteen greys: four pictures a turn, a full refresh after twenty-four.
#[uniffi::export]
#[must_use]
pub fn panel_options() -> PanelOptions {
    let (panel, policy) = (dogleaf_eink::Panel::SIX_INCH, Policy::READER);
    PanelOptions {
        grey: panel.grey,
        a2_us: panel.a2_us,
        du_us: panel.du_us,
        gl16_us: panel.gl16_us,
        glr16_us: panel.glr16_us,
        gc16_us: panel.gc16_us,
        key_frames: policy.key_frames,
        full_after: policy.full_after,
    }
}

/// The planner of a book's panel.
#[derive(Debug)]
pub(crate) struct Eink {
    planner: Planner,
    options: PanelOptions,
    /// Size of the view.
    size: [u16; 2],
    /// Fingers that are down, by the bits of their numbers modulo 64.
    down: u64,
}

/// What a leaf's shadow may reach beyond it, as a share of a page's width.
const SHADE: f64 = 1.0 / 16.0;

impl Eink {
    pub(crate) fn new(reading: &Reading<f32, G11x8>, options: PanelOptions) -> Self {
        let view = reading.setup().view;
        let size = [view.width_px, view.height_px].map(|n| n.min(u32::from(u16::MAX)) as u16);
        let policy = Policy {
            key_frames: options.key_frames,
            full_after: options.full_after,
            ..Policy::READER
        };
        let pages = pages(reading, size);
        Self { planner: Planner::new(panel(&options, size), policy, pages), options, size, down: 0 }
    }

    /// The view, or the book in it, is another: the panel begins anew.
    pub(crate) fn again(&mut self, reading: &Reading<f32, G11x8>) {
        *self = Self { down: self.down, ..Self::new(reading, self.options) };
    }

    /// Takes note of fingers: a leaf that is held is followed.
    pub(crate) fn finger(&mut self, sample: &PointerSample) {
        let bit = 1_u64 << (sample.id & 63);
        match sample.phase {
            Phase::Down => self.down |= bit,
            Phase::Up | Phase::Cancel => self.down &= !bit,
            Phase::Move => {}
        }
    }

    /// What the panel is to show now.
    pub(crate) fn look(
        &mut self,
        now_us: u64,
        reading: &Reading<f32, G11x8>,
    ) -> Option<PanelUpdate> {
        let faces = Faces::of(reading.book());
        let leaf = self.aloft(reading);
        self.planner.look(now_us, &faces, leaf.as_ref()).map(Into::into)
    }

    /// Whether the panel shows something else than the pages at rest.
    pub(crate) fn owes(&self, reading: &Reading<f32, G11x8>) -> bool {
        self.planner.owes(&Faces::of(reading.book()))
    }

    /// The leaf in the air, as the view shows it.
    fn aloft(&self, reading: &Reading<f32, G11x8>) -> Option<Aloft> {
        let (book, leaf) = (reading.book(), reading.book().leaf()?);
        let pose = Pose::of(book)?;
        let mut bounds = Bounds::default();
        let [left, right] = book.binding().thickness();
        for (i, k) in Field::<f32, G11x8>::nodes() {
            let node = leaf.x.at(i, k);
            let V3([x, _, z]) = node;
            let page = if x < 0.0 { left } else { right };
            for place in [node, V3([x, page, z])] {
                bounds.hold(book.camera().project(place));
            }
        }
        let edge =
            (0..dogleaf_eink::pose::ALONG).map(|k| leaf.x.at(dogleaf_eink::pose::ACROSS - 1, k));
        let mut outer = Bounds::default();
        edge.for_each(|node| outer.hold(book.camera().project(node)));
        let middle = 0.5 * (outer.low[0] + outer.high[0]);
        let page_px = self.page_px(reading);
        Some(Aloft {
            progress: pose.progress(),
            reach: bounds.rect((SHADE * page_px) as f32, self.size),
            edge_x: middle.clamp(0.0, f32::from(self.size[0])) as u16,
            held: self.down != 0,
        })
    }

    /// About how many pixels a page is wide.
    fn page_px(&self, reading: &Reading<f32, G11x8>) -> f64 {
        let [left, right] = pages(reading, self.size);
        f64::from(left.width().max(right.width()))
    }
}

/// Whether the policy of a book asks for a planner.
pub(crate) fn asked(reading: &Reading<f32, G11x8>) -> bool {
    reading.motion().policy == MotionPolicy::EInk
}

fn panel(options: &PanelOptions, [width, height]: [u16; 2]) -> dogleaf_eink::Panel {
    let &PanelOptions { grey, a2_us, du_us, gl16_us, glr16_us, gc16_us, .. } = options;
    dogleaf_eink::Panel { width, height, grey, a2_us, du_us, gl16_us, glr16_us, gc16_us }
}

/// Refuses what no panel takes, whatever the size of the view.
pub(crate) fn check(options: &PanelOptions) -> Result<(), DogleafError> {
    let refused = |text: &str| Err(DogleafError::Refused(text.to_owned()));
    if let Err(why) = panel(options, [800, 600]).check() {
        return refused(&why.to_string());
    }
    if !(1..=12).contains(&options.key_frames) {
        return refused("a turn has 1 to 12 key frames");
    }
    if options.full_after == 0 {
        refused("a full refresh comes after 1 picture or more")
    } else {
        Ok(())
    }
}

/// Where the two open pages are seen.
fn pages(reading: &Reading<f32, G11x8>, size: [u16; 2]) -> [Rect; 2] {
    let book = reading.book();
    let half = book.units().length(book.spec().height_m) as f32 * 0.5;
    let [left, right] = book.binding().thickness();
    [(-WIDTH as f32, left), (WIDTH as f32, right)].map(|(outer, y)| {
        let mut bounds = Bounds::default();
        for x in [0.0, outer] {
            for z in [-half, half] {
                bounds.hold(book.camera().project(V3([x, y, z])));
            }
        }
        bounds.rect(1.0, size)
    })
}

/// The smallest box about places in the view.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: [f32; 2],
    high: [f32; 2],
}

impl Default for Bounds {
    fn default() -> Self {
        Self { low: [f32::INFINITY; 2], high: [f32::NEG_INFINITY; 2] }
    }
}

impl Bounds {
    /// What is behind the eye is not seen.
    fn hold(&mut self, place: Option<[f32; 2]>) {
        for ((low, high), c) in self.low.iter_mut().zip(&mut self.high).zip(place.iter().flatten())
        {
            (*low, *high) = (low.min(*c), high.max(*c));
        }
    }

    fn rect(&self, margin: f32, size: [u16; 2]) -> Rect {
        let [[x0, y0], [x1, y1]] = [self.low.map(|c| c - margin), self.high.map(|c| c + margin)];
        let pixel = |c: f32, most: u16| c.clamp(0.0, f32::from(most)) as u16;
        let [w, h] = size;
        let [x1, y1] = [pixel(x1.ceil(), w), pixel(y1.ceil(), h)];
        Rect::new(pixel(x0.floor(), w), pixel(y0.floor(), h), x1, y1)
    }
}

impl From<Update> for PanelUpdate {
    fn from(update: Update) -> Self {
        let Update { rect, waveform, picture, busy_us } = update;
        Self {
            x: rect.x0.into(),
            y: rect.y0.into(),
            width: rect.width().into(),
            height: rect.height().into(),
            waveform: waveform.into(),
            full: waveform == panel::Waveform::Gc16,
            settled: picture == Picture::Settled,
            busy_us,
        }
    }
}
