//! What a step cost and how well it went.

/// How a step ended. A bad number is a status, never a panic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StepStatus {
    /// Nothing moved and nothing had to: no work was done.
    #[default]
    Asleep,
    /// The full Newton step was taken.
    Converged,
    /// The line search took a shorter step.
    Reduced,
    /// No trial improved the merit; the pose was kept, its velocity dropped.
    Stalled,
    /// Numbers became non-finite; the last good pose was kept, its velocity dropped.
    Held,
    /// An edge left the band a sheet of paper can be in; the last good pose was kept.
    Recovered,
}

impl StepStatus {
    /// The worse of two: what a frame of several steps reports.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        if (self as u8) < (other as u8) { other } else { self }
    }
    /// The pose was not moved.
    pub fn failed(self) -> bool {
        matches!(self, Self::Stalled | Self::Held | Self::Recovered)
    }
    /// Lower-case name, as it stands in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Asleep => "asleep",
            Self::Converged => "converged",
            Self::Reduced => "reduced",
            Self::Stalled => "stalled",
            Self::Held => "held",
            Self::Recovered => "recovered",
        }
    }
}

/// Counts of one step, or summed over a frame. Nothing is hidden.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StepReport {
    /// The worst status.
    pub status: StepStatus,
    /// Internal steps taken.
    pub steps: u32,
    /// Newton steps, that is factorisations of the leaf's matrix.
    pub newton_steps: u32,
    /// Line-search trials beyond the first.
    pub cuts: u32,
    /// Pivots that had to be replaced.
    pub regularised: u32,
    /// Collision passes.
    pub passes: u32,
    /// Nodes those passes moved.
    pub pushed: u32,
    /// Times the hand's target was clamped into reach.
    pub clamped: u32,
    /// Small solves of the page blocks and the cover.
    pub chain_solves: u32,
    /// Times something that would not come to rest by itself was put to rest.
    pub forced_rests: u32,
    /// Steps that strained the sheet too much and were taken again in four parts.
    pub parted: u32,
    /// Times a balanced leaf was nudged off its edge.
    pub nudged: u32,
    /// Input samples that were refused.
    pub refused: u32,
}

impl StepReport {
    /// Adds another step's counts; keeps the worse status.
    pub fn add(&mut self, o: &Self) {
        self.status = self.status.worse(o.status);
        self.steps = self.steps.saturating_add(o.steps);
        self.newton_steps = self.newton_steps.saturating_add(o.newton_steps);
        self.cuts = self.cuts.saturating_add(o.cuts);
        self.regularised = self.regularised.saturating_add(o.regularised);
        self.passes = self.passes.saturating_add(o.passes);
        self.pushed = self.pushed.saturating_add(o.pushed);
        self.clamped = self.clamped.saturating_add(o.clamped);
        self.chain_solves = self.chain_solves.saturating_add(o.chain_solves);
        self.forced_rests = self.forced_rests.saturating_add(o.forced_rests);
        self.parted = self.parted.saturating_add(o.parted);
        self.nudged = self.nudged.saturating_add(o.nudged);
        self.refused = self.refused.saturating_add(o.refused);
    }
}
