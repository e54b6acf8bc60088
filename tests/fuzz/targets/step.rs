//! The whole step: any book, paper, world and view that is taken, and a hand. With `DOGLEAF_SHOW` set it says
//! what it drew.
#![no_main]

use arbitrary::{Result, Unstructured};
use dogleaf_core::Book;
use dogleaf_core::grid::{G6x5, Grid};
use dogleaf_core::real::Real;
use dogleaf_fuzz::{draw, fresh, refused};
use dogleaf_tests::watch::fault;
use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;

static NARROW: OnceLock<Box<Book<f32, G6x5>>> = OnceLock::new();
static WIDE: OnceLock<Box<Book<f64, G6x5>>> = OnceLock::new();

/// World steps at most.
const STEPS: u32 = 40;

fuzz_target!(|data: &[u8]| {
    let mut u = Unstructured::new(data);
    let _ = match u.arbitrary::<bool>() {
        Ok(true) => run(&mut u, &mut fresh(&NARROW)),
        _ => run(&mut u, &mut fresh(&WIDE)),
    };
});

fn run<R: Real, G: Grid>(u: &mut Unstructured<'_>, book: &mut Book<R, G>) -> Result<()> {
    let (spec, paper, world) = (draw::book(u)?, draw::paper(u)?, draw::world(u)?);
    let (view, fidelity) = (draw::view(u)?, draw::fidelity(u)?);
    if std::env::var_os("DOGLEAF_SHOW").is_some() {
        eprintln!("{spec:#?} {paper:#?} {world:#?} {view:#?} {fidelity:?}");
    }
    if refused(book, |b| b.open(&spec, &paper, &world, &view, fidelity)).is_err() {
        return Ok(());
    }
    let settings = fidelity.settings();
    let _ = book.take_up(u.arbitrary()?, u.arbitrary::<u8>()?.into());
    for _ in 0..STEPS {
        for _ in 0..u.int_in_range(0..=2)? {
            let sample = draw::sample(u, book.now_us())?;
            let _ = refused(book, |b| b.input(sample));
        }
        let report = book.step();
        // A step that is taken again is taken in four parts.
        let newton = 5 * settings.substeps * settings.newton;
        assert!(report.newton_steps <= newton, "bounded: {report:?}");
        assert_eq!(fault(book), None);
    }
    Ok(())
}
