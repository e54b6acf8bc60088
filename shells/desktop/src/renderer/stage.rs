//! What stands around the book and does not move: the eye, the lamp, the table.

use dogleaf_core::hand::View;
use dogleaf_core::mesh::{OVERHANG_M, Vertex, table_drop_m};
use dogleaf_core::record::Setup;
use dogleaf_core::scene::Cover;
use glam::{Mat4, Vec3, Vec4};

/// Distance of the near plane, metres.
const NEAR_M: f32 = 0.01;
/// Distance of the far plane, metres: beyond the table's far corner.
const FAR_M: f32 = 40.0;
/// Half a side of the table, metres.
const TABLE_M: f32 = 3.0;
/// Gap between the table and what lies on it, metres: none of them shall show through the other.
const GAP_M: f32 = 1e-4;
/// What the sphere of casters is wider than a page on either side.
const SLACK: f64 = 1.04;

/// A lamp, seen as a small disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lamp {
    /// Its centre, metres.
    pub position: [f32; 3],
    /// Light in every direction, linear.
    pub colour: [f32; 3],
    /// Radius of the disc, metres.
    pub radius_m: f32,
}

impl Lamp {
    /// Warm, above the window on the far left: the lamp of the software renderer.
    pub const READING: Self = Self {
        position: [-0.33, 0.66, -0.30],
        colour: [1.15, 1.15 * 0.93, 1.15 * 0.83],
        radius_m: 0.065,
    };
}

/// Where the book is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    /// From where, and in how many pixels.
    pub view: View,
    /// What lights it beside the room.
    pub lamp: Lamp,
    /// Whether there are boards below the leaves.
    pub cover: Cover,
    /// Thickness of a leaf, metres.
    pub leaf_m: f32,
    /// Radius of a sphere about the binding that holds the book however it is opened, metres.
    pub radius_m: f32,
}

impl Stage {
    /// The stage of a book.
    #[must_use]
    pub fn of(setup: &Setup) -> Self {
        let book = &setup.book;
        let leaf = setup.paper.thickness_mm * 1e-3;
        let page = (book.width_m + OVERHANG_M).hypot(0.5 * book.height_m + OVERHANG_M);
        let radius = SLACK * page.hypot(f64::from(book.leaves()) * leaf);
        Self {
            view: setup.view,
            lamp: Lamp::READING,
            cover: book.cover,
            leaf_m: leaf as f32,
            radius_m: radius as f32,
        }
    }

    /// Where the eye is, metres.
    pub(super) fn eye(&self) -> [f32; 3] {
        self.view.eye_m.map(|c| c as f32)
    }

    /// From the book's frame to the picture, column by column.
    pub(super) fn clip_from_world(&self) -> [f32; 16] {
        let View { target_m, fov_y_deg, width_px, height_px, .. } = self.view;
        let (eye, target) = (Vec3::from(self.eye()), Vec3::from(target_m.map(|c| c as f32)));
        let ahead = (target - eye).normalize();
        // As the core's camera: the picture's up leans towards the head of the page.
        let right = ahead.cross(Vec3::new(0.0, 1.0, -1e-3)).normalize();
        let up = right.cross(ahead);
        let aspect = width_px.max(1) as f32 / height_px.max(1) as f32;
        let zoom = 1.0 / (0.5 * fov_y_deg.to_radians() as f32).tan();
        let depth = [(FAR_M + NEAR_M) / (FAR_M - NEAR_M), -2.0 * FAR_M * NEAR_M / (FAR_M - NEAR_M)];
        let row = |axis: Vec3| axis.extend(-axis.dot(eye));
        let away = row(ahead);
        let depths = away * depth[0] + Vec4::new(0.0, 0.0, 0.0, depth[1]);
        let across = row(right * (zoom / aspect));
        Mat4::from_rows(across, row(up * zoom), depths, away).to_cols_array()
    }

    /// Side of a pixel one metre away, metres.
    pub(super) fn pixel_at_one_metre(&self) -> f32 {
        let half = 0.5 * self.view.fov_y_deg.to_radians();
        (2.0 * half.tan() / f64::from(self.view.height_px.max(1))) as f32
    }

    /// The corners of the table.
    pub(super) fn table(&self) -> [Vertex; 4] {
        let (r, y) = (TABLE_M, -(table_drop_m(self.cover) as f32) - GAP_M);
        [[-r, -r], [-r, r], [r, r], [r, -r]].map(|[x, z]| Vertex {
            position: [x, y, z],
            normal: [0.0, 1.0, 0.0],
            uv: [0.5 + 0.5 * x / r, 0.5 + 0.5 * z / r],
        })
    }
}
