//! The report for a terminal.

use crate::report::{Report, Row, SceneReport};
use std::fmt::Write;

/// Rows of a scene that are shown; the page has them all.
const MOST: usize = 24;

impl Report {
    /// Aligned text.
    pub fn text(&self) -> String {
        let mut t =
            format!("dogleaf cost {} on {}\ncost: {}\n", self.dogleaf, self.machine, self.unit);
        self.scenes.iter().for_each(|s| scene(&mut t, s));
        self.parts(&mut t);
        t
    }

    fn parts(&self, t: &mut String) {
        if !self.presets.is_empty() {
            let _ = writeln!(t, "\npresets on the turn at 11x8");
        }
        for p in &self.presets {
            let beaten =
                p.beaten_by.as_deref().map_or_else(String::new, |b| format!("  beaten by {b}"));
            let on = if p.front { "on the front" } else { "NOT on it" };
            let _ = writeln!(
                t,
                "  {:10} {:24} error {:.2e}  cost {:>9.0}  {on}{beaten}",
                p.name, p.config, p.error, p.cost
            );
        }
        if !self.grids.is_empty() {
            let _ = writeln!(
                t,
                "\ngrid    error in space   droop error % at gamma 1, 10, 30   us a step"
            );
        }
        for g in &self.grids {
            let space = g.space_rms.map_or_else(|| "-".into(), |e| format!("{e:.2e}"));
            let droop: String = g.droop.iter().map(|d| format!("{:8.2}", 100.0 * d[1])).collect();
            let _ = writeln!(t, "{:6} {space:>15}   {droop}   {:>22.1}", g.grid, g.step_us);
        }
        let _ = writeln!(t);
        for o in &self.orders {
            let _ = writeln!(t, "order {:.2} (at least {}): {}", o.order, o.least, o.what);
        }
        let _ = writeln!(t, "\nclaims of the seed: claimed | rebuilt | ours");
        for c in &self.claims {
            let _ = writeln!(t, "  {}: {} | {} | {}", c.what, c.seed, c.rebuilt, c.ours);
        }
        let _ = writeln!(t, "\nomissions");
        self.omissions.iter().for_each(|o| {
            let _ = writeln!(t, "  {o}");
        });
    }
}

fn scene(t: &mut String, scene: &SceneReport) {
    let _ = writeln!(t, "\n{}: {}", scene.name, scene.about);
    for k in &scene.known {
        let word = if k.converged { "converged" } else { "reference not converged" };
        let _ = writeln!(
            t,
            "  {}: references agree to {:.1e}, smallest error {:.1e}: {word}",
            k.what, k.agreement, k.smallest
        );
    }
    let fronts = scene.rows.iter().any(|r| r.front);
    let worth = |r: &&Row| !fronts || r.front || !r.presets.is_empty();
    let mut rows: Vec<&Row> = scene.rows.iter().filter(worth).collect();
    rows.sort_by(|a, b| a.cost.frame_us.total_cmp(&b.cost.frame_us));
    let _ = writeln!(
        t,
        "  {:34} {:>9} {:>9} {:>7} {:>7} {:>8} {:>8} {:>9} {:>9}",
        "configuration", "RMS", "max", "px", "str %", "vert ms", "rest ms", "us", "instr"
    );
    rows.iter().take(MOST).for_each(|r| row(t, r));
    let more = scene.rows.len() - rows.len().min(MOST);
    let _ = writeln!(t, "  and {more} more in the report");
}

fn row(t: &mut String, r: &Row) {
    let e = |v: Option<f64>| v.map_or_else(|| "-".into(), |v| format!("{v:.2e}"));
    let d = |v: Option<f64>| v.map_or_else(|| "-".into(), |v| format!("{v:.1}"));
    let names =
        if r.presets.is_empty() { String::new() } else { format!("  = {}", r.presets.join(", ")) };
    let _ = writeln!(
        t,
        "  {:34} {:>9} {:>9} {:>7} {:>7.2} {:>8} {:>8} {:>9.1} {:>9}{names}",
        r.config.to_string(),
        e(r.errors.shape_rms),
        e(r.errors.shape_max),
        d(r.errors.outline_px),
        100.0 * r.errors.stretch[0],
        d(r.errors.vertical_ms),
        d(r.errors.settled_ms),
        r.cost.frame_us,
        r.cost.frame_instructions.map_or_else(|| "-".into(), |n| format!("{n:.0}")),
    );
}
