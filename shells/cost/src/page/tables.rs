//! What stands in tables.

use super::escape;
use crate::report::{Report, Row};
use std::fmt::Write;

fn open(t: &mut String, heads: &[&str]) {
    t.push_str("<div class=\"scroll\"><table><tr>");
    heads.iter().for_each(|h| {
        let _ = write!(t, "<th>{}</th>", escape(h));
    });
    t.push_str("</tr>");
}

fn close(t: &mut String) {
    t.push_str("</table></div>");
}

pub(super) fn presets(t: &mut String, report: &Report) {
    if report.presets.is_empty() {
        return;
    }
    t.push_str("<h2>Fidelities</h2>");
    open(t, &["fidelity", "dials", "RMS error", "cost", "front"]);
    for p in &report.presets {
        let (class, word) = match &p.beaten_by {
            None => ("good", "on it".to_owned()),
            Some(by) => ("bad", format!("beaten by {by}")),
        };
        let _ = write!(
            t,
            "<tr><td>{}</td><td>{}</td><td>{:.2e}</td><td>{:.0}</td><td class=\"{class}\">{}</td></tr>",
            p.name,
            escape(&p.config),
            p.error,
            p.cost,
            escape(&word)
        );
    }
    close(t);
}

pub(super) fn claims(t: &mut String, report: &Report) {
    t.push_str("<h2>The seed's claims</h2>");
    open(t, &["claim", "seed", "rebuilt here", "ours", ""]);
    for c in &report.claims {
        let _ = write!(
            t,
            "<tr><td class=\"l w\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"l w\">{}</td></tr>",
            escape(c.what),
            escape(c.seed),
            escape(&c.rebuilt),
            escape(&c.ours),
            escape(c.note)
        );
    }
    close(t);
}

pub(super) fn references(t: &mut String, report: &Report) {
    t.push_str("<h2>References</h2><p class=\"note\">An error is drawn only where two methods agree ten times better than it.</p>");
    open(t, &["scene", "for", "one method", "the other", "apart", "smallest error", ""]);
    let scenes = report.scenes.iter().flat_map(|s| s.known.iter().map(move |k| (s.name, k)));
    for (name, k) in scenes.chain(report.space.iter().map(|k| ("turn", k))) {
        let (class, word) =
            if k.converged { ("good", "converged") } else { ("bad", "not converged") };
        let [a, b] = k.methods.each_ref().map(|m| escape(m));
        let _ = write!(
            t,
            "<tr><td>{name}</td><td>{}</td><td class=\"l w\">{a}</td><td class=\"l w\">{b}</td><td>{:.1e}</td><td>{:.1e}</td><td class=\"{class}\">{word}</td></tr>",
            escape(&k.what),
            k.agreement,
            k.smallest
        );
    }
    close(t);
}

pub(super) fn omissions(t: &mut String, report: &Report) {
    t.push_str("<h2>Omissions</h2><ul>");
    let peers = report.peers.iter().flat_map(|p| &p.omissions);
    for o in report.omissions.iter().chain(peers) {
        let _ = write!(t, "<li>{}</li>", escape(o));
    }
    t.push_str("</ul>");
}

const HEADS: [&str; 16] = [
    "configuration",
    "RMS",
    "max",
    "outline px",
    "stretch %",
    "mean %",
    "rms %",
    "star mrad",
    "drift /s",
    "vertical ms",
    "rest ms",
    "depth",
    "us a step (IQR)",
    "cost",
    "fact.",
    "kB",
];

/// Every configuration of every scene, and the peers.
pub(super) fn all(t: &mut String, report: &Report) {
    t.push_str("<h2>Everything</h2>");
    for scene in &report.scenes {
        let _ = write!(
            t,
            "<details><summary>{}: {} configurations</summary><p class=\"note\">{}</p>",
            scene.name,
            scene.rows.len(),
            escape(scene.about)
        );
        open(t, &HEADS);
        scene.rows.iter().for_each(|r| row(t, r));
        close(t);
        t.push_str("</details>");
    }
    let Some(peers) = &report.peers else { return };
    let _ = write!(
        t,
        "<h2>Peers</h2><p class=\"note\">A leaf of the same paper clamped level: at rest, and a quarter of a second after it was let go.</p>"
    );
    open(
        t,
        &[
            "peer",
            "dials",
            "gamma",
            "drop/reach",
            "elastica",
            "error %",
            "fall 0.25 s, m",
            "us a step",
        ],
    );
    for p in &peers.rows {
        let [ratio, error] = match p.ratio {
            Some(r) => [format!("{r:.3}"), format!("{:.1}", 100.0 * (r / p.elastica - 1.0))],
            None => ["no rest".to_owned(), "-".to_owned()],
        };
        let fall = p.fall_m.map_or_else(|| "-".into(), |f| format!("{f:.4}"));
        let _ = write!(
            t,
            "<tr><td>{}</td><td class=\"l\">{}</td><td>{:.1}</td><td>{ratio}</td><td>{:.3}</td><td>{error}</td><td>{fall}</td><td>{:.0}</td></tr>",
            escape(&p.name),
            escape(&p.config),
            p.gamma,
            p.elastica,
            p.step_us
        );
    }
    close(t);
    if !peers.linear.is_empty() {
        t.push_str("<p class=\"note\">Factor and solve of the seed's matrix, one process:</p>");
        open(t, &["method", "us"]);
        for (name, us) in &peers.linear {
            let _ = write!(t, "<tr><td>{}</td><td>{us:.1}</td></tr>", escape(name));
        }
        close(t);
    }
}

fn row(t: &mut String, r: &Row) {
    let e = |v: Option<f64>| v.map_or_else(|| "-".into(), |v| format!("{v:.2e}"));
    let d = |v: Option<f64>, n: usize| v.map_or_else(|| "-".into(), |v| format!("{v:.n$}"));
    let x = &r.errors;
    let names = if r.presets.is_empty() {
        String::new()
    } else {
        format!(" <b>{}</b>", r.presets.join(", "))
    };
    let star = if r.front { " &#9679;" } else { "" };
    let [_, low, middle, high] = r.cost.step_us;
    let _ = write!(
        t,
        "<tr><td>{}{names}{star}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.2}</td><td>{:.2}</td><td>{:.3}</td><td>{:.1}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{middle:.1} ({low:.1}-{high:.1})</td><td>{:.0}</td><td>{:.1}</td><td>{:.0}</td></tr>",
        escape(&r.config.to_string()),
        e(x.shape_rms),
        e(x.shape_max),
        d(x.outline_px, 2),
        100.0 * x.stretch[0],
        100.0 * x.stretch[1],
        100.0 * x.stretch[2],
        1e3 * x.star_rad,
        d(x.drift_per_s, 3),
        d(x.vertical_ms, 2),
        d(x.settled_ms, 0),
        d(x.depth, 3),
        r.cost.axis(),
        r.cost.factorisations,
        r.cost.bytes as f64 / 1024.0,
    );
}
