//! Whole books: release and peek, one dial at a time. Contact decides who moves whom, so the events' references often
//! do not agree; stretch and depth need none.

use super::Study;
use crate::CostError;
use crate::axes::{Config, Form, GridName, RealName};
use crate::cost::Cost;
use crate::errors::{Errors, later};
use crate::reference::BETTER;
use crate::report::{Known, Row, SceneReport};
use crate::run::{Trajectory, Watch, play};
use crate::scene::open_book;

/// Seconds a book may take to come to rest.
const LONGEST_S: f64 = 5.0;

pub(super) fn scene(study: &mut Study<'_>, name: &'static str) -> Result<SceneReport, CostError> {
    let configs = study.ask.levels.one_at_a_time();
    let fits = |c: &&Config| {
        let seed = c.form != Form::Ours && c.grid != GridName::G11x8;
        // A book's δ and scalar need no row of their own for every rate.
        let beside = c.rate == 960 && c.newton.is_none();
        !seed && !beside && (c.grid <= GridName::G16x12 || !study.ask.quick)
    };
    let configs: Vec<Config> = configs.iter().filter(fits).copied().collect();
    study.say(&format!("{name}: {} configurations", configs.len()));
    let (truth, agreement, methods) = truth(name, study.ask.quick)?;
    let mut scene = SceneReport { name, about: about(name), known: Vec::new(), rows: Vec::new() };
    for config in &configs {
        let run = watch(name, config)?;
        let mut errors = Errors::alone(&run);
        errors.vertical_ms = later(run.vertical_s, truth.vertical_s);
        errors.settled_ms = later(run.settled_s, truth.settled_s);
        let (presets, status) = (config.preset(true), run.work.status.name());
        scene.rows.push(Row {
            config: *config,
            presets,
            errors,
            cost: Cost::of(&run),
            front: false,
            status,
        });
    }
    known(study, &mut scene, agreement, methods);
    Ok(scene)
}

fn about(name: &str) -> &'static str {
    if name == "peek" {
        "a book of 320 pages: a corner is lifted, held for half a second and put back"
    } else {
        "a book of 320 pages: a corner is carried to the other fore-edge in a second and let go"
    }
}

fn watch(name: &str, config: &Config) -> Result<Trajectory, CostError> {
    let (rate, _) = config.world();
    let watch = Watch { rate, seconds: LONGEST_S, mesh: config.mesh, until_settled: true };
    Ok(play(open_book(name, config)?.as_mut(), watch))
}

/// The finest run, and how far the next one's events are from it, milliseconds.
fn truth(name: &str, quick: bool) -> Result<(Trajectory, f64, [String; 2]), CostError> {
    let rate = if quick { 960 } else { 3840 };
    let fine = Config { rate, newton: Some(2), real: RealName::F64, ..Config::STANDARD };
    let next = Config { rate: rate / 2, newton: None, ..fine };
    let (a, b) = (watch(name, &fine)?, watch(name, &next)?);
    let apart = [later(a.vertical_s, b.vertical_s), later(a.settled_s, b.settled_s)];
    let agreement = apart.into_iter().flatten().fold(0.0_f64, |m, d| m.max(d.abs()));
    Ok((a, agreement, [fine.to_string(), next.to_string()]))
}

/// Takes the events back where the references do not agree ten times better than the smallest error.
fn known(study: &mut Study<'_>, scene: &mut SceneReport, agreement: f64, methods: [String; 2]) {
    let events = |e: &Errors| [e.vertical_ms, e.settled_ms].into_iter().flatten().map(f64::abs);
    let all = scene.rows.iter().flat_map(|r| events(&r.errors));
    let smallest = all.filter(|e| *e > 0.0).fold(f64::INFINITY, f64::min);
    let converged = BETTER * agreement <= smallest;
    if !converged {
        let name = scene.name;
        study.omissions.push(format!("{name}: reference not converged (events of the two finest runs are {agreement:.1} ms apart); event-time errors are told only where they are ten times that"));
        let told = |e: Option<f64>| e.filter(|e| e.abs() >= BETTER * agreement);
        for row in &mut scene.rows {
            row.errors.vertical_ms = told(row.errors.vertical_ms);
            row.errors.settled_ms = told(row.errors.settled_ms);
        }
    }
    scene.known.push(Known { what: "events, ms".into(), methods, agreement, smallest, converged });
}
