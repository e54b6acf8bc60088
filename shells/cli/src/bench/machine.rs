//! The machine and the build: a figure without them says nothing.

use serde::Serialize;
use std::time::{SystemTime, UNIX_EPOCH};

/// Where and how a figure was made.
#[derive(Debug, Serialize)]
pub(super) struct Machine {
    pub(super) cpu: String,
    pub(super) target: &'static str,
    /// What the compiler was allowed to use.
    pub(super) level: &'static str,
    pub(super) rustc: &'static str,
    pub(super) flags: &'static str,
    pub(super) opt_level: &'static str,
    /// UTC.
    pub(super) date: String,
}

pub(super) fn machine() -> Machine {
    Machine {
        cpu: cpu().unwrap_or_else(|| "unknown".into()),
        target: env!("DOGLEAF_TARGET"),
        level: level(),
        rustc: env!("DOGLEAF_RUSTC"),
        flags: env!("DOGLEAF_FLAGS"),
        opt_level: env!("DOGLEAF_OPT"),
        date: date(),
    }
}

fn level() -> &'static str {
    if !cfg!(target_arch = "x86_64") {
        std::env::consts::ARCH
    } else if cfg!(target_feature = "avx512f") {
        "x86-64-v4"
    } else if cfg!(target_feature = "avx2") {
        "x86-64-v3"
    } else {
        "x86-64 baseline"
    }
}

fn cpu() -> Option<String> {
    let info = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|l| l.starts_with("model name"))?;
    Some(crate::error::one_line(line.split_once(':')?.1))
}

fn date() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
    let [year, month, day] = civil(seconds / 86_400);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Year, month and day of a day counted from 1 January 1970, in the Gregorian calendar.
fn civil(day: u64) -> [u64; 3] {
    // Years here begin in March, so that the leap day is the last.
    let day = day + 719_468;
    let (era, of_era) = (day / 146_097, day % 146_097);
    let year = (of_era - of_era / 1_460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let date = of_year - (153 * month + 2) / 5 + 1;
    let (month, later) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    [era * 400 + year + later, month, date]
}

#[cfg(test)]
mod tests {
    use super::civil;

    #[test]
    fn days_have_dates() {
        for (day, wanted) in [
            (0, [1970, 1, 1]),
            (11_016, [2000, 2, 29]),
            (11_017, [2000, 3, 1]),
            (20_453, [2025, 12, 31]),
        ] {
            assert_eq!(civil(day), wanted, "day {day}");
        }
    }
}
