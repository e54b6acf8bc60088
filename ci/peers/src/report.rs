//! The comparison as text and as JSON.

use std::fmt::Write as _;

use crate::bench::{Figures, Row};
use crate::machine;
use crate::matrices::Matrices;

/// Aligned text for a reader. Ratios are against the first row.
pub(crate) fn table(set: &Matrices, rows: &[Row], repeats: usize) -> String {
    let (name, n, entries, count) = (set.name, set.n, set.entries(), set.count());
    let mut text = format!(
        "{} ({}), compiled for {}\n{name}: n = {n}, {entries} entries, {count} matrices x {repeats} repeats, medians in us\n\n",
        machine::name(),
        machine::flags(),
        machine::target(),
    );
    let head = ["factor", "solve", "total", "p95", "ratio", "entries", "error"]
        .map(|h| format!("{h:>10}"))
        .concat();
    let _ = writeln!(text, "{:<28}{head}", "");
    for row in rows {
        let _ = match &row.figures {
            Ok(f) => writeln!(text, "{:<28}{}", row.name, line(f, ratio(rows, f))),
            Err(why) => writeln!(text, "{:<28}    failed: {why}", row.name),
        };
    }
    for (row, wanted) in promised(rows) {
        let word = if passes(rows, row, wanted) { "pass" } else { "FAIL" };
        let _ = write!(text, "\n{}: at least {wanted}x: {word}", row.name);
    }
    text.truncate(text.trim_end().len());
    text
}

/// Whether every promise is kept. Who failed keeps none.
pub(crate) fn kept(rows: &[Row]) -> bool {
    promised(rows).all(|(row, wanted)| passes(rows, row, wanted))
}

fn promised(rows: &[Row]) -> impl Iterator<Item = (&Row, f64)> {
    rows.iter().filter_map(|row| Some((row, row.wanted?)))
}

fn passes(rows: &[Row], row: &Row, wanted: f64) -> bool {
    row.figures.as_ref().is_ok_and(|f| ratio(rows, f) >= wanted)
}

fn line(f: &Figures, ratio: f64) -> String {
    let times = [f.factor_us, f.solve_us, Some(f.total_us), Some(f.p95_us)]
        .map(|t| t.map_or_else(|| format!("{:>10}", "-"), |t| format!("{t:>10.1}")))
        .concat();
    let entries = f.entries.map_or_else(|| "-".to_owned(), |e| e.to_string());
    let error = f.residual.map_or_else(|| "-".to_owned(), |r| format!("{r:.0e}"));
    format!("{times}{:>10}{entries:>10}{error:>10}", format!("{ratio:.1}x"))
}

/// One object for a program. Names hold nothing that JSON would want escaped.
pub(crate) fn json(set: &Matrices, rows: &[Row], repeats: usize) -> String {
    let (name, n, entries, count) = (set.name, set.n, set.entries(), set.count());
    let pass = kept(rows);
    let rows: Vec<String> = rows.iter().map(|row| object(row, rows)).collect();
    let rows = rows.join(",");
    let machine = format!(
        "\"machine\":\"{}\",\"flags\":\"{}\",\"target\":\"{}\"",
        machine::name(),
        machine::flags(),
        machine::target()
    );
    let system =
        format!("\"system\":\"{name}\",\"n\":{n},\"entries\":{entries},\"matrices\":{count}");
    format!("{{{machine},{system},\"repeats\":{repeats},\"pass\":{pass},\"rows\":[{rows}]}}")
}

fn object(row: &Row, rows: &[Row]) -> String {
    let name = row.name;
    match &row.figures {
        Err(why) => format!("{{\"name\":\"{name}\",\"failed\":\"{why}\"}}"),
        Ok(f) => {
            let times = [
                ("factor_us", f.factor_us),
                ("solve_us", f.solve_us),
                ("total_us", Some(f.total_us)),
                ("p95_us", Some(f.p95_us)),
            ];
            let told = |(key, t): (&str, Option<f64>)| Some(format!("\"{key}\":{:.3}", t?));
            let mut fields: Vec<String> = times.into_iter().filter_map(told).collect();
            let ratio = ratio(rows, f);
            // Only the baseline can fail to have one; NaN is no JSON.
            fields.extend(ratio.is_finite().then(|| format!("\"ratio\":{ratio:.3}")));
            fields.extend(row.wanted.map(|w| format!("\"wanted\":{w:.3}")));
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
    use super::{json, kept, table};
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
            factor_us: Some(1.0),
            solve_us: None,
            total_us,
            p95_us: 4.0,
            entries: None,
            residual: Some(0.5),
        };
        let row = |name, total_us| Row { name, figures: Ok(figures(total_us)), wanted: None };
        (
            set,
            vec![
                row("slow", 30.0),
                row("fast", 3.0),
                Row { name: "none", figures: Err("singular".into()), wanted: None },
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

    #[test]
    fn promises_are_kept_or_not() {
        let (set, mut rows) = sample();
        assert!(kept(&rows), "nothing was promised");
        for (at, wanted, good) in [(1, 10.0, true), (1, 10.1, false), (2, 0.0, false)] {
            rows.iter_mut().for_each(|row| row.wanted = None);
            rows[at].wanted = Some(wanted);
            let (text, word) = (table(&set, &rows, 7), if good { "pass" } else { "FAIL" });
            assert!(kept(&rows) == good && text.ends_with(word), "{text}");
            assert!(json(&set, &rows, 7).contains(&format!("\"pass\":{good}")), "{wanted}");
        }
    }
}
