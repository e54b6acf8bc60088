//! What lights the book: a pre-integrated room and one lamp.

use glam::Vec3;

use crate::environment::Environment;

/// A lamp. It is seen as a small disc, so that its shadows are sharp at the contact and soft
/// further away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointLight {
    /// Centre of the lamp, metres.
    pub position: Vec3,
    /// Light sent in every direction, linear RGB; a white surface at distance `d` metres facing the
    /// lamp then shines with `colour / (π d²)`, where 1 is the picture's white.
    pub colour: Vec3,
    /// Radius of the disc, metres; 0 gives hard shadows.
    pub radius_m: f32,
}

/// All light of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lights {
    /// The room around.
    pub environment: Environment,
    /// The lamp.
    pub point: PointLight,
}

impl Lights {
    /// A calm room with a window on the far left and a warm lamp above it; right for a book that
    /// lies around the origin and is a few decimetres wide.
    #[must_use]
    pub fn reading_room() -> Self {
        Self {
            environment: Environment::reading_room(),
            point: PointLight {
                position: Vec3::new(-0.33, 0.66, -0.30),
                colour: Vec3::new(1.0, 0.93, 0.83) * 1.15,
                radius_m: 0.065,
            },
        }
    }
}
