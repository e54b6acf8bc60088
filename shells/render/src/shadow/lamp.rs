//! Soft shadows of the lamp: percentage closer over the lamp's disc.
//!
//! The disc is replaced by a few points, each with its own depth map; the share of them that sees a
//! place is its light. That gives true penumbrae, sharp at the contact and wide further away, where
//! one map with a guessed filter width would let light leak in the gutter.

use glam::Vec3;

use super::casters::Casters;
use super::depth_map::{EMPTY, fill, passes};
use super::lamp_view::{POINTS, SIDE, TAPS, View};
use crate::light::PointLight;
use crate::parallel::for_each_part;

/// From this share of points that disagree on, the patches alone decide.
const CERTAIN: f32 = 0.16;

/// The lamp's maps for one frame.
#[derive(Debug, Default)]
pub(crate) struct Lamp {
    maps: Vec<f32>,
    view: View,
    empty: bool,
}

impl Lamp {
    /// Draws the maps.
    pub(crate) fn draw(&mut self, light: &PointLight, casters: &Casters, threads: usize) {
        let Some(view) = View::new(light, casters) else {
            self.empty = true;
            return;
        };
        self.empty = false;
        self.view = view;
        let places: Vec<Option<Vec3>> = casters.points.iter().map(|p| view.project(*p)).collect();
        self.maps.resize(POINTS * SIDE * SIDE, EMPTY);
        for_each_part(threads, &mut self.maps, SIDE * SIDE, |i, map| {
            map.fill(EMPTY);
            let seen = |k: u32| places[k as usize].map(|p| p + view.shift(i, p.z).extend(0.0));
            for &[a, b, c] in &casters.triangles {
                if let (Some(a), Some(b), Some(c)) = (seen(a), seen(b), seen(c)) {
                    fill(map, SIDE, [a, b, c]);
                }
            }
        });
    }

    /// Side of a texel near `p`, metres.
    pub(crate) fn texel_m(&self, p: Vec3) -> f32 {
        self.view.texel_m(p)
    }

    /// Share of the lamp that is seen from `p`, where anything within `slack_m` of it on the way
    /// to the lamp is not in the way.
    pub(crate) fn seen(&self, p: Vec3, slack_m: f32) -> f32 {
        if self.empty {
            return 1.0;
        }
        let Some(place) = self.view.project(p) else { return 1.0 };
        let near = 1.0 / (1.0 / place.z - slack_m).max(1e-4);
        let mut blockers = (0.0, 0.0);
        let mut sum = 0.0;
        for i in 0..POINTS {
            sum += self.ask(i, place, glam::Vec2::ZERO, |t| {
                let blocks = t > near;
                blockers = if blocks { (blockers.0 + t, blockers.1 + 1.0) } else { blockers };
                if blocks { 0.0 } else { 1.0 }
            });
        }
        let share = sum / POINTS as f32;
        let certain = (share.min(1.0 - share) / CERTAIN).min(1.0);
        if certain <= 0.0 {
            return share;
        }
        let share = share + (self.penumbra(place, near, blockers.0 / blockers.1) - share) * certain;
        // The first and the last point would each draw a line along the penumbra's ends.
        share * share * (3.0 - 2.0 * share)
    }

    /// The share where the disc is seen in part by way of something of nearness `blocker`.
    ///
    /// Each point speaks for a patch of the disc. Seen past the blocker, moving the point within its
    /// patch moves the shadow; so its map is asked at several places as far apart as that, and
    /// the points' own steps do not show in a wide penumbra.
    fn penumbra(&self, place: Vec3, near: f32, blocker: f32) -> f32 {
        let spread = self.view.spread(near, blocker);
        let mut sum = 0.0;
        for i in 0..POINTS {
            for tap in &self.view.taps[i] {
                sum += self.ask(i, place, *tap * spread, |t| if t > near { 0.0 } else { 1.0 });
            }
        }
        sum / (POINTS * TAPS) as f32
    }

    fn ask(&self, i: usize, place: Vec3, aside: glam::Vec2, open: impl FnMut(f32) -> f32) -> f32 {
        let at = place.truncate() + self.view.shift(i, place.z) + aside;
        passes::<SIDE, { SIDE + 2 }>(&self.maps[i * SIDE * SIDE..(i + 1) * SIDE * SIDE], at, open)
    }
}
