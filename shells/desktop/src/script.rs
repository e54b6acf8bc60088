//! A recorded gesture on its way into a book.

use crate::view::BookView;
use dogleaf_core::hand::Sample;

/// Samples that are played in their own time.
#[derive(Debug, Default)]
pub struct Script {
    samples: Vec<Sample>,
    next: usize,
    /// The host's time when the first call came.
    start_us: Option<u64>,
}

impl Script {
    /// A gesture that begins with the first call of [`Script::feed`].
    #[must_use]
    pub fn new(samples: Vec<Sample>) -> Self {
        Self { samples, next: 0, start_us: None }
    }

    /// The same gesture in a picture of another size.
    #[must_use]
    pub fn scaled(mut self, from: [u32; 2], to: [u32; 2]) -> Self {
        let scaled = |v: i32, i: usize| {
            let [from, to] = [from, to].map(|size| i64::from(size[i].max(1)));
            (i64::from(v) * to / from).clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
        };
        for sample in &mut self.samples {
            (sample.x, sample.y) = (scaled(sample.x, 0), scaled(sample.y, 1));
        }
        self
    }

    /// Hands over all that is due.
    pub fn feed(&mut self, now_us: u64, view: &mut BookView) {
        let start = *self.start_us.get_or_insert(now_us);
        let due = |s: &&Sample| s.t_us <= now_us.saturating_sub(start);
        while let Some(sample) = self.samples.get(self.next).filter(due) {
            view.pointer(Sample { t_us: start.saturating_add(sample.t_us), ..*sample });
            self.next += 1;
        }
    }

    /// Whether all was handed over.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.next >= self.samples.len()
    }
}
