//! The forty-eight hard scenarios: what is done, what must hold, and one figure each.
//!
//! | rule | what must hold after every step |
//! |---|---|
//! | I1 | every number is finite |
//! | I2 | a step that says it went well left a sheet: edges in the band, stars nearly flat |
//! | I3 | no edge is stretched beyond the scenario's bound |
//! | I4 | nothing lies deeper in a block than half a leaf |
//! | I5 | energy does not grow where nobody gives any |
//! | I6 | speeds are bounded |
//! | I7 | the same input gives the same hashes |
//! | I8 | work is bounded |
//! | I9 | at rest in time |
//!
//! I1-I4 and I6-I9 are judged by [`harness`] wherever a book is played; I5 where a lone leaf's whole energy is
//! known. A scenario adds what it expects beyond.

pub mod books;
pub mod dials;
pub mod faults;
pub mod field;
pub mod fingers;
pub mod hands;
pub mod harness;
pub mod lone;
pub mod odd;
pub mod reading;
pub mod stream;
pub mod sweeps;
pub mod symmetry;
pub mod table;

use dogleaf_core::scene::Fidelity;

/// How a scenario is played.
#[derive(Debug, Clone, Copy)]
pub struct At {
    /// What accuracy is bought.
    pub fidelity: Fidelity,
    /// At full length; else a short version for debug builds.
    pub full: bool,
}

impl At {
    /// A count at full length, or a short one.
    pub fn count(self, full: u32, short: u32) -> u32 {
        if self.full { full } else { short }
    }
}

/// What came of a scenario.
#[derive(Debug, Clone, Default)]
pub struct Found {
    /// Its characteristic figure.
    pub figure: f64,
    /// What is wrong; nothing where it is passed.
    pub faults: Vec<String>,
}

impl Found {
    /// A figure that must not exceed a bound.
    pub fn within(figure: f64, most: f64) -> Self {
        let mut found = Self { figure, faults: Vec::new() };
        // Also where it is no number.
        found.expect(figure <= most, || format!("{figure:.3e}, at most {most:.1e}"));
        found
    }
    /// Complains unless it holds.
    pub fn expect(&mut self, holds: bool, what: impl FnOnce() -> String) {
        if !holds {
            self.faults.push(what());
        }
    }
    /// With what was found wrong elsewhere.
    #[must_use]
    pub fn with(mut self, faults: impl IntoIterator<Item = String>) -> Self {
        self.faults.extend(faults);
        self
    }
}

/// How a promise is proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The rules, as they stand.
    Absolute,
    /// Two runs that must agree.
    Metamorphic,
    /// Errors that must shrink.
    Convergence,
    /// Something is made to fail.
    Fault,
    /// The figure itself is pinned by the table.
    Golden,
}

/// A scenario in both scalars, or why there is none yet.
#[derive(Debug, Clone, Copy)]
pub enum Run {
    /// It can be played.
    Plays([fn(At) -> Found; 2]),
    /// It cannot, yet.
    NotYet(&'static str),
}

/// One row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Scenario {
    /// Its number.
    pub number: u32,
    /// What happens.
    pub name: &'static str,
    /// How it is proved.
    pub kind: Kind,
    /// What its figure is.
    pub figure: &'static str,
    /// How it is played.
    pub run: Run,
}

/// A row whose function is generic over the scalar.
macro_rules! row {
    ($number:literal, $name:literal, $kind:ident, $figure:literal, $($run:ident)::+) => {
        Scenario {
            number: $number,
            name: $name,
            kind: Kind::$kind,
            figure: $figure,
            run: Run::Plays([$($run)::+::<f32>, $($run)::+::<f64>]),
        }
    };
}

const NO_BOOKMARK: &str = "a book holds one leaf at a time: no finger between pages yet";

/// All of them, in the order of their numbers.
pub const ALL: [Scenario; 48] = [
    row!(1, "rest without input", Absolute, "drift, widths", lone::rest),
    row!(2, "free fall of a lifted page", Absolute, "energy gained, share", lone::fall),
    row!(3, "no damping: energy lost to the step", Convergence, "order of the loss", lone::drift),
    row!(4, "exactly flat", Absolute, "largest step, widths", lone::flat),
    row!(5, "pulled along its normal", Metamorphic, "apart, widths", symmetry::along_normal),
    row!(6, "symmetric about mid height", Metamorphic, "asymmetry, widths", symmetry::mid_height),
    row!(7, "left to right, right to left", Metamorphic, "apart, widths", symmetry::mirror),
    row!(8, "the whole scene turned", Metamorphic, "apart, widths", symmetry::turned),
    row!(9, "step from 1/1000 to 1/10 s", Convergence, "order in time", sweeps::steps),
    row!(10, "frames of any length", Absolute, "steps in a call", sweeps::frames),
    row!(11, "grids from 6x5 to 22x16", Convergence, "droop off at 11x8", sweeps::grids),
    row!(12, "each weight, 1e-3 to 1e6", Absolute, "worst stretch", sweeps::weights),
    row!(13, "weights in pairs at extremes", Absolute, "worst stretch", sweeps::pairs),
    row!(14, "one leaf, a block of thousands", Absolute, "slowest to rest, s", books::masses),
    row!(15, "1, 2, 3 and 10,000 pages", Absolute, "slowest to rest, s", books::counts),
    row!(16, "open at the first, the last page", Absolute, "slowest to rest, s", books::ends),
    row!(17, "thickness from 0 to the width", Absolute, "worst stretch", books::thickness),
    row!(18, "aspect from 1:100 to 100:1", Absolute, "worst stretch", books::aspects),
    row!(19, "the same book at any size", Metamorphic, "apart, widths", books::sizes),
    row!(20, "degenerate poses loaded", Fault, "poses held", odd::poses),
    row!(21, "target at the node, at the binding", Absolute, "worst stretch", hands::at_home),
    row!(22, "target a thousand widths away", Absolute, "worst stretch", hands::far),
    row!(23, "target teleports every frame", Absolute, "worst stretch", hands::teleports),
    row!(24, "scribble at 20 Hz for a minute", Absolute, "fastest, widths/s", hands::scribble),
    row!(25, "under, through, behind", Absolute, "deepest, leaves", hands::under),
    row!(26, "let go at top dead centre", Golden, "to rest, s (-: back)", hands::dead_centre),
    row!(27, "240 Hz touch, 60 Hz frames", Metamorphic, "apart, widths", stream::rates),
    row!(28, "events dropped, 0 to 90 %", Metamorphic, "apart at the end", stream::dropped),
    row!(29, "events doubled", Metamorphic, "apart at the end", stream::doubled),
    row!(30, "events out of order", Metamorphic, "refused", stream::unordered),
    row!(31, "time jumps 30 s", Absolute, "steps caught up", stream::jump),
    row!(32, "a pause, a snapshot, a cancel", Metamorphic, "to rest, s", stream::pause),
    row!(33, "pointers without rules", Absolute, "samples refused", fingers::confused),
    row!(34, "another view in mid drag", Metamorphic, "hashes that differ", fingers::looks),
    row!(35, "rays along the drag plane", Absolute, "worst stretch", fingers::edge_on),
    row!(36, "any number in any field", Fault, "refused", field::fields),
    row!(37, "recordings with bits flipped", Fault, "flips believed", field::flips),
    row!(38, "a NaN is planted", Fault, "steps to recover", faults::nan),
    row!(39, "the n-th factorisation fails", Fault, "places tried", faults::factor),
    row!(40, "the line search always fails", Fault, "trials in a step", faults::search),
    row!(41, "Newton steps 1, 2, 5, converged", Convergence, "error of 1, widths", dials::newton),
    row!(42, "constraint Hessian on and off", Convergence, "apart, widths", dials::hessian),
    row!(43, "collision passes 0 to 3", Convergence, "deepest at 3, leaves", dials::passes),
    row!(44, "rolled up on itself", Absolute, "worst stretch", odd::roll),
    Scenario {
        number: 45,
        name: "finger at two pages, fast flip",
        kind: Kind::Absolute,
        figure: "",
        run: Run::NotYet(NO_BOOKMARK),
    },
    row!(46, "random books, random hands", Absolute, "share under 15 %", reading::random),
    row!(47, "an hour of reading", Golden, "hash, first 20 bits", reading::hour),
    row!(48, "f32 beside f64", Metamorphic, "apart, widths", dials::scalars),
];
