//! What JavaScript calls: numbers, words and bytes. `js/book.js` gives it names.

// wasm-bindgen exports functions by name, which the language calls unsafe. None of ours is.
#![allow(unsafe_code)]

use crate::desk::{Desk, FIGURES};
use crate::error::Refused;
use crate::options::{self, BookOptions, named, word};
use crate::replay::{Otherwise, Replay};
use crate::view::{Gaze, stage};
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::reading::{Motion, MotionPolicy};
use dogleaf_core::scene::{BookSpec, Fidelity};
use js_sys::{Error, Reflect};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

type Thrown<T> = Result<T, JsValue>;

/// A refusal as an `Error` of JavaScript: the line, and `kind`.
fn thrown(why: impl Into<Refused>) -> JsValue {
    let why = why.into();
    let error = Error::new(&why.text);
    error.set_name("DogleafError");
    let _ = Reflect::set(&error, &"kind".into(), &why.kind.into());
    error.into()
}

#[wasm_bindgen]
extern "C" {
    /// What `js/options.js` makes: every field is there.
    #[wasm_bindgen(typescript_type = "object")]
    #[derive(Debug)]
    pub type RawOptions;
    #[wasm_bindgen(method, getter)]
    fn pages(this: &RawOptions) -> f64;
    #[wasm_bindgen(method, getter, js_name = openAt)]
    fn open_at(this: &RawOptions) -> f64;
    #[wasm_bindgen(method, getter, js_name = widthM)]
    fn width_m(this: &RawOptions) -> f64;
    #[wasm_bindgen(method, getter, js_name = heightM)]
    fn height_m(this: &RawOptions) -> f64;
    #[wasm_bindgen(method, getter)]
    fn cover(this: &RawOptions) -> String;
    #[wasm_bindgen(method, getter)]
    fn direction(this: &RawOptions) -> String;
    #[wasm_bindgen(method, getter)]
    fn paper(this: &RawOptions) -> String;
    #[wasm_bindgen(method, getter, js_name = widthPx)]
    fn width_px(this: &RawOptions) -> f64;
    #[wasm_bindgen(method, getter, js_name = heightPx)]
    fn height_px(this: &RawOptions) -> f64;
    #[wasm_bindgen(method, getter)]
    fn layout(this: &RawOptions) -> String;
    #[wasm_bindgen(method, getter)]
    fn gaze(this: &RawOptions) -> String;
    #[wasm_bindgen(method, getter)]
    fn fidelity(this: &RawOptions) -> String;
    #[wasm_bindgen(method, getter)]
    fn grip(this: &RawOptions) -> f64;
    #[wasm_bindgen(method, getter, js_name = stepUs)]
    fn step_us(this: &RawOptions) -> f64;
}

fn options_of(o: &RawOptions) -> Result<BookOptions, Refused> {
    Ok(BookOptions {
        book: BookSpec {
            width_m: o.width_m(),
            height_m: o.height_m(),
            pages: o.pages() as u32,
            open_at: o.open_at() as u32,
            cover: named("cover", &o.cover(), options::COVERS)?,
            direction: named("direction", &o.direction(), options::DIRECTIONS)?,
        },
        paper: options::paper(&o.paper())?,
        size_px: [o.width_px() as u32, o.height_px() as u32],
        layout: named("layout", &o.layout(), options::LAYOUTS)?,
        gaze: named("gaze", &o.gaze(), options::GAZES)?,
        fidelity: named("fidelity", &o.fidelity(), &Fidelity::ALL)?,
        grip: o.grip(),
        step_us: o.step_us() as u32,
    })
}

/// Version of dogleaf.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// A book.
#[wasm_bindgen]
#[derive(Debug)]
pub struct RawBook {
    desk: Desk,
    figures: Box<[f64; FIGURES]>,
}

impl RawBook {
    fn of(desk: Desk) -> Self {
        let figures = Box::new(desk.figures());
        Self { desk, figures }
    }
    fn note(&mut self) {
        *self.figures = self.desk.figures();
    }
}

#[wasm_bindgen]
impl RawBook {
    /// Opens a book.
    ///
    /// # Errors
    ///
    /// The option at fault.
    pub fn open(options: &RawOptions) -> Thrown<RawBook> {
        options_of(options).and_then(|o| Desk::open(&o)).map(Self::of).map_err(thrown)
    }

    /// Opens the book of a snapshot.
    ///
    /// # Errors
    ///
    /// What is none.
    #[wasm_bindgen(js_name = fromSnapshot)]
    pub fn from_snapshot(bytes: &[u8]) -> Thrown<RawBook> {
        Desk::from_snapshot(bytes).map(Self::of).map_err(thrown)
    }

    /// Takes a pointer sample; `phase` 0 down, 1 move, 2 up, 3 cancel.
    ///
    /// # Errors
    ///
    /// One that is at no place, early, late or too much.
    pub fn pointer(
        &mut self,
        us: f64,
        id: u8,
        phase: u8,
        x: f64,
        y: f64,
        leaves: u16,
    ) -> Thrown<()> {
        let phases = [Phase::Down, Phase::Move, Phase::Up, Phase::Cancel];
        let phase = phases.get(usize::from(phase)).copied();
        let (true, Some(phase)) = (x.is_finite() && y.is_finite() && us.is_finite(), phase) else {
            return Err(thrown(Refused::new("pointer", "a pointer is at no finite place")));
        };
        let [x, y] = [x, y].map(|v| (v * 256.0).round() as i32);
        self.desk.pointer(Sample { t_us: us as u64, id, phase, x, y, leaves }).map_err(thrown)
    }

    /// Lets time pass. Bit 0: draw; bit 1: needs another frame.
    pub fn step(&mut self, now_us: f64) -> u32 {
        let frame = self.desk.step(now_us as u64);
        self.note();
        u32::from(frame.draw) | u32::from(self.desk.paper().needs_frame()) << 1
    }

    /// Where the twelve figures of the last step lie.
    #[wasm_bindgen(getter, js_name = figuresAt)]
    pub fn figures_at(&self) -> usize {
        self.figures.as_ptr() as usize
    }
    /// Where the vertices lie.
    #[wasm_bindgen(getter, js_name = verticesAt)]
    pub fn vertices_at(&self) -> usize {
        self.desk.mesh.vertices.as_ptr() as usize
    }
    /// How many there are.
    #[wasm_bindgen(getter)]
    pub fn vertices(&self) -> usize {
        self.desk.mesh.vertices.len()
    }
    /// Where the indices lie.
    #[wasm_bindgen(getter, js_name = indicesAt)]
    pub fn indices_at(&self) -> usize {
        self.desk.mesh.indices.as_ptr() as usize
    }
    /// How many there are.
    #[wasm_bindgen(getter)]
    pub fn indices(&self) -> usize {
        self.desk.mesh.indices.len()
    }
    /// Nine numbers a piece.
    pub fn pieces(&self) -> Vec<i32> {
        self.desk.mesh.pieces.clone()
    }
    /// Three numbers a notice.
    pub fn notices(&mut self) -> Vec<u32> {
        self.desk.notices()
    }
    /// Twenty numbers.
    pub fn stage(&self) -> Vec<f64> {
        stage(&self.desk.paper().setup()).to_vec()
    }
    /// Whether `step` has to be called.
    #[wasm_bindgen(js_name = needsFrame)]
    pub fn needs_frame(&self) -> bool {
        self.desk.paper().needs_frame()
    }

    /// Turns leaves.
    ///
    /// # Errors
    ///
    /// `busy`, `noSuchPage`, `paused`.
    pub fn turn(&mut self, forward: bool, leaves: u16) -> Thrown<()> {
        self.desk.paper_mut().turn(forward, leaves).map_err(thrown)
    }
    /// Lets the leaf nobody holds lie.
    pub fn skip(&mut self) {
        self.desk.skip();
    }

    /// What is shown of motion.
    #[wasm_bindgen(getter)]
    pub fn policy(&self) -> String {
        word(self.desk.paper().motion().policy, &MotionPolicy::ALL).to_owned()
    }
    /// Longest fall, microseconds.
    #[wasm_bindgen(getter, js_name = capUs)]
    pub fn cap_us(&self) -> Option<u32> {
        self.desk.paper().motion().cap_us
    }
    /// Changes both.
    ///
    /// # Errors
    ///
    /// A word that means nothing, a cap that no turn keeps.
    #[wasm_bindgen(js_name = setMotion)]
    pub fn set_motion(&mut self, policy: &str, cap_us: Option<u32>) -> Thrown<()> {
        let policy = options::policy(policy).map_err(thrown)?;
        self.desk.paper_mut().set_motion(Motion { policy, cap_us }).map_err(thrown)
    }

    /// From where one looks.
    #[wasm_bindgen(getter)]
    pub fn gaze(&self) -> String {
        word(Gaze::of(&self.desk.paper().setup().view), options::GAZES).to_owned()
    }
    /// Looks from elsewhere.
    ///
    /// # Errors
    ///
    /// A view without pixels, or above 16,384.
    pub fn look(&mut self, gaze: &str, width_px: f64, height_px: f64) -> Thrown<()> {
        let gaze = named("gaze", gaze, options::GAZES).map_err(thrown)?;
        self.desk.look(gaze, [width_px, height_px].map(|v| v as u32)).map_err(thrown)
    }
    /// The picture is lost.
    pub fn redraw(&mut self) {
        self.desk.paper_mut().redraw();
    }
    /// Into the background.
    pub fn pause(&mut self) {
        self.desk.pause();
    }
    /// And back.
    pub fn resume(&mut self) {
        self.desk.paper_mut().resume();
    }

    /// Page the book is open at.
    #[wasm_bindgen(getter)]
    pub fn page(&self) -> u32 {
        self.desk.paper().page()
    }
    /// Pages of the book.
    #[wasm_bindgen(getter)]
    pub fn pages(&self) -> u32 {
        self.desk.paper().pages()
    }
    /// Share that is read.
    #[wasm_bindgen(getter)]
    pub fn progress(&self) -> f64 {
        self.desk.paper().progress()
    }
    /// Leaves in hand; none without a leaf in the air.
    #[wasm_bindgen(getter)]
    pub fn held(&self) -> u32 {
        let book = self.desk.paper().book();
        book.leaf().map_or(0, |_| book.binding().held)
    }
    /// Hash of the state.
    #[wasm_bindgen(js_name = stateHash)]
    pub fn state_hash(&self) -> u64 {
        self.desk.paper().book().state_hash()
    }
    /// Whether all is at rest.
    #[wasm_bindgen(js_name = isSleeping)]
    pub fn is_sleeping(&self) -> bool {
        !self.desk.paper().book().needs_frame()
    }

    /// What `restore` needs.
    ///
    /// # Errors
    ///
    /// None.
    pub fn snapshot(&self) -> Thrown<Vec<u8>> {
        self.desk.snapshot().map_err(thrown)
    }
    /// Opens a snapshot in place.
    ///
    /// # Errors
    ///
    /// What is none; nothing was changed.
    pub fn restore(&mut self, bytes: &[u8]) -> Thrown<()> {
        self.desk.restore(bytes).map_err(thrown)?;
        self.note();
        Ok(())
    }
    /// Records from now on.
    ///
    /// # Errors
    ///
    /// `busy`, `paused`.
    #[wasm_bindgen(js_name = startRecording)]
    pub fn start_recording(&mut self) -> Thrown<()> {
        self.desk.start_recording().map_err(thrown)
    }
    /// Ends the recording.
    ///
    /// # Errors
    ///
    /// `recording`: there is none.
    #[wasm_bindgen(js_name = stopRecording)]
    pub fn stop_recording(&mut self) -> Thrown<Vec<u8>> {
        self.desk.stop_recording().map_err(thrown)
    }
}

/// A recording run again.
#[wasm_bindgen]
#[derive(Debug)]
pub struct RawReplay(Replay);

#[wasm_bindgen]
impl RawReplay {
    /// Opens it; what is `undefined` stays as recorded.
    ///
    /// # Errors
    ///
    /// Bytes that are no recording; words that mean nothing.
    #[wasm_bindgen(constructor)]
    #[expect(clippy::needless_pass_by_value, reason = "optional words cross as owned")]
    pub fn new(
        bytes: &[u8],
        grid: Option<String>,
        fidelity: Option<String>,
        step_us: Option<u32>,
    ) -> Thrown<RawReplay> {
        let (grid, fidelity) = (grid.as_deref(), fidelity.as_deref());
        Replay::open(bytes, Otherwise { grid, fidelity, step_us }).map(Self).map_err(thrown)
    }
    /// 0 at the end, 1 at rest, 2 with a leaf in the air.
    pub fn prepare(&mut self) -> u32 {
        self.0.prepare()
    }
    /// One recorded step.
    pub fn step(&mut self) {
        self.0.step();
    }
    /// Steps so far.
    #[wasm_bindgen(getter)]
    pub fn steps(&self) -> u32 {
        self.0.steps
    }
    /// Internal steps so far.
    #[wasm_bindgen(getter)]
    pub fn inner(&self) -> u32 {
        self.0.inner
    }
    /// First step with another hash.
    #[wasm_bindgen(getter)]
    pub fn diverged(&self) -> Option<u32> {
        self.0.diverged
    }
    /// Hash of the state.
    pub fn hash(&self) -> u64 {
        self.0.hash()
    }
    /// The led leaf, for comparing.
    pub fn shape(&self) -> Vec<f32> {
        self.0.shape()
    }
}
