//! SI outside, model units inside: leaf width 12, leaf mass 1, seconds.
//!
//! With the leaf as the unit of size and mass, one set of numbers serves every book, and `f32` stays
//! in its best range.

/// Width of a leaf in model units. Source: Book Sec. 5.
pub const WIDTH: f64 = 12.0;

/// Scales between metres and kilograms and the model's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// Metres in one unit of length.
    pub metres: f64,
    /// Kilograms in one unit of mass: one leaf.
    pub kilograms: f64,
}

impl Units {
    /// Units of a leaf of given size and mass per area.
    pub fn of_leaf(width_m: f64, height_m: f64, areal_mass_gsm: f64) -> Self {
        Self { metres: width_m / WIDTH, kilograms: areal_mass_gsm * 1e-3 * width_m * height_m }
    }
    /// Metres to units; also m/s and m/s².
    pub fn length(&self, metres: f64) -> f64 {
        metres / self.metres
    }
    /// Units to metres; also m/s and m/s².
    pub fn to_metres(&self, units: f64) -> f64 {
        units * self.metres
    }
    /// Joules to units; also N m of a plate's rigidity, which is an energy.
    pub fn energy(&self, joules: f64) -> f64 {
        joules / (self.kilograms * self.metres * self.metres)
    }
    /// Units to joules.
    pub fn to_joules(&self, energy: f64) -> f64 {
        energy * self.kilograms * self.metres * self.metres
    }
    /// Kilograms to units.
    pub fn mass(&self, kilograms: f64) -> f64 {
        kilograms / self.kilograms
    }
    /// Units to kilograms.
    pub fn to_kilograms(&self, mass: f64) -> f64 {
        mass * self.kilograms
    }
}
