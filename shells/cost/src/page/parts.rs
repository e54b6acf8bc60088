//! What is drawn: time against error, grids, books, orders, peers.

use super::escape;
use super::plot::{Mark, Plot, Shape};
use crate::axes::{Form, GridName, RealName};
use crate::report::{Report, Row, SceneReport};
use std::fmt::Write;

/// The axis of times.
const US: &str = "microseconds a picture (1/60 s)";

/// Says first whether the references can be trusted, and whether the fidelities lie where they should.
pub(super) fn verdict(t: &mut String, report: &Report) {
    let time = report.scenes.iter().filter(|s| s.name == "turn").flat_map(|s| &s.known);
    let good: Vec<String> = time
        .clone()
        .map(|k| {
            let (class, word) = if k.converged {
                ("good", "converged")
            } else {
                ("bad", "reference not converged")
            };
            format!(
                "{} <span class=\"{class}\">{word}</span> ({:.0e}, smallest error {:.0e})",
                escape(&k.what),
                k.agreement,
                k.smallest
            )
        })
        .collect();
    if !good.is_empty() {
        let _ = write!(
            t,
            "<p>Two references by different methods, and how far they are apart on the turn, in page widths: {}.</p>",
            good.join("; ")
        );
    }
    let off: Vec<&str> = report.presets.iter().filter(|p| !p.front).map(|p| p.name).collect();
    if !report.presets.is_empty() {
        let _ = if off.is_empty() {
            write!(t, "<p>The four fidelities lie <span class=\"good\">on the front</span>.</p>")
        } else {
            write!(
                t,
                "<p>Not on the front: <span class=\"bad\">{}</span>; see the table of fidelities.</p>",
                off.join(", ")
            )
        };
    }
}

pub(super) fn plots(t: &mut String, report: &Report) {
    t.push_str("<div class=\"plots\">");
    for scene in &report.scenes {
        match scene.name {
            "turn" => {
                figure(
                    t,
                    "Turn: time bought with steps and Newton steps, 11x8",
                    &in_time(report, scene),
                    true,
                    "Colour: Newton steps a step; shape: scalar. The line is the front among safe configurations. Errors are beside this grid's own limit.",
                );
                let fine = every_grid(report, scene);
                figure(
                    t,
                    "The same on every grid",
                    &fine,
                    false,
                    "Each grid beside its own limit of small steps; lines are the fronts.",
                );
            }
            "fall" => figure(
                t,
                "Fall: a clamped leaf let go, half a second",
                &in_time(report, scene),
                false,
                "Fast motion: here the step's length matters most.",
            ),
            _ => figure(
                t,
                &format!("{}: edge stretch of a whole book's leaf", scene.name),
                &stretch(scene),
                false,
                "Largest edge stretch; what needs no reference.",
            ),
        }
    }
    if !report.grids.is_empty() {
        let text = "Drop over reach of a leaf clamped level, at rest, beside the heavy elastica, against the time of one step; the turn's error in space where its limit is known. Peers, where measured, on the same sheet.";
        figure(t, "Grids and peers, judged by the heavy elastica", &droop(report), false, text);
    }
    if !report.orders.is_empty() {
        figure(t, "Orders on a rolling sheet", &orders(report), false, &order_text(report));
    }
    t.push_str("</div>");
}

fn figure(t: &mut String, title: &str, plot: &Plot, wide: bool, caption: &str) {
    let class = if wide { " class=\"wide\"" } else { "" };
    let _ = write!(
        t,
        "<figure{class}><h3>{}</h3>{}<figcaption>{}</figcaption></figure>",
        escape(title),
        plot.svg(),
        escape(caption)
    );
}

fn colour(row: &Row) -> usize {
    match (row.config.form, row.config.newton) {
        (Form::Seed { .. }, _) => 5,
        (_, Some(1)) => 0,
        (_, Some(2)) => 1,
        (_, Some(3)) => 2,
        (_, Some(_)) => 3,
        (_, None) => 4,
    }
}

fn shape(row: &Row) -> Shape {
    match (
        row.config.unsafe_dial() || row.config.form != Form::Ours,
        row.config.real,
        row.config.refinements,
    ) {
        (true, ..) => Shape::Cross,
        (_, RealName::F32, 0) => Shape::Disc,
        (_, RealName::F32, _) => Shape::Diamond,
        (_, RealName::F64, _) => Shape::Square,
    }
}

fn marked(row: &Row, error: f64) -> Mark {
    let names = row.presets.join(", ");
    let front = if row.front { ", on the front" } else { "" };
    Mark {
        at: [row.cost.axis(), error],
        colour: colour(row),
        shape: shape(row),
        title: format!(
            "{}: error {error:.2e}, {:.1} us a picture, {:.1} factorisations{front}",
            row.config, row.cost.frame_us, row.cost.factorisations
        ),
        name: (!names.is_empty()).then_some(names),
    }
}

fn legend() -> Vec<(usize, Shape, String)> {
    let words = ["Newton 1", "Newton 2", "Newton 3", "Newton 5", "to tolerance"];
    let mut all: Vec<_> =
        words.iter().enumerate().map(|(n, w)| (n, Shape::Square, (*w).to_owned())).collect();
    let shapes = [
        (Shape::Disc, "f32"),
        (Shape::Diamond, "f32 refined"),
        (Shape::Square, "f64"),
        (Shape::Cross, "other dials"),
    ];
    all.extend(shapes.map(|(s, w)| (5, s, w.to_owned())));
    all
}

fn front(rows: &[&Row]) -> Vec<[f64; 2]> {
    let on = rows.iter().filter(|r| r.front);
    let mut line: Vec<[f64; 2]> =
        on.filter_map(|r| Some([r.cost.axis(), r.errors.shape_rms?])).collect();
    line.sort_by(|a, b| a[0].total_cmp(&b[0]));
    line
}

fn in_time(report: &Report, scene: &SceneReport) -> Plot {
    let rows: Vec<&Row> = scene.rows.iter().filter(|r| r.config.grid == GridName::G11x8).collect();
    // Another δ is another sheet: its error is not one in time.
    let own = |r: &&&Row| r.config.delta.to_bits() == crate::axes::Config::STANDARD.delta.to_bits();
    let marks =
        rows.iter().filter(own).filter_map(|r| Some(marked(r, r.errors.shape_rms?))).collect();
    Plot {
        marks,
        lines: vec![front(&rows)],
        axes: [report.unit.into(), "RMS shape error, page widths".into()],
        legend: legend(),
    }
}

fn every_grid(report: &Report, scene: &SceneReport) -> Plot {
    // Instructions are not counted on every grid of a quick run: time is.
    let counted = scene.rows.iter().all(|r| r.cost.frame_instructions.is_some());
    let unit = if counted { report.unit } else { US };
    let cost = |r: &Row| if counted { r.cost.axis() } else { r.cost.frame_us };
    let mut plot =
        Plot { axes: [unit.into(), "RMS shape error, page widths".into()], ..Plot::default() };
    for (n, grid) in GridName::ALL.into_iter().enumerate() {
        let rows: Vec<&Row> =
            scene.rows.iter().filter(|r| r.config.grid == grid && r.front).collect();
        if rows.is_empty() {
            continue;
        }
        let mut line: Vec<[f64; 2]> =
            rows.iter().filter_map(|r| Some([cost(r), r.errors.shape_rms?])).collect();
        line.sort_by(|a, b| a[0].total_cmp(&b[0]));
        plot.lines.push(line);
        plot.legend.push((n, Shape::Disc, grid.to_string()));
        plot.marks.extend(rows.iter().filter_map(|r| {
            let mark = marked(r, r.errors.shape_rms?);
            Some(Mark { at: [cost(r), mark.at[1]], colour: n, name: None, ..mark })
        }));
    }
    plot
}

fn stretch(scene: &SceneReport) -> Plot {
    let marks = scene.rows.iter().map(|r| {
        let at = [r.cost.frame_us, r.errors.stretch[0]];
        Mark { at, ..marked(r, r.errors.stretch[0]) }
    });
    Plot {
        marks: marks.collect(),
        lines: Vec::new(),
        axes: [US.into(), "largest edge stretch".into()],
        legend: legend(),
    }
}

fn droop(report: &Report) -> Plot {
    let mut plot =
        Plot { axes: ["microseconds a step".into(), "relative error".into()], ..Plot::default() };
    let coloured = [(0, "droop, Γ 1"), (1, "droop, Γ 10"), (2, "droop, Γ 30")];
    plot.legend.extend(coloured.map(|(c, w)| (c, Shape::Disc, w.to_owned())));
    plot.legend.push((3, Shape::Diamond, "space, turn".into()));
    for g in &report.grids {
        for (n, [gamma, error]) in g.droop.iter().enumerate() {
            let title = format!("{}, gamma {gamma}: {:.2} %", g.grid, 100.0 * error);
            plot.marks.push(Mark {
                at: [g.step_us, error.abs()],
                colour: n,
                shape: Shape::Disc,
                title,
                name: None,
            });
        }
        if let Some(space) = g.space_rms {
            let title = format!("{}: error in space {space:.1e} page widths", g.grid);
            plot.marks.push(Mark {
                at: [g.step_us, space],
                colour: 3,
                shape: Shape::Diamond,
                title,
                name: None,
            });
        }
    }
    for n in 0..coloured.len() {
        plot.lines.push(
            report
                .grids
                .iter()
                .filter_map(|g| Some([g.step_us, g.droop.get(n)?[1].abs()]))
                .collect(),
        );
    }
    let Some(peers) = &report.peers else { return plot };
    plot.legend.push((4, Shape::Square, "peers".into()));
    for p in &peers.rows {
        let Some(ratio) = p.ratio else { continue };
        let error = (ratio / p.elastica - 1.0).abs();
        let title = format!("{} {}, gamma {}: {:.1} %", p.name, p.config, p.gamma, 100.0 * error);
        plot.marks.push(Mark {
            at: [p.step_us, error],
            colour: 4,
            shape: Shape::Square,
            title,
            name: None,
        });
    }
    plot
}

fn orders(report: &Report) -> Plot {
    let mut plot = Plot {
        axes: ["spacing (page widths), step (seconds)".into(), "RMS error, page widths".into()],
        ..Plot::default()
    };
    for (n, order) in report.orders.iter().enumerate() {
        plot.lines.push(order.points.clone());
        let word = order.what.split(':').next().unwrap_or_default();
        plot.legend.push((n, Shape::Disc, format!("{word} {:.2}", order.order)));
        plot.marks.extend(order.points.iter().map(|p| Mark {
            at: *p,
            colour: n,
            shape: Shape::Disc,
            title: format!("{:.4}: {:.2e}", p[0], p[1]),
            name: None,
        }));
    }
    plot
}

fn order_text(report: &Report) -> String {
    let all = report
        .orders
        .iter()
        .map(|o| format!("{}: order {:.2}, at least {} promised", o.what, o.order, o.least));
    all.collect::<Vec<_>>().join(". ") + "."
}
