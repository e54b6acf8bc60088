//! Plays the recorded slow turn and says what it cost: hash, instructions a step, memory.
//!
//! Status 0 if every step has the hash that was recorded, 1 else.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
#[cfg(feature = "defmt")]
use defmt_semihosting as _;
use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::record::{Reader, Record, RecordError};
use dogleaf_core::selftest::SelfTest;
use dogleaf_firmware::{Clock, Line, Tally, leave, memory};

/// The golden slow turn.
static RECORDING: &[u8] = include_bytes!("../../../../../fixtures/recordings/slow_turn_f32.dlr");

#[entry]
fn main() -> ! {
    static mut BOOK: Book<f32, G11x8> = Book::EMPTY;
    static mut TALLY: Tally = Tally::EMPTY;
    let healthy = SelfTest::run(BOOK);
    Line::new().text("self test             ").text(healthy.name()).say();
    #[cfg(feature = "planted")]
    dogleaf_firmware::planted::misbehave(0);
    let mut clock = Clock::start();
    let well = match play(BOOK, TALLY, &mut clock) {
        Ok(well) => well,
        Err(_why) => {
            Line::new().text("the recording is refused").say();
            #[cfg(feature = "defmt")]
            defmt::error!("recording: {}", _why);
            false
        }
    };
    spend(TALLY);
    leave(well && healthy == SelfTest::Passed)
}

/// Takes the book through the recording. Whether all hashes were equal.
fn play(
    book: &mut Book<f32, G11x8>,
    tally: &mut Tally,
    clock: &mut Clock,
) -> Result<bool, RecordError> {
    let reader = Reader::open(RECORDING)?;
    reader.header().fits::<f32, G11x8>()?;
    reader.header().setup.open(book)?;
    let (mut steps, mut differ, mut recorded) = (0_u32, None, 0);
    for record in reader.records() {
        match record? {
            Record::Input(sample) => {
                let _ = book.input(sample);
            }
            Record::Look(view) => book.look(&view)?,
            Record::Step { hash } => {
                clock.begin();
                let report = book.step();
                #[cfg(feature = "planted")]
                let _ = (0..4).map(|_| book.step()).last();
                let count = clock.instructions();
                if report.steps > 0 && book.leaf().is_some() {
                    tally.add(u32::try_from(count).unwrap_or(u32::MAX));
                }
                if differ.is_none() && book.state_hash() != hash {
                    differ = Some(steps);
                }
                recorded = hash;
                steps += 1;
            }
        }
    }
    Line::new().text("steps                 ").number(steps).say();
    Line::new().text("hash                  ").hash(book.state_hash()).say();
    Line::new().text("recorded              ").hash(recorded).say();
    if let Some(step) = differ {
        Line::new().text("DIFFERS from step     ").number(step).say();
    }
    Ok(differ.is_none())
}

/// Says what the run took.
fn spend(tally: &Tally) {
    let figures = [
        ("steps with a leaf     ", tally.length()),
        ("instructions mean     ", tally.mean()),
        ("instructions median   ", tally.median()),
        ("instructions most     ", tally.most()),
        ("steps not counted     ", tally.lost),
        ("static data bytes     ", memory::statics().0),
        ("static zero bytes     ", memory::statics().1),
        ("of these the book     ", size_of::<Book<f32, G11x8>>() as u32),
        ("of these the counts   ", size_of::<Tally>() as u32),
        ("stack high water      ", memory::stack()),
    ];
    for (what, figure) in figures {
        Line::new().text(what).number(figure).say();
    }
}
