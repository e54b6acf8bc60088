//! The book in a window: events in, pictures out, and nothing while it lies still.

use crate::error::{DesktopError, one_line};
use crate::keys::{self, Wish};
use crate::renderer::{BookRenderer, Scene};
use crate::script::Script;
use crate::surface::Canvas;
use crate::view::BookView;
use dogleaf_core::hand::{Phase, Sample};
use dogleaf_core::reading::Notice;
use std::time::{Duration, Instant};
use winit::application::ApplicationHandler;
use winit::dpi::{PhysicalPosition, PhysicalSize};
use winit::event::{ElementState, MouseButton, StartCause, Touch, TouchPhase, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::keyboard::ModifiersState;
use winit::window::{Fullscreen, Window, WindowId};

/// Pause before time is looked at again where a step drew nothing: electronic paper, a turn that is not shown.
const UNSEEN: Duration = Duration::from_millis(8);
/// Fingers of a screen are numbered from here; the mouse is 0.
const FINGERS: u64 = 1;
/// So many are told apart.
const HANDS: u64 = 59;

/// A page's picture was made.
#[derive(Debug, Clone, Copy)]
pub struct Ready;

/// What a window is opened for.
#[derive(Debug, Default)]
pub struct Show {
    /// A gesture to play; the window closes when the book lies still after it.
    pub script: Option<Script>,
    /// Size of the window, pixels.
    pub size: [u32; 2],
}

/// Reads a book in a window until it is closed.
///
/// # Errors
///
/// There is no display; the driver has no OpenGL ES 3.0; the recording cannot be written.
pub fn run(events: EventLoop<Ready>, view: BookView, show: Show) -> Result<Seen, DesktopError> {
    let mut app = App {
        view,
        show,
        drawing: None,
        start: Instant::now(),
        cursor: PhysicalPosition::new(0.0, 0.0),
        held: ModifiersState::empty(),
        fault: None,
        seen: Seen::default(),
    };
    let ended = events.run_app(&mut app);
    app.drawing = None;
    app.view.close()?;
    match app.fault {
        Some(fault) => Err(fault),
        None => {
            ended.map_err(|e| DesktopError::Window(one_line(&e.to_string()))).map(|()| app.seen)
        }
    }
}

/// What was shown.
#[derive(Debug, Clone, Default)]
pub struct Seen {
    /// Milliseconds each picture took, from the step to the swap.
    pub frames_ms: Vec<f64>,
}

struct Drawing {
    // The renderer first: it needs the canvas's context.
    renderer: BookRenderer,
    canvas: Canvas,
}

struct App {
    view: BookView,
    show: Show,
    drawing: Option<Drawing>,
    start: Instant,
    cursor: PhysicalPosition<f64>,
    held: ModifiersState,
    fault: Option<DesktopError>,
    seen: Seen,
}

impl ApplicationHandler<Ready> for App {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.drawing.is_none() {
            let opened = self.open(events);
            self.check(events, opened);
        }
        self.view.pause(false);
        self.ask();
    }

    fn suspended(&mut self, _: &ActiveEventLoop) {
        self.view.pause(true);
        self.drawing = None;
    }

    fn new_events(&mut self, _: &ActiveEventLoop, cause: StartCause) {
        if matches!(cause, StartCause::ResumeTimeReached { .. }) {
            self.ask();
        }
    }

    fn user_event(&mut self, events: &ActiveEventLoop, _: Ready) {
        // Before a turn needs them: a frame has no time for it.
        if let Some(Drawing { renderer, .. }) = &mut self.drawing {
            let received = self.view.receive(renderer);
            self.check(events, received);
        }
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => events.exit(),
            WindowEvent::Resized(size) => {
                let resized = self.resized(size);
                self.check(events, resized);
            }
            WindowEvent::RedrawRequested => {
                let drawn = self.frame(events);
                self.check(events, drawn);
            }
            WindowEvent::ModifiersChanged(held) => self.held = held.state(),
            WindowEvent::CursorMoved { position, .. } => {
                self.cursor = position;
                self.pointer(0, Phase::Move, position);
            }
            WindowEvent::MouseInput { state, button: MouseButton::Left, .. } => {
                let down = state == ElementState::Pressed;
                self.pointer(0, if down { Phase::Down } else { Phase::Up }, self.cursor);
            }
            WindowEvent::MouseWheel { delta, .. } if self.held.shift_key() => {
                self.view.bookmark(keys::rolls_on(delta), self.now_us());
            }
            // Whoever looks elsewhere has let go.
            WindowEvent::Focused(false) => _ = self.view.put_back(self.now_us()),
            WindowEvent::Touch(touch) => self.touch(touch),
            WindowEvent::KeyboardInput { event, .. } if event.state == ElementState::Pressed => {
                let wish =
                    keys::wish(&event.logical_key, self.held, self.view.setup().book.direction);
                self.grant(events, wish);
            }
            _ => {}
        }
        self.ask();
    }

    fn about_to_wait(&mut self, _: &ActiveEventLoop) {
        if self.show.script.is_some() {
            self.ask();
        }
    }
}

impl App {
    fn now_us(&self) -> u64 {
        self.start.elapsed().as_micros() as u64
    }

    fn open(&mut self, events: &ActiveEventLoop) -> Result<(), DesktopError> {
        let [width, height] = self.show.size;
        let attributes = Window::default_attributes()
            .with_title(self.view.title())
            .with_inner_size(PhysicalSize::new(width, height));
        let (canvas, gl) = Canvas::open(events, attributes)?;
        let renderer = BookView::renderer(gl)?;
        let size = canvas.window.inner_size();
        self.drawing = Some(Drawing { renderer, canvas });
        self.view.redraw();
        self.resized(size)
    }

    /// Asks for a picture, if there is anything new to see.
    fn ask(&self) {
        let playing = self.show.script.is_some();
        if let Some(drawing) = self.drawing.as_ref().filter(|_| self.view.needs_frame() || playing)
        {
            drawing.canvas.window.request_redraw();
        }
    }

    fn resized(&mut self, size: PhysicalSize<u32>) -> Result<(), DesktopError> {
        let Some(drawing) = &self.drawing else { return Ok(()) };
        // A window that was made small to nothing has no view; it gets one when it comes back.
        if size.width > 0 && size.height > 0 {
            drawing.canvas.resize(size.width, size.height);
            self.view.resize([size.width, size.height])?;
        }
        Ok(())
    }

    /// Lets time pass, and draws what it changed.
    fn frame(&mut self, events: &ActiveEventLoop) -> Result<(), DesktopError> {
        let Some(Drawing { renderer, canvas }) = &mut self.drawing else { return Ok(()) };
        let now_us = self.start.elapsed().as_micros() as u64;
        // Not before the book is seen: the first picture takes a while.
        if let Some(script) = self.show.script.as_mut().filter(|_| !self.seen.frames_ms.is_empty())
        {
            script.feed(now_us, &mut self.view);
        }
        let begun = Instant::now();
        if self.view.step(now_us) {
            let draw = |renderer: &mut BookRenderer, scene: &Scene<'_>| renderer.draw(scene);
            self.view.frame(renderer, draw)?;
            canvas.window.pre_present_notify();
            canvas.swap()?;
            self.seen.frames_ms.push(begun.elapsed().as_secs_f64() * 1e3);
            events.set_control_flow(ControlFlow::Wait);
        } else if self.view.needs_frame() {
            events.set_control_flow(ControlFlow::WaitUntil(begun + UNSEEN));
        } else {
            events.set_control_flow(ControlFlow::Wait);
        }
        self.notices();
        if self.show.script.as_ref().is_some_and(Script::is_over) && !self.view.needs_frame() {
            events.exit();
        }
        Ok(())
    }

    /// The title says where the book is open.
    fn notices(&mut self) {
        while let Some(notice) = self.view.take_notice() {
            if let (Notice::Announce { page, pages }, Some(drawing)) = (notice, &self.drawing) {
                let title = format!("{} ({page} of {pages})", self.view.title());
                drawing.canvas.window.set_title(&title);
            }
        }
    }

    fn pointer(&mut self, id: u8, phase: Phase, at: PhysicalPosition<f64>) {
        let t_us = self.now_us();
        let [x, y] = [at.x, at.y].map(|v| (v * 256.0).round() as i32);
        self.view.pointer(Sample { t_us, id, phase, x, y, leaves: 0 });
    }

    fn touch(&mut self, touch: Touch) {
        let phase = match touch.phase {
            TouchPhase::Started => Phase::Down,
            TouchPhase::Moved => Phase::Move,
            TouchPhase::Ended => Phase::Up,
            TouchPhase::Cancelled => Phase::Cancel,
        };
        self.pointer((FINGERS + touch.id % HANDS) as u8, phase, touch.location);
    }

    fn grant(&mut self, events: &ActiveEventLoop, wish: Wish) {
        let t_us = self.now_us();
        match wish {
            Wish::Turn(forward) => self.view.turn(forward, 1),
            Wish::TurnAll(forward) => self.view.turn_all(forward),
            Wish::Bookmark(more) => self.view.bookmark(more, t_us),
            Wish::Back if self.view.put_back(t_us) => {}
            Wish::Back => events.exit(),
            Wish::Fullscreen => {
                if let Some(Drawing { canvas, .. }) = &self.drawing {
                    let full = canvas.window.fullscreen().is_none();
                    canvas.window.set_fullscreen(full.then_some(Fullscreen::Borderless(None)));
                }
            }
            Wish::Nothing => {}
        }
    }

    fn check(&mut self, events: &ActiveEventLoop, done: Result<(), DesktopError>) {
        if let Err(fault) = done {
            self.fault.get_or_insert(fault);
            events.exit();
        }
    }
}
