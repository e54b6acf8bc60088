//! Rounds of times, and the figures told of them.

use serde::Serialize;

/// Least median and least 95th and 99th percentile of all rounds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Figures {
    pub(crate) median: f64,
    pub(crate) p95: f64,
    pub(crate) p99: f64,
}

/// Figures over rounds.
#[derive(Debug, Clone, Default)]
pub(super) struct Times(Option<Figures>);

impl Times {
    /// Takes one round's times.
    pub(super) fn round(&mut self, times: &[f64]) {
        let new = figures(times);
        let least = self.0.map_or(new, |old| Figures {
            median: old.median.min(new.median),
            p95: old.p95.min(new.p95),
            p99: old.p99.min(new.p99),
        });
        self.0 = Some(least);
    }

    pub(super) fn figures(&self) -> Figures {
        self.0.unwrap_or_else(|| figures(&[]))
    }
}

/// Percentiles of one set of times.
pub(crate) fn figures(times: &[f64]) -> Figures {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| {
        let n = (share * sorted.len() as f64) as usize;
        sorted.get(n.min(sorted.len().saturating_sub(1))).copied().unwrap_or(0.0)
    };
    Figures { median: at(0.5), p95: at(0.95), p99: at(0.99) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_of_a_hundred() {
        let times: Vec<f64> = (0..100).rev().map(f64::from).collect();
        assert_eq!(figures(&times), Figures { median: 50.0, p95: 95.0, p99: 99.0 }, "of 0..100");
        assert_eq!(figures(&[]).median, 0.0, "of nothing");
    }

    #[test]
    fn the_least_round_counts() {
        let mut times = Times::default();
        times.round(&[5.0]);
        times.round(&[3.0]);
        times.round(&[4.0]);
        assert_eq!(times.figures().median, 3.0, "least of three");
    }
}
