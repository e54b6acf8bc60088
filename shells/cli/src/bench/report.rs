//! The report of a bench: a table for people, an object for programs.

use super::machine::Machine;
use super::parts::Part;
use super::ribbons::Ribbons;
use super::times::Figures;
use crate::run::Work;
use dogleaf_core::grid::Grid;
use dogleaf_core::kkt::{Factor, Stencil};
use dogleaf_core::real::Real;
use dogleaf_core::state::{Leaf, Sheet};
use dogleaf_core::step::Solver;
use dogleaf_core::step::constant::Constant;
use dogleaf_core::{Book, LoneLeaf};
use serde::Serialize;
use std::io::{self, Write};

/// Everything measured.
#[derive(Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    pub(super) machine: Machine,
    pub(super) grid: [usize; 2],
    pub(super) rounds: u32,
    pub(super) allocations: u64,
    pub(super) f32: Side,
    pub(super) f64: Side,
    pub(super) ribbons: Ribbons,
}

/// One scalar's figures.
#[derive(Serialize)]
pub(super) struct Side {
    pub(super) real: &'static str,
    /// Steps with a leaf in the air.
    pub(super) steps: usize,
    pub(super) step_us: Figures,
    pub(super) parts: Vec<Part>,
    /// Over the whole turn.
    pub(super) counts: Work,
    pub(super) bytes: Bytes,
    /// State at the end of the turn.
    pub(super) hash: String,
    /// All states on the way: equal bits in another build give an equal trail.
    pub(super) trail: String,
}

/// Sizes in memory.
#[derive(Serialize)]
pub(super) struct Bytes {
    book: usize,
    lone_leaf: usize,
    leaf: usize,
    sheet: usize,
    solver: usize,
    constant: usize,
    stencil: usize,
    factor: usize,
}

impl Bytes {
    pub(super) fn of<R: Real, G: Grid>() -> Self {
        Self {
            book: size_of::<Book<R, G>>(),
            lone_leaf: size_of::<LoneLeaf<R, G>>(),
            leaf: size_of::<Leaf<R, G>>(),
            sheet: size_of::<Sheet<R, G>>(),
            solver: size_of::<Solver<R, G>>(),
            constant: size_of::<Constant<R, G>>(),
            stencil: size_of::<Stencil<R, G>>(),
            factor: size_of::<Factor<R, G>>(),
        }
    }
}

impl Report {
    /// The table.
    pub(super) fn print(&self) -> io::Result<()> {
        let mut out = io::stdout().lock();
        let m = &self.machine;
        let [nx, nz] = self.grid;
        writeln!(out, "{}, {}", m.cpu, m.date)?;
        writeln!(
            out,
            "{}, {}, opt-level {}, built for {}",
            m.rustc, m.target, m.opt_level, m.level
        )?;
        writeln!(out, "rustc flags: {}", if m.flags.is_empty() { "none" } else { m.flags })?;
        writeln!(
            out,
            "a slow turn at {nx}x{nz}, {} rounds, least of the rounds' figures",
            self.rounds
        )?;
        for side in [&self.f32, &self.f64] {
            side.print(&mut out)?;
        }
        self.ribbons.print(&mut out)?;
        let allocations = self.allocations + self.ribbons.allocations();
        writeln!(out, "\nallocations during the steps: {allocations}")
    }
}

impl Side {
    fn print(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(
            out,
            "\n{:<12} {:>9} {:>9} {:>9} {:>7}",
            self.real, "median µs", "p95", "p99", "share"
        )?;
        row(out, "step", &self.step_us, 1.0)?;
        for part in &self.parts {
            row(out, &format!("  {}", part.name), &part.us, part.share)?;
        }
        let b = &self.bytes;
        writeln!(out, "{} steps with a leaf in the air", self.steps)?;
        writeln!(
            out,
            "bytes: book {}, of it leaf {}, sheet {}, solver {} (growing columns {}, factor {})",
            b.book, b.leaf, b.sheet, b.solver, b.stencil, b.factor
        )?;
        let counts = serde_json::to_string(&self.counts).unwrap_or_default();
        writeln!(out, "counts: {}", counts.replace(['{', '}', '"'], "").replace(',', ", "))?;
        writeln!(out, "hash {}, trail {}", self.hash, self.trail)
    }
}

fn row(out: &mut impl Write, name: &str, us: &Figures, share: f64) -> io::Result<()> {
    let Figures { median, p95, p99 } = us;
    writeln!(out, "{name:<12} {median:>9.2} {p95:>9.2} {p99:>9.2} {:>6.1} %", 100.0 * share)
}
