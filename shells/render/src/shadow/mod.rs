//! What stands between a point and the light: depth maps for the lamp and for the sky.

mod casters;
mod depth_map;
mod lamp;
mod lamp_view;
mod sky;

pub(crate) use casters::Casters;
pub(crate) use lamp::Lamp;
pub(crate) use sky::{Place, Sky, SkyShare};
