//! What holds a bookmark where it lies: the leaves it is pressed between, and a page that lets it slide but slowly.

use super::CUSHION;
use super::ground::{FLOOR, Ground, Layer};
use crate::effect::ribbon::Loads;
use crate::effect::ribbon::contact::push::barrier;
use crate::effect::ribbon::load::Pull;
use crate::effect::ribbon::resample::Pair;
use crate::grid::Grid;
use crate::real::{Real, V3};

/// How hard a page holds a ribbon that lies on it, in inertias of a vertex: so little gives a vertex way before it slips
/// that it does not show.
const GRIP: f64 = 3.0;
/// How hard leaves hold one between them along themselves, and across, in the same.
const PRESSED: [f64; 2] = [100.0, 300.0];

/// So near an edge leaves give, metres.
const GIVES: f64 = 8e-3;

/// `½ (x - a)ᵀ (g (I - n nᵀ) + p n nᵀ) (x - a)` at one vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Grip<R> {
    anchor: V3<R>,
    /// The first is `n`.
    axes: [V3<R>; 3],
    /// Across, along, along; newton per metre.
    weights: [R; 3],
    /// There is paper on both its sides.
    covered: bool,
}

/// What all grips of a step have in common.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching<R> {
    /// A vertex' mass by the time step squared, newton per metre.
    pub(super) inertia: R,
    /// How near the ground it lies, metres.
    pub(super) reach: R,
    /// Coefficient of friction.
    pub(super) friction: R,
}

/// One for each vertex of a ribbon of `N` segments.
#[derive(Debug, Clone)]
pub(super) struct Hold<R, const N: usize> {
    grips: [[Option<Grip<R>>; 2]; N],
    end: [Option<Grip<R>>; 2],
}

impl<R: Real, const N: usize> Hold<R, N> {
    pub(super) const NONE: Self = Self { grips: [[None; 2]; N], end: [None; 2] };

    /// Finds what holds the vertices as they are, given what held them before.
    pub(super) fn find<G: Grid>(
        &mut self,
        ground: &Ground<R, G>,
        pairs: impl Iterator<Item = Pair<R>>,
        touching: &Touching<R>,
    ) -> u32 {
        let places = self.grips.iter_mut().chain(core::iter::once(&mut self.end));
        let mut pressed = 0;
        fill(places, pairs, |x, before| {
            let (grip, inside) = grip(ground, x, before, touching);
            pressed += u32::from(inside);
            grip
        });
        pressed
    }

    /// Forgets where it lay.
    pub(super) fn forget(&mut self) {
        *self = Self::NONE;
    }

    /// Both vertices of a crease have paper on both their sides.
    pub(super) fn pressed(&self, crease: usize) -> bool {
        self.at(crease).iter().all(|g| g.is_some_and(|g| g.covered))
    }

    /// Where it is held: a part of its state, for a page holds it where it came to lie.
    pub(super) fn anchors(&self) -> impl Iterator<Item = V3<R>> {
        let places = self.grips.iter().chain(core::iter::once(&self.end));
        places.flatten().flatten().map(|g| g.anchor)
    }

    fn at(&self, crease: usize) -> &[Option<Grip<R>>; 2] {
        self.grips.get(crease).unwrap_or(&self.end)
    }
}

fn fill<'a, R: Real>(
    places: impl Iterator<Item = &'a mut [Option<Grip<R>>; 2]>,
    pairs: impl Iterator<Item = Pair<R>>,
    mut of: impl FnMut(V3<R>, &Option<Grip<R>>) -> Option<Grip<R>>,
) {
    let mut pairs = pairs.fuse();
    for place in places {
        let [a, b] = &*place;
        *place = pairs.next().map_or([None; 2], |[x, y]| [of(x, a), of(y, b)]);
    }
}

/// What holds a vertex, and whether it is between leaves.
fn grip<R: Real, G: Grid>(
    ground: &Ground<R, G>,
    x: V3<R>,
    before: &Option<Grip<R>>,
    touching: &Touching<R>,
) -> (Option<Grip<R>>, bool) {
    let &Touching { inertia, reach, .. } = touching;
    let pressed = PRESSED.map(|w| inertia * R::of(w));
    if let Some((d, n, share)) = between(ground, x) {
        let pressed = pressed.map(|w| w * share);
        return (Some(held(x - n * (d - reach * R::of(0.5)), n, pressed, true)), true);
    }
    let near = reach * R::of(1.5);
    let (d, n) = ground.still(x);
    // A leaf that has come down on it: what it lies on is on the other side.
    let leaf = ground.leaf.above(x).filter(|&(off, m)| off < near && m.dot(n) < R::ZERO);
    let covered = d < near && leaf.is_some();
    if covered {
        return (Some(held(x, n, [pressed[0], R::ZERO], true)), true);
    }
    let lies = d < near && touching.friction > R::ZERO;
    (lies.then(|| lying(x, (d, n), before, touching)), false)
}

/// What holds a vertex that lies on a page: it sticks to where it came to lie, as far as friction reaches; beyond, that
/// place comes after it.
fn lying<R: Real>(
    x: V3<R>,
    (d, n): (R, V3<R>),
    before: &Option<Grip<R>>,
    touching: &Touching<R>,
) -> Grip<R> {
    let weight = touching.inertia * R::of(GRIP);
    let [_, slope, _] = barrier(&CUSHION, d, FLOOR);
    let most = touching.friction * -slope / weight;
    let off = before.as_ref().filter(|g| !g.covered).map_or(V3::zero(), |g| x - g.anchor);
    let off = off - n * off.dot(n);
    let gone = off.norm();
    let off = if gone > most { off * (most / gone) } else { off };
    held(x - off, n, [weight, R::ZERO], false)
}

/// Distance to the layer of leaves a vertex is pressed between, and the share of the press: near an edge it gives, or a
/// vertex there would be taken and let go by turns.
fn between<R: Real, G: Grid>(ground: &Ground<R, G>, x: V3<R>) -> Option<(R, V3<R>, R)> {
    match ground.layer {
        Layer::Open(_) => None,
        Layer::Held => ground.leaf.above(x).map(|(d, n)| (d, n, R::one())),
        Layer::Block(side) => {
            let block = ground.blocks.get(side)?;
            let within = block.within(x);
            let foot = block.foot(x).filter(|_| within > R::ZERO)?;
            let share = (within * R::of(1.0 / GIVES)).smaller(R::one());
            let share = share * share;
            Some((foot.distance, block.turned(foot.normal), share))
        }
    }
}

fn held<R: Real>(anchor: V3<R>, n: V3<R>, [along, across]: [R; 2], covered: bool) -> Grip<R> {
    let aside = if n.0[2].magnitude() < R::of(0.7) { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
    let u = n.cross(V3(aside.map(R::of)));
    let u = u * (R::one() / u.norm().larger(R::of(1e-6)));
    Grip { anchor, axes: [n, u, n.cross(u)], weights: [across, along, along], covered }
}

impl<R: Real, const N: usize> Loads<R> for Hold<R, N> {
    fn energy(&self, crease: usize, pair: &Pair<R>) -> R {
        let mut sum = R::ZERO;
        for (grip, x) in self.at(crease).iter().zip(pair) {
            let Some(g) = grip else { continue };
            let off = *x - g.anchor;
            for (axis, &w) in g.axes.iter().zip(&g.weights) {
                let along = off.dot(*axis);
                sum += w * along * along * R::of(0.5);
            }
        }
        sum
    }
    fn pull(&self, crease: usize, pair: &Pair<R>, pull: &mut Pull<R>) {
        for (rim, (grip, x)) in self.at(crease).iter().zip(pair).enumerate() {
            let Some(g) = grip else { continue };
            let off = *x - g.anchor;
            let of = |v: V3<R>| if rim == 0 { [v, V3::zero()] } else { [V3::zero(), v] };
            for (axis, &w) in g.axes.iter().zip(&g.weights) {
                let [a, b] = of(*axis * (w * off.dot(*axis)));
                pull.push(a, b);
                pull.curve(w, of(*axis));
            }
        }
    }
}
