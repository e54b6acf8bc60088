//! Reads the built-in book on a simulated panel under a recorded finger; says every picture, what it cost, and what is
//! drawn in ten seconds of rest: nothing.
//!
//! Status 0 if nothing was drawn at rest and the book is open where the finger left it, 1 else. Whether the pictures are
//! the right ones `cargo ci eink` says: their lines are those of the host.
#![no_std]
#![no_main]

use cortex_m_rt::{entry, exception};
#[cfg(feature = "defmt")]
use defmt_semihosting as _;
use dogleaf_core::grid::G11x8;
use dogleaf_core::reading::Reading;
use dogleaf_eink::simulated::Cell;
use dogleaf_eink::{Band, Sheet, Simulated};
use dogleaf_eink_reader::desk::{Desk, Part, Shot, Watch};
use dogleaf_eink_reader::fall::Fall;
use dogleaf_eink_reader::line::{Text, told};
use dogleaf_eink_reader::{Built, Room, room, scene};
use dogleaf_firmware::meter::{Meter, Nap};
use dogleaf_firmware::{Line, leave, memory};

/// Pixels of the panel.
const PIXELS: usize = 800 * 600;

#[entry]
fn main() -> ! {
    static mut ROOM: Room = Room::EMPTY;
    static mut CELLS: [Cell; PIXELS] = [Cell::NEW; PIXELS];
    let Some(board) = cortex_m::Peripherals::take() else { leave(false) };
    let mut watcher = Watcher { meter: Meter::start(), nap: Nap::new(board.SYST), pictures: 0 };
    let well = session(ROOM, CELLS, &mut watcher).unwrap_or(false);
    memory_spent();
    leave(well)
}

/// It only wakes the processor.
#[exception]
fn SysTick() {}

/// Plays the recording, then rests. Whether the end is as it should be.
fn session(
    room: &'static mut Room,
    cells: &'static mut [Cell],
    watcher: &mut Watcher,
) -> Option<bool> {
    let stage = scene::stage().ok()?;
    let (print, glass) = (Built::open(scene::PAGES)?, Simulated::new(scene::PANEL, cells)?);
    let setup = scene::setup(&stage);
    let mut desk = Desk::open(room, glass, print, stage, &setup).ok()?;
    let mut touches = scene::touches();
    desk.run(&mut touches, scene::END_US, watcher);
    let drawn = watcher.pictures;
    let naps = watcher.nap.count;
    let _ = watcher.meter.take();
    desk.run(&mut touches, scene::END_US + scene::REST_US, watcher);
    let rest: u64 = watcher.meter.take().iter().sum();
    let redraws = watcher.pictures - drawn;
    say("pictures              ", drawn);
    say("redraws at rest       ", redraws);
    say("naps at rest          ", watcher.nap.count - naps);
    say("instructions at rest  ", rest as u32);
    say("page                  ", desk.room().reading.page());
    Some(redraws == 0 && desk.room().reading.page() == setup.book.open_at)
}

/// Says every picture and what it cost.
struct Watcher {
    meter: Meter,
    nap: Nap,
    pictures: u32,
}

impl Watch for Watcher {
    fn part(&mut self, part: Part) {
        self.meter.turn_to(part);
    }

    fn shot(&mut self, shot: &Shot, glass: &Simulated<'_>) {
        let [physics, raster, _] = self.meter.take();
        let mut text = Text::EMPTY;
        told(&mut text, shot, glass);
        Line::new().text("picture ").text(text.as_str()).say();
        let thousands = |n: u64| (n / 1_000) as u32;
        let line = Line::new().text("cost ").number(thousands(physics));
        line.byte(b' ').number(thousands(raster)).say();
        #[cfg(feature = "defmt")]
        defmt::info!("{=u64} us: {=str}", shot.at_us, shot.update.waveform.name());
        self.pictures += 1;
        // What was said does not count.
        self.meter.open();
    }

    fn sleep(&mut self, us: u64) {
        self.meter.close();
        self.nap.sleep(us);
        self.meter.open();
    }
}

/// Says what of the memory is whose.
fn memory_spent() {
    let figures = [
        ("book and its solver   ", size_of::<Reading<f32, G11x8>>()),
        ("band of pixels        ", size_of::<Band<{ room::CELLS }>>()),
        ("leaf as it is seen    ", size_of::<Sheet>()),
        ("key frames that wait  ", size_of::<Fall>()),
        ("core and bands        ", size_of::<Room>()),
        ("simulated panel       ", size_of::<[Cell; PIXELS]>()),
        ("built-in pages        ", scene::PAGES.len()),
    ];
    figures.iter().for_each(|&(what, bytes)| say(what, bytes as u32));
    let (data, zero) = memory::statics();
    say("static bytes          ", data + zero);
    say("stack high water      ", memory::stack());
}

fn say(what: &str, number: u32) {
    Line::new().text(what).number(number).say();
}
