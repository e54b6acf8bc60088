//! The triangles that keep light from others.

use glam::{Vec2, Vec3};

use crate::patch::Patch;

/// Places and triangles of everything that casts a shadow.
#[derive(Debug, Default)]
pub(crate) struct Casters {
    pub(crate) points: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Casters {
    /// Collects the casting patches of a frame.
    pub(crate) fn gather(&mut self, patches: &[Patch<'_>]) {
        self.points.clear();
        self.triangles.clear();
        for patch in patches.iter().filter(|p| p.material.casts()) {
            let base = self.points.len() as u32;
            self.points.extend(patch.used().0.iter().map(|v| Vec3::from(v.position)));
            let sound = patch.triangles().flatten();
            self.triangles.extend(sound.map(|at| at.map(|i| base + i as u32)));
        }
    }

    /// The used points' extent along three axes: least and most.
    pub(crate) fn extent(&self, along: impl Fn(Vec3) -> Vec3) -> Option<(Vec3, Vec3)> {
        let used = self.triangles.iter().flatten().map(|&i| along(self.points[i as usize]));
        used.fold(None, |box_, p| {
            Some(box_.map_or((p, p), |(low, high): (Vec3, Vec3)| (low.min(p), high.max(p))))
        })
    }
}

/// Widens a range to a grid of a sixteenth of its size, so that a map fitted to it stays where it is
/// from frame to frame and its texels do not crawl while a leaf moves.
pub(crate) fn steady(low: Vec2, high: Vec2) -> (Vec2, Vec2) {
    let grid = |low: f32, high: f32| {
        let step = ((high - low).max(1e-5).log2().ceil() - 4.0).exp2();
        ((low / step).floor() * step, (high / step).ceil() * step)
    };
    let (x, y) = (grid(low.x, high.x), grid(low.y, high.y));
    (Vec2::new(x.0, y.0), Vec2::new(x.1, y.1))
}
