//! Why a spec is refused.

use core::fmt;

/// Why a spec is refused, and which field is at fault. No state was made or changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SpecError {
    /// The named field is NaN or infinite.
    NotFinite(&'static str),
    /// The named field is below its least or above its greatest value.
    OutOfRange(&'static str),
}

impl fmt::Display for SpecError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(field) => write!(f, "{field} is not a finite number"),
            Self::OutOfRange(field) => write!(f, "{field} is out of range"),
        }
    }
}

impl core::error::Error for SpecError {}

/// `value` within `least..=greatest`, or the error that names it.
pub(super) fn within(
    field: &'static str,
    value: f64,
    least: f64,
    greatest: f64,
) -> Result<(), SpecError> {
    if !value.is_finite() {
        return Err(SpecError::NotFinite(field));
    }
    if (least..=greatest).contains(&value) { Ok(()) } else { Err(SpecError::OutOfRange(field)) }
}
