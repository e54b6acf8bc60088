//! From a simulated scene to an animation: shots, page pictures, materials, film.

mod band;
mod film;
mod look;
mod pages;
mod sheet;
mod shot;

pub(crate) use band::{BandShot, band_shot};
pub(crate) use film::Film;
pub(crate) use look::{Look, Set};
use pages::Faces;
pub(crate) use pages::{PageSource, Pages};
pub(crate) use sheet::sheet_shot;
use shot::Piece;
pub(crate) use shot::{Shot, book_indices, book_shot};
