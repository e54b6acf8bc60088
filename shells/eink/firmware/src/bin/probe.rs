//! Runs the probes of `tests/probe` on the board: one line each, as on every other target.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
#[cfg(feature = "defmt")]
use defmt_semihosting as _;
use dogleaf_firmware::{Line, leave};
use dogleaf_probe::{Probe, Work, probes};

#[entry]
fn main() -> ! {
    static mut WORK: Work = Work::EMPTY;
    probes::<f32>().for_each(|probe| say(&probe, WORK));
    // In software, without a unit for them, `f64` would take minutes.
    if cfg!(feature = "double") {
        probes::<f64>().for_each(|probe| say(&probe, WORK));
    }
    leave(true)
}

fn say(probe: &Probe, work: &mut Work) {
    let Probe { kind, name, tier, run } = *probe;
    let hash = run(work);
    let line = Line::new().text(kind).byte(b' ').text(tier).byte(b' ').text(name);
    line.byte(b' ').hash(hash).say();
}
