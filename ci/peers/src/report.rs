//! The comparison as text and as JSON.

use std::fmt::Write as _;

use crate::bench::{Figures, Row};
use crate::matrices::Matrices;

/// Aligned text for a reader. Ratios are against the first row.
pub(crate) fn table(set: &Matrices, rows: &[Row], repeats: usize) -> String {
    let (name, n, entries, count) = (set.name, set.n, set.entries(), set.count());
    let mut text = format!(
        "{}\n{name}: n = {n}, {entries} entries, {count} matrices x {repeats} repeats, medians in us\n\n",
        machine()
    );
    let head = ["factor", "solve", "total", "p95", "ratio", "entries", "error"]
        .map(|h| format!("{h:>10}"))
        .concat();
    let _ = writeln!(text, "{:<26}{head}", "");
    for row in rows {
        let _ = match &row.figures {
            Ok(f) => writeln!(text, "{:<26}{}", row.name, line(f, ratio(rows, f))),
            Err(why) => writeln!(text, "{:<26}    failed: {why}", row.name),
        };
    }
    text.truncate(text.trim_end().len());
    text
}

fn line(f: &Figures, ratio: f64) -> String {
    let times =
        [f.factor_us, f.solve_us, f.total_us, f.p95_us].map(|t| format!("{t:>10.1}")).concat();
    let entries = f.entries.map_or_else(|| "-".to_owned(), |e| e.to_string());
    let error = f.residual.map_or_else(|| "-".to_owned(), |r| format!("{r:.0e}"));
    format!("{times}{:>10}{entries:>10}{error:>10}", format!("{ratio:.1}x"))
}

/// The processor, as it calls itself; a figure without its machine says little.
fn machine() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = info.lines().find_map(|l| l.strip_prefix("model name")?.split_once(':'));
    line.map_or_else(
        || std::env::consts::ARCH.to_owned(),
        |(_, name)| name.trim().replace(['"', '\\'], ""),
    )
}

/// One object for a program. Names hold nothing that JSON would want escaped.
pub(crate) fn json(set: &Matrices, rows: &[Row], repeats: usize) -> String {
    let (name, n, entries, count) = (set.name, set.n, set.entries(), set.count());
    let rows: Vec<String> = rows.iter().map(|row| object(row, rows)).collect();
    let rows = rows.join(",");
    let machine = machine();
    let system =
        format!("\"system\":\"{name}\",\"n\":{n},\"entries\":{entries},\"matrices\":{count}");
    format!("{{\"machine\":\"{machine}\",{system},\"repeats\":{repeats},\"rows\":[{rows}]}}")
}

fn object(row: &Row, rows: &[Row]) -> String {
    let name = row.name;
    match &row.figures {
        Err(why) => format!("{{\"name\":\"{name}\",\"failed\":\"{why}\"}}"),
        Ok(f) => {
            let times = [
                ("factor_us", f.factor_us),
                ("solve_us", f.solve_us),
                ("total_us", f.total_us),
                ("p95_us", f.p95_us),
            ];
            let mut fields: Vec<String> =
                times.iter().map(|(key, t)| format!("\"{key}\":{t:.3}")).collect();
            let ratio = ratio(rows, f);
            // Only the baseline can fail to have one; NaN is no JSON.
            fields.extend(ratio.is_finite().then(|| format!("\"ratio\":{ratio:.3}")));
            fields.extend(f.entries.map(|e| format!("\"entries\":{e}")));
            fields.extend(f.residual.map(|r| format!("\"error\":{r:e}")));
            format!("{{\"name\":\"{name}\",{}}}", fields.join(","))
        }
    }
}

/// How many times faster than the first row.
fn ratio(rows: &[Row], one: &Figures) -> f64 {
    let first = rows.first().and_then(|r| r.figures.as_ref().ok());
    first.map_or(f64::NAN, |first| first.total_us / one.total_us)
}

#[cfg(test)]
mod tests {
    use super::{json, table};
    use crate::bench::{Figures, Row};
    use crate::matrices::Matrices;

    fn sample() -> (Matrices, Vec<Row>) {
        let set = Matrices {
            name: "one",
            n: 1,
            starts: vec![0, 1],
            rows: vec![0],
            values: vec![1.0],
            rhs: vec![1.0],
        };
        let figures = |total_us| Figures {
            factor_us: 1.0,
            solve_us: 2.0,
            total_us,
            p95_us: 4.0,
            entries: None,
            residual: Some(0.5),
        };
        let row = |name, total_us| Row { name, figures: Ok(figures(total_us)) };
        (
            set,
            vec![
                row("slow", 30.0),
                row("fast", 3.0),
                Row { name: "none", figures: Err("singular".into()) },
            ],
        )
    }

    #[test]
    fn ratios_are_against_the_first() {
        let (set, rows) = sample();
        let text = table(&set, &rows, 7);
        assert!(
            text.contains("10.0x") && text.contains("1.0x") && text.contains("failed: singular"),
            "{text}"
        );
    }

    #[test]
    fn json_is_one_object() {
        let (set, rows) = sample();
        let text = json(&set, &rows, 7);
        assert!(text.starts_with('{') && text.ends_with("]}"), "{text}");
        assert!(text.contains("\"ratio\":10.000,\"error\":5e-1}"), "{text}");
        assert!(text.contains("{\"name\":\"none\",\"failed\":\"singular\"}"), "{text}");
    }
}
