//! Instructions by `valgrind --tool=callgrind`: exact, the same at every run, whatever else the machine does.
//!
//! A short and a long run of the same steps are counted; their difference knows nothing of the program's start.
//! Twice, with one and with two Newton steps, and what a step costs falls apart into its two addends.

use crate::CostError;
use crate::axes::{Config, Form, GridName, RealName};
use crate::scene::{Kind, Stage, open};
use std::ffi::OsStr;
use std::path::Path;
use std::process::{Command, Stdio};

/// Steps of the short and of the long run.
const LENGTHS: [u32; 2] = [4, 12];

/// What is counted: everything of a configuration that changes the instructions of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Probe {
    /// The grid.
    pub grid: GridName,
    /// The scalar.
    pub real: RealName,
    /// Refinements of each Newton step.
    pub refinements: u32,
    /// The equations.
    pub form: Form,
    /// Line search.
    pub search: bool,
}

/// Instructions of a step beside its Newton steps, and of each Newton step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Counts {
    /// Once a step.
    pub step: f64,
    /// Once a Newton step.
    pub newton: f64,
}

impl Probe {
    /// The probe of a configuration.
    pub fn of(config: &Config) -> Self {
        let Config { grid, real, refinements, form, search, .. } = *config;
        Self { grid, real, refinements, form, search }
    }

    /// The steps that are counted: `words` as `Probe::words` wrote them.
    ///
    /// # Errors
    ///
    /// Words that are none.
    pub fn run(words: &str) -> Result<(), CostError> {
        let bad = || CostError::Level { axis: "probe", word: words.to_owned() };
        let parts: Vec<&str> = words.split_whitespace().collect();
        let [grid, real, refinements, form, search, newton, steps] = parts[..] else {
            return Err(bad());
        };
        let config = Config {
            grid: GridName::of(grid).ok_or_else(bad)?,
            real: if real == "f64" { RealName::F64 } else { RealName::F32 },
            refinements: refinements.parse().map_err(|_| bad())?,
            form: match form {
                "ours" => Form::Ours,
                other => Form::Seed { hessian: other == "seed+hessian" },
            },
            search: search == "on",
            newton: Some(newton.parse().map_err(|_| bad())?),
            ..Config::STANDARD
        };
        let steps: u32 = steps.parse().map_err(|_| bad())?;
        let mut sim = open(&Stage::flat(Kind::Turn), &config)?;
        for n in 1..=steps {
            let _ = sim.step(f64::from(n) / 60.0);
        }
        Ok(())
    }

    /// The words that ask for so many steps.
    fn words(&self, newton: u32, steps: u32) -> String {
        let real = if self.real == RealName::F64 { "f64" } else { "f32" };
        let form = match self.form {
            Form::Ours => "ours",
            Form::Seed { hessian: false } => "seed",
            Form::Seed { hessian: true } => "seed+hessian",
        };
        let search = if self.search { "on" } else { "off" };
        format!("{} {real} {} {form} {search} {newton} {steps}", self.grid, self.refinements)
    }
}

/// Whether the counter is there.
pub fn available() -> bool {
    let asked = Command::new("valgrind")
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    asked.is_ok_and(|s| s.success())
}

/// Counts a probe; `call` makes the command that runs [`Probe::run`] with the words it is given.
pub fn count(probe: &Probe, call: &dyn Fn(&mut Command, &str)) -> Option<Counts> {
    let step = |newton: u32| {
        let [short, long] = LENGTHS
            .map(|steps| instructions(&|c: &mut Command| call(c, &probe.words(newton, steps))));
        Some((long? - short?) as f64 / f64::from(LENGTHS[1] - LENGTHS[0]))
    };
    let (one, two) = (step(1)?, step(2)?);
    Some(Counts { step: 2.0 * one - two, newton: two - one })
}

/// Instructions of a program; `call` appends the program and its arguments.
pub fn instructions(call: &dyn Fn(&mut Command)) -> Option<u64> {
    let mut command = Command::new("valgrind");
    let null: &OsStr = Path::new("/dev/null").as_os_str();
    command.args(["--tool=callgrind", "--main-stacksize=536870912"]);
    let mut out = std::ffi::OsString::from("--callgrind-out-file=");
    out.push(null);
    command.arg(out);
    call(&mut command);
    let output = command.stdout(Stdio::null()).stderr(Stdio::piped()).output().ok()?;
    output.status.success().then_some(())?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find(|l| l.contains("Collected"))?;
    line.rsplit(':').next()?.trim().replace(',', "").parse().ok()
}
