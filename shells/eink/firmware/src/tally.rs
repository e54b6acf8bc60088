//! Least, mean, median and most of a list of counts.

/// Counts that are kept for the median.
const MOST: usize = 1024;

/// Counts of instructions, one a step.
#[derive(Debug, Clone)]
pub struct Tally {
    counts: [u32; MOST],
    length: usize,
    sum: u64,
    /// Counts that were too many to be kept.
    pub lost: u32,
}

impl Tally {
    /// Nothing counted.
    pub const EMPTY: Self = Self { counts: [0; MOST], length: 0, sum: 0, lost: 0 };

    /// Adds one count.
    pub fn add(&mut self, count: u32) {
        match self.counts.get_mut(self.length) {
            Some(place) => {
                *place = count;
                self.length += 1;
                self.sum += u64::from(count);
            }
            None => self.lost += 1,
        }
    }

    /// How many.
    pub fn length(&self) -> u32 {
        self.length as u32
    }

    /// Their mean.
    pub fn mean(&self) -> u32 {
        self.sum.checked_div(self.length as u64).unwrap_or(0) as u32
    }

    /// The largest.
    pub fn most(&self) -> u32 {
        self.kept().iter().fold(0, |most, &count| if count > most { count } else { most })
    }

    /// The middle one: the smallest count that at least half of them do not exceed.
    pub fn median(&self) -> u32 {
        let mut low = 0;
        let mut high = self.most();
        while low < high {
            let middle = low + (high - low) / 2;
            let below = self.kept().iter().filter(|&&count| count <= middle).count();
            if 2 * below >= self.length {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        low
    }

    fn kept(&self) -> &[u32] {
        self.counts.get(..self.length).unwrap_or(&[])
    }
}
