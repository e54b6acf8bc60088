//! A book being read, between input and pictures: it owns the book, its pages and its recording, and neither a window
//! nor a context. Whoever has those hands it samples, keys and time, and draws when it says so.

use crate::error::DesktopError;
use crate::pages::{AHEAD, Pages};
use crate::recorder::Recorder;
use crate::renderer::{self, BookRenderer, Leaves, Scene, Stage};
use crate::shape;
use dogleaf_content::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::mesh::Vertex;
use dogleaf_core::reading::{FACES, Motion, Notice, Piece, Reading, Shape};
use dogleaf_core::record::Setup;
use dogleaf_core::scene::{Direction, Fidelity, Handling};
use std::path::Path;
use std::sync::Arc;

/// The book that is read: what shells run.
pub type Paper = Reading<f32, G11x8>;

/// The finger of the mouse, and the one a modifier key adds.
const MOUSE: u8 = 0;
const SECOND: u8 = 60;
/// Where the second finger comes down and how far it swipes, as shares of the picture.
const BESIDE: (f64, f64) = (0.75, 0.08);

/// How a book is opened.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Which way one reads.
    pub direction: Direction,
    /// How exact the paper is.
    pub fidelity: Fidelity,
    /// How a finger and a page meet; says also whether one page or two are seen.
    pub handling: Handling,
    /// What is seen of a turn.
    pub motion: Motion,
    /// Page to open at, counted from 1.
    pub page: Option<u32>,
    /// Picture, pixels.
    pub size: [u32; 2],
}

impl Default for Options {
    fn default() -> Self {
        Self {
            direction: Direction::Ltr,
            fidelity: Fidelity::Fine,
            handling: Handling::FINGER,
            motion: Motion::FULL,
            page: None,
            size: [960, 720],
        }
    }
}

/// A book being read.
#[derive(Debug)]
pub struct BookView {
    reading: Box<Paper>,
    recorder: Recorder,
    content: Arc<Book>,
    pages: Pages,
    options: Options,
    stage: Stage,
    vertices: Vec<Vertex>,
    /// The mouse holds something down.
    pressed: bool,
}

impl BookView {
    /// Opens a book. `ready` is called from another thread when a page's picture was made.
    ///
    /// # Errors
    ///
    /// A page the book does not have; a size no book has.
    pub fn open(
        content: Book,
        options: &Options,
        ready: impl Fn() + Send + 'static,
    ) -> Result<Self, DesktopError> {
        let setup = shape::setup(&content, options)?;
        let mut reading = Box::new(Paper::EMPTY);
        reading.open(&setup)?;
        reading.set_motion(options.motion)?;
        let content = Arc::new(content);
        let size = shape::page_pixels(&setup.view, &setup.book);
        let pages = Pages::new(Arc::clone(&content), size, ready);
        Ok(Self {
            reading,
            recorder: Recorder::default(),
            content,
            pages,
            options: *options,
            stage: Stage::of(&setup),
            vertices: vec![Vertex::default(); Shape::<G11x8>::VERTICES],
            pressed: false,
        })
    }

    /// A renderer fit for this book's mesh.
    ///
    /// # Errors
    ///
    /// What the driver refuses.
    pub fn renderer(gl: crate::Gl) -> Result<BookRenderer, DesktopError> {
        let mut indices = vec![0; Shape::<G11x8>::INDICES];
        Paper::indices(&mut indices)?;
        Ok(BookRenderer::new(gl, Shape::<G11x8>::VERTICES, &indices)?)
    }

    /// Records everything from now on.
    ///
    /// # Errors
    ///
    /// A file nobody can write to.
    pub fn record(&mut self, path: &Path) -> Result<(), DesktopError> {
        self.recorder = Recorder::start::<f32, G11x8>(path, &self.reading.setup())?;
        Ok(())
    }

    /// Ends the recording, if there is one.
    ///
    /// # Errors
    ///
    /// The disc is full.
    pub fn close(&mut self) -> Result<(), DesktopError> {
        self.reading.pause(&mut self.recorder);
        self.recorder.finish()
    }

    /// The book, to look at.
    #[must_use]
    pub fn reading(&self) -> &Paper {
        &self.reading
    }

    /// What it was opened with.
    #[must_use]
    pub fn setup(&self) -> Setup {
        self.reading.setup()
    }

    /// What stands around it.
    pub fn stage_mut(&mut self) -> &mut Stage {
        &mut self.stage
    }

    /// Largest picture of a page that is made, pixels.
    #[must_use]
    pub fn page_size(&self) -> [u32; 2] {
        self.pages.size()
    }

    /// What the book calls itself.
    #[must_use]
    pub fn title(&self) -> &str {
        self.content.title()
    }

    /// Whether time has to pass and pictures have to be drawn.
    #[must_use]
    pub fn needs_frame(&self) -> bool {
        self.reading.needs_frame()
    }

    /// Hands over a sample. One the book refuses is lost; the next makes it good.
    pub fn pointer(&mut self, sample: Sample) {
        if sample.id == MOUSE {
            self.pressed = match sample.phase {
                Phase::Down => true,
                Phase::Move => self.pressed,
                Phase::Up | Phase::Cancel => false,
            };
        }
        let _ = self.reading.pointer(sample, &mut self.recorder);
    }

    /// Lets time pass. Answers whether there is something to be drawn.
    pub fn step(&mut self, now_us: u64) -> bool {
        self.reading.step(now_us, &mut self.recorder).draw
    }

    /// The next thing that happened.
    pub fn take_notice(&mut self) -> Option<Notice> {
        self.reading.take_notice()
    }

    /// Turns leaves on, or back. An impatient reader's last turn is done at once.
    pub fn turn(&mut self, forward: bool, leaves: u16) {
        if self.pressed {
            return;
        }
        if self.reading.turn(forward, leaves).is_err() {
            self.reading.skip(&mut self.recorder);
            let _ = self.reading.turn(forward, leaves);
        }
    }

    /// Turns to the first page, or to the last, with all leaves between in one hand.
    pub fn turn_all(&mut self, forward: bool) {
        let (read, all) = (self.reading.page() / 2, self.reading.pages().div_ceil(2));
        let leaves = if forward { all.saturating_sub(read) } else { read };
        if leaves > 0 {
            self.turn(forward, u16::try_from(leaves).unwrap_or(u16::MAX));
        }
    }

    /// While the mouse holds a leaf, a second finger adds one behind it or gives one back.
    pub fn bookmark(&mut self, more: bool, t_us: u64) {
        if !self.pressed {
            return;
        }
        let view = self.setup().view;
        let [width, height] = [f64::from(view.width_px), f64::from(view.height_px)];
        let way = if more { -BESIDE.1 } else { BESIDE.1 };
        let y = (0.5 * height * 256.0) as i32;
        for (phase, at) in [(Phase::Down, 0.0), (Phase::Move, way), (Phase::Up, way)] {
            let x = ((BESIDE.0 + at) * width * 256.0) as i32;
            self.pointer(Sample { t_us, id: SECOND, phase, x, y, leaves: 0 });
        }
    }

    /// Puts back the leaf the mouse holds. Answers whether there was one.
    pub fn put_back(&mut self, t_us: u64) -> bool {
        let held = self.pressed;
        if held {
            let cancel = Sample { t_us, id: MOUSE, phase: Phase::Cancel, x: 0, y: 0, leaves: 0 };
            self.pointer(cancel);
        }
        held
    }

    /// The window has another size.
    ///
    /// # Errors
    ///
    /// A size nobody can see.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<(), DesktopError> {
        let view = shape::view(&self.reading.setup().book, self.options.handling.pages, size);
        self.reading.look(&view, &mut self.recorder)?;
        self.stage.view = view;
        Ok(())
    }

    /// Draws the picture in another size than the hand's.
    pub fn picture_size(&mut self, size: [u32; 2]) {
        let book = self.reading.setup().book;
        self.stage.view = shape::view(&book, self.options.handling.pages, size);
    }

    /// The context was lost, or something else covered the window.
    pub fn redraw(&mut self) {
        self.reading.redraw();
    }

    /// The app goes into the background, or comes back.
    pub fn pause(&mut self, away: bool) {
        if away {
            self.reading.pause(&mut self.recorder);
            self.pressed = false;
        } else {
            self.reading.resume();
        }
    }

    /// Makes the mesh, hands it over with the pages it shows, and has it drawn by `draw`.
    ///
    /// # Errors
    ///
    /// The card is full.
    pub fn frame<T>(
        &mut self,
        renderer: &mut BookRenderer,
        draw: impl FnOnce(&mut BookRenderer, &Scene<'_>) -> T,
    ) -> Result<T, DesktopError> {
        let pieces = self.mesh()?;
        self.show(renderer, &pieces)?;
        renderer.upload(&self.vertices);
        let leaves = Leaves::of(self.reading.book(), &pieces, &self.vertices);
        Ok(draw(renderer, &Scene { stage: &self.stage, pieces: &pieces, leaves }))
    }

    /// The vertices and pieces of the present frame.
    ///
    /// # Errors
    ///
    /// None but in a build whose grid and buffer differ.
    pub fn mesh(&mut self) -> Result<[Piece; FACES], DesktopError> {
        Ok(self.reading.vertices(&mut self.vertices)?)
    }

    /// The vertices of the last [`BookView::mesh`].
    #[must_use]
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Hands over the pictures of pages that were made meanwhile; best while nothing moves.
    ///
    /// # Errors
    ///
    /// The card is full.
    pub fn receive(&mut self, renderer: &mut BookRenderer) -> Result<(), DesktopError> {
        while let Some((page, made)) = self.pages.take() {
            renderer.set_page(page, [made.width, made.height], &made.rgba)?;
        }
        Ok(())
    }

    /// Makes sure that the renderer has what is seen, orders what may be seen next, gives back the rest.
    fn show(&mut self, renderer: &mut BookRenderer, pieces: &[Piece]) -> Result<(), DesktopError> {
        self.receive(renderer)?;
        let (page, pages) = (self.reading.page(), &mut self.pages);
        let seen: Vec<u32> = renderer::pages(pieces).filter(|page| pages.has(*page)).collect();
        for page in seen.iter().copied() {
            if !renderer.has_page(page) {
                let made = pages.now(page);
                renderer.set_page(page, [made.width, made.height], &made.rgba)?;
            }
        }
        let near = |other: u32| other.abs_diff(page) <= AHEAD;
        renderer.keep_pages(|page| near(page) || seen.contains(&page));
        for page in page.saturating_sub(AHEAD)..=page.saturating_add(AHEAD) {
            if !renderer.has_page(page) {
                pages.soon(page);
            }
        }
        Ok(())
    }
}
