//! What a ribbon is asked to be, in SI, and what is refused.

use crate::scene::SpecError;

/// Which bending energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Bending {
    /// Sadowsky's: curvature is the same all along a ruling. The seed's.
    #[default]
    Sadowsky,
    /// Wunderlich's: rulings that spread or gather are paid for. The accurate one.
    Wunderlich,
}

/// How a segment's mass is spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mass {
    /// Over its area (Ribbon App. B).
    #[default]
    Consistent,
    /// On the centreline: a ribbon that spins about it does not notice (Ribbon Fig. 11).
    Lumped,
}

/// How positions between last step's vertices are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Resample {
    /// Cubic Hermite along each rim: no kink for the solver to stick at.
    #[default]
    Smooth,
    /// Straight between vertices, as the seed.
    Linear,
}

/// What holds the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Root {
    /// Position and tangent, bending from the clamp on: the half cell behind the first crease has its own hinge.
    #[default]
    Clamp,
    /// The first segment, rigidly, as the seed: bending starts a whole cell late.
    Segment,
    /// Nothing.
    Free,
}

/// Whether the end is joined to the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Closure {
    /// It is not.
    #[default]
    Open,
    /// Front to front.
    Ring,
    /// Front to back.
    Moebius,
}

/// One ribbon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RibbonSpec {
    /// Length, metres.
    pub length_m: f64,
    /// Width, metres.
    pub width_m: f64,
    /// Segments, 2 to the capacity of the ribbon.
    pub segments: usize,
    /// Flexural rigidity `D`, newton metres.
    pub rigidity_nm: f64,
    /// Grams per square metre.
    pub areal_mass_gsm: f64,
    /// `β̂`: how much a ruling of slope one costs, as a share of bending its crease by one radian.
    pub regularisation: f64,
    /// Rate at which velocities fade, per second.
    pub damping_per_s: f64,
    /// The energy.
    pub bending: Bending,
    /// The mass.
    pub mass: Mass,
    /// The interpolation.
    pub resample: Resample,
    /// What holds the start.
    pub root: Root,
    /// Whether it is a loop.
    pub closure: Closure,
    /// Largest random angle laid into each crease, radians: what a flat ribbon needs to notice a twist.
    pub perturbation: f64,
    /// Seed of those.
    pub seed: u64,
}

impl Default for RibbonSpec {
    fn default() -> Self {
        Self {
            length_m: 1.0,
            width_m: 0.05,
            segments: 50,
            rigidity_nm: 2.7e-4,
            areal_mass_gsm: 100.0,
            regularisation: 4e-3,
            damping_per_s: 0.0,
            bending: Bending::default(),
            mass: Mass::default(),
            resample: Resample::default(),
            root: Root::default(),
            closure: Closure::default(),
            perturbation: 1e-6,
            seed: 1,
        }
    }
}

impl RibbonSpec {
    /// Refuses what no ribbon of at most `most` segments could be.
    ///
    /// # Errors
    ///
    /// The first bad field.
    pub fn check(&self, most: usize) -> Result<(), SpecError> {
        within("ribbon.length_m", self.length_m, 1e-3, 1e3)?;
        within("ribbon.width_m", self.width_m, 1e-6 * self.length_m, self.length_m)?;
        within("ribbon.segments", self.segments as f64, 2.0, most as f64)?;
        within("ribbon.rigidity_nm", self.rigidity_nm, 1e-9, 1e6)?;
        within("ribbon.areal_mass_gsm", self.areal_mass_gsm, 1e-3, 1e6)?;
        within("ribbon.regularisation", self.regularisation, 1e-9, 1e3)?;
        within("ribbon.damping_per_s", self.damping_per_s, 0.0, 1e3)?;
        within("ribbon.perturbation", self.perturbation, 0.0, 1e-2)
    }
}

fn within(field: &'static str, value: f64, least: f64, greatest: f64) -> Result<(), SpecError> {
    if !value.is_finite() {
        return Err(SpecError::NotFinite(field));
    }
    if (least..=greatest).contains(&value) { Ok(()) } else { Err(SpecError::OutOfRange(field)) }
}
