//! The leaf in whole numbers: what stands between the physics and everything that is drawn.

use dogleaf_core::Book;
use dogleaf_core::grid::G11x8;
use dogleaf_core::mesh::Surface;
use dogleaf_core::reading::{Face, faces};
use dogleaf_core::real::Real;
use dogleaf_core::scene::units::WIDTH;

/// Nodes from spine to fore-edge.
pub const ACROSS: usize = 11;
/// Nodes from tail to head.
pub const ALONG: usize = 8;
/// A page's width in the units of a pose.
pub const UNIT: i32 = 8_192;
/// Bytes of a pose that is written down.
pub const BYTES: usize = 6 * ACROSS * ALONG + 2;

/// Where the nodes of a leaf are.
///
/// # Shapes and units
///
/// `nodes[i][k]`, column by column from the spine, each tail to head; X, Y, Z of the book frame in 1/8192 of a page's
/// width, Y above the open page. Up to four widths away; what is further is brought there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pose {
    /// The nodes.
    pub nodes: [[[i16; 3]; ALONG]; ACROSS],
    /// It was taken from the right.
    pub from_right: bool,
}

/// Which printed page is seen where; none is blank.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Faces {
    /// Lying on the left.
    pub left: Option<u32>,
    /// Lying on the right.
    pub right: Option<u32>,
    /// The leaf's side that is seen while it lies on the right.
    pub up: Option<u32>,
    /// The other one.
    pub down: Option<u32>,
}

impl Pose {
    /// Nothing in particular: for the caller to place.
    pub const ZERO: Self = Self { nodes: [[[0; 3]; ALONG]; ACROSS], from_right: true };

    /// The leaf in the air; none if there is none.
    #[must_use]
    pub fn of<R: Real>(book: &Book<R, G11x8>) -> Option<Self> {
        let leaf = book.leaf()?;
        let binding = book.binding();
        let page = binding.thickness().map(|t| whole(t));
        let mut pose = Self { from_right: binding.from_right, ..Self::ZERO };
        for (i, column) in pose.nodes.iter_mut().enumerate() {
            for (k, node) in column.iter_mut().enumerate() {
                let [x, y, z] = leaf.x.at(i, k).0.map(|c| whole(c));
                *node = [narrow(x), narrow(y - beneath(x, page)), narrow(z)];
            }
        }
        Some(pose)
    }

    /// How far the leaf is over: 0 as it lay, 512 upright, 1024 on the other side.
    ///
    /// The fore-edge's mean place measured along a square about the spine, which needs no angle.
    #[must_use]
    pub fn progress(&self) -> u16 {
        let edge = self.nodes.last();
        let sum = |c: usize| {
            edge.map_or(0, |e| e.iter().map(|n| i32::from(n.get(c).copied().unwrap_or(0))).sum())
        };
        let (x, y): (i32, i32) = (sum(0), sum(1));
        let ahead = if self.from_right { x } else { -x };
        let y = y.max(0);
        let around = (ahead.abs() + y).max(1);
        // 0 ahead, 1 upright, 2 behind.
        let way = if ahead >= 0 { y * 512 / around } else { 1_024 - y * 512 / around };
        way.clamp(0, 1_024) as u16
    }

    /// Written down.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; BYTES] {
        let mut out = [0; BYTES];
        let numbers = self.nodes.as_flattened().as_flattened().iter();
        let side = i16::from(self.from_right);
        for (slot, n) in out.chunks_exact_mut(2).zip(numbers.chain([&side])) {
            slot.copy_from_slice(&n.to_le_bytes());
        }
        out
    }

    /// Read again; none if it was cut short.
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let bytes = bytes.get(..BYTES)?;
        let mut pose = Self::ZERO;
        let mut numbers = bytes.chunks_exact(2).map(|b| match b {
            [a, b] => i16::from_le_bytes([*a, *b]),
            _ => 0,
        });
        for slot in pose.nodes.as_flattened_mut().as_flattened_mut() {
            *slot = numbers.next()?;
        }
        pose.from_right = numbers.next()? != 0;
        Some(pose)
    }
}

impl Faces {
    /// What the surfaces of a book show now.
    #[must_use]
    pub fn of<R: Real>(book: &Book<R, G11x8>) -> Self {
        let page = |surface| match faces(book, surface, None, false) {
            Face::Page(n) if n < book.spec().pages => Some(n),
            _ => None,
        };
        Self {
            left: page(Surface::LeftTop),
            right: page(Surface::RightTop),
            up: page(Surface::LeafUp),
            down: page(Surface::LeafDown),
        }
    }
}

fn whole<R: Real>(c: R) -> i32 {
    (c.wide() * (f64::from(UNIT) / WIDTH)) as i32
}

/// The page a leaf would lie on at `x`: between the heights of both blocks near the spine.
fn beneath(x: i32, [left, right]: [i32; 2]) -> i32 {
    const RAMP: i32 = UNIT / 8;
    let side = x.clamp(-RAMP, RAMP);
    (left + right) / 2 + (right - left) * side / (2 * RAMP)
}

fn narrow(n: i32) -> i16 {
    n.clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16
}
