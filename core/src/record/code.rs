//! One byte for each of a few named values.
//!
//! The bytes are part of the format: they may be added to, never renumbered. A value without a byte
//! does not compile.

use super::header::Tier;
use crate::hand::Phase;
use crate::scene::{Cover, Direction, Fidelity, Formulation, Pages};

/// A value that travels as one byte.
pub(crate) trait Coded: Copy + 'static {
    /// What an error calls it.
    const NAME: &'static str;
    /// Every value.
    const ALL: &'static [Self];
    /// Its byte.
    fn code(self) -> u8;
}

macro_rules! coded {
    ($type:ident, $name:literal, $($value:ident = $code:literal),+) => {
        impl $crate::record::code::Coded for $type {
            const NAME: &'static str = $name;
            const ALL: &'static [Self] = &[$($type::$value),+];
            fn code(self) -> u8 {
                match self {
                    $($type::$value => $code),+
                }
            }
        }
    };
}

#[cfg(feature = "ribbon")]
pub(crate) use coded;

coded!(Tier, "numeric tier", F32 = 4, F64 = 8);
coded!(Cover, "cover", Hard = 0, Soft = 1);
coded!(Direction, "reading direction", Ltr = 0, Rtl = 1);
coded!(Fidelity, "fidelity", Draft = 0, Standard = 1, Fine = 2, Reference = 3);
coded!(Formulation, "formulation", Condensed = 0, Seed = 1);
coded!(Pages, "pages", Spread = 0, Single = 1);
coded!(Phase, "pointer phase", Down = 0, Move = 1, Up = 2, Cancel = 3);

/// Whether something optional follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Presence {
    Absent,
    Present,
}

coded!(Presence, "presence of weights", Absent = 0, Present = 1);
