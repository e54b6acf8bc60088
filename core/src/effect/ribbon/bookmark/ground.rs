//! What a bookmark lies on: table, boards, blocks and a leaf in the air, as the book is just now.

use super::curtain::Curtain;
use super::solid::{FAR, Prism};
use super::{CUSHION, SEGMENTS};
use crate::book::Book;
use crate::collision::Profile;
use crate::effect::ribbon::contact::Surface;
use crate::effect::ribbon::resample::Pair;
use crate::grid::Grid;
use crate::mesh::{OVERHANG_M, table_drop_m};
use crate::real::{Real, V2, V3};
use crate::scene::Cover;

/// So much further than the leaves go head and tail of what a ribbon hangs over, metres: between two of its vertices it
/// is straight and would cut the edge.
pub(super) const ROUNDED: f64 = 8e-4;
/// A ribbon between leaves lies so much below the leaf it lies on, metres: what is thicker than a leaf sinks in.
const SINKS: f64 = 3e-4;
/// The leaf's foot closes over a ribbon nearer than this to the head, metres.
const HEAD: f64 = 0.012;

/// Where the barrier becomes its parabola, as a share of its reach: leaves come down faster than a ribbon can be solved
/// for, and a harder push decides nothing but which of them gives up.
pub(super) const FLOOR: f64 = 0.15;
/// Table, boards, blocks and the leaf.
const SOLIDS: usize = 6;

/// Where a vertex was when it last looked around, and how far each solid was.
#[derive(Debug, Clone, Copy)]
struct Sight<R> {
    from: V3<R>,
    away: [R; SOLIDS],
}

/// Where a bookmark is among the leaves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layer {
    /// On the open spread, or beside the leaf in the air: on its left (true) or its right.
    Open(bool),
    /// Between leaves of the left (0) or right (1) block.
    Block(usize),
    /// Between the leaves that are held as one.
    Held,
}

impl Layer {
    /// Where a bookmark is that has `place` leaves on its left.
    pub fn of<R: Real, G: Grid>(book: &Book<R, G>, place: u32) -> Self {
        let binding = book.binding();
        let [left, right] = binding.leaves;
        let after = binding.all().saturating_sub(place);
        match (place.cmp(&left), after.cmp(&right)) {
            (core::cmp::Ordering::Less, _) => Self::Block(0),
            (_, core::cmp::Ordering::Less) => Self::Block(1),
            (core::cmp::Ordering::Equal, _) => Self::Open(true),
            (_, core::cmp::Ordering::Equal) => Self::Open(false),
            _ => Self::Held,
        }
    }
}

/// Everything solid around a bookmark.
#[derive(Debug, Clone)]
pub struct Ground<R: Real, G: Grid> {
    table: R,
    boards: [Prism<R>; 2],
    pub(super) blocks: [Prism<R>; 2],
    pub(super) leaf: Curtain<R, G>,
    pub(super) layer: Layer,
    sights: [Sight<R>; 2 * (SEGMENTS + 1)],
}

impl<R: Real, G: Grid> Ground<R, G> {
    /// Nothing.
    pub const NONE: Self = Self {
        table: R::ZERO,
        boards: [Prism::NONE; 2],
        blocks: [Prism::NONE; 2],
        leaf: Curtain::NONE,
        layer: Layer::Open(true),
        sights: [Sight { from: V3([R::ZERO; 3]), away: [R::ZERO; SOLIDS] }; 2 * (SEGMENTS + 1)],
    };

    /// Looks at a book, with `place` leaves on the bookmark's left.
    pub fn look(&mut self, book: &Book<R, G>, place: u32) {
        let metres = R::of(book.units().metres);
        let half_m = 0.5 * book.spec().height_m;
        let half = R::of(half_m + ROUNDED);
        self.layer = Layer::of(book, place);
        self.table = -R::of(table_drop_m(book.spec().cover));
        let binding = book.binding();
        for (n, (prism, sign)) in self.blocks.iter_mut().zip([-1.0, 1.0]).enumerate() {
            let (Some(strip), Some(&whole)) = (book.blocks().get(n), binding.leaves.get(n)) else {
                continue;
            };
            let own = if n == 0 { place } else { binding.all().saturating_sub(place) };
            let sinks = if self.layer == Layer::Block(n) { R::of(SINKS) / metres } else { R::ZERO };
            let above = binding.leaf * R::of(f64::from(whole.min(own)));
            let above = (above - sinks).larger(R::ZERO);
            let outline = Profile::new(strip, above).outline(above);
            *prism = Prism::new(outline.map(|p| p * metres), sign, half);
        }
        self.boards = [Prism::NONE; 2];
        if let Some(boards) = book.boards().filter(|_| book.spec().cover == Cover::Hard) {
            let half = R::of(half_m + OVERHANG_M + ROUNDED);
            for ((prism, strip), sign) in self.boards.iter_mut().zip(boards).zip([-1.0, 1.0]) {
                // The spine joins the boards.
                let [inner, outer] = strip.x;
                let corners = [V2([R::ZERO, inner.0[1]]), inner, outer];
                *prism = Prism::new(corners.map(|p| p * metres), sign, half);
            }
        }
        self.hang(book, metres, R::of(half_m));
    }

    fn hang(&mut self, book: &Book<R, G>, metres: R, half: R) {
        let side = match self.layer {
            Layer::Open(left) => {
                if left {
                    1.0
                } else {
                    -1.0
                }
            }
            Layer::Held => 1.0,
            Layer::Block(_) => 0.0,
        };
        match book.leaf() {
            Some(leaf) => self.leaf.hang(&leaf.x, metres, side, half, R::of(HEAD)),
            None => self.leaf.clear(),
        }
    }

    /// What lies still: the nearest, and its normal.
    pub fn still(&self, p: V3<R>) -> (R, V3<R>) {
        let mut best = (R::of(FAR), V3::zero());
        self.lying(p, |d, n| {
            if d < best.0 {
                best = (d, n);
            }
        });
        best
    }

    fn lying(&self, p: V3<R>, mut take: impl FnMut(R, V3<R>)) {
        for n in 0..SOLIDS - 1 {
            let (d, normal) = self.one(n, p);
            take(d, normal);
        }
    }

    /// Of one of the solids, the leaf last.
    fn one(&self, n: usize, p: V3<R>) -> (R, V3<R>) {
        let none = (R::of(FAR), V3::zero());
        match n {
            0 => (p.0[1] - self.table, V3([R::ZERO, R::one(), R::ZERO])),
            1..3 => self.boards.get(n - 1).map_or(none, |b| b.above(p)),
            3..5 => self.blocks.get(n - 3).map_or(none, |b| b.above(p)),
            _ if self.layer == Layer::Held => none,
            _ => self.leaf.solid(p, R::of(CUSHION.reach_m)).unwrap_or(none),
        }
    }

    /// Looks around from a ribbon's vertices: what is far is not looked at again before they have gone as far.
    pub fn sight(&mut self, pairs: impl Iterator<Item = Pair<R>>) {
        for (n, from) in pairs.flatten().enumerate() {
            let mut away = [R::ZERO; SOLIDS];
            for (n, away) in away.iter_mut().enumerate() {
                *away = if n + 1 < SOLIDS { self.one(n, from).0 } else { self.leaf.away(from) };
            }
            if let Some(sight) = self.sights.get_mut(n) {
                *sight = Sight { from, away };
            }
        }
    }
}

impl<R: Real, G: Grid> Surface<R> for Ground<R, G> {
    const HARD: bool = false;
    const FLOOR: f64 = FLOOR;

    fn above(&self, p: V3<R>) -> (R, V3<R>) {
        let still = self.still(p);
        let leaf = if self.layer == Layer::Held { None } else { self.leaf.above(p) };
        leaf.filter(|(d, _)| *d < still.0).unwrap_or(still)
    }
    fn each(&self, p: V3<R>, mut take: impl FnMut(R, V3<R>)) {
        for n in 0..SOLIDS {
            let (d, normal) = self.one(n, p);
            take(d, normal);
        }
    }
    fn each_of(&self, vertex: usize, p: V3<R>, mut take: impl FnMut(R, V3<R>)) {
        let Some(sight) = self.sights.get(vertex) else { return self.each(p, take) };
        let gone = (p - sight.from).norm() + R::of(CUSHION.reach_m);
        for (n, &away) in sight.away.iter().enumerate() {
            if away <= gone {
                let (d, normal) = self.one(n, p);
                take(d, normal);
            }
        }
    }
}
