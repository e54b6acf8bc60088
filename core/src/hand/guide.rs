//! The hand that holds a node: from press to letting go.
//!
//! After the finger leaves the screen the hand may follow through: the target goes on along the tent
//! with the speed the finger had, slowed on the way up as by gravity. If the speed carries it over the
//! peak the leaf is let go beyond, else it is let go at once. So a flick turns a page, a twitch does
//! not, a reverse flick takes it back, and no clock decides.

use super::place::Place;
use super::sample::Sample;
use super::tent::{Aim, Tent};
use super::view::{Camera, Ray};
use crate::real::{Real, V3};
use crate::state::Fnv;

/// Furthest a target may be from the held node, model units: keeps the pull within what a sheet bears.
const LEASH: f64 = 3.0;
/// From this strain on a hand that tugs is followed less, and at that one hardly at all.
const STRAINED: f64 = 0.03;
const TORN: f64 = 0.12;
/// How fast a firm hand leans further, 1/s, how far at most, and how near the node has to be, model units.
const LEANING: f64 = 14.0;
const LEAN: f64 = 1.0;
const NEARBY: f64 = 0.5;
/// Way of the wanted place in a step below which the finger rests, model units.
const RESTS: f64 = 0.2;
/// Part of the leash within which a firm hand is a spring.
const CLOSE: f64 = 10.0;
/// What is then left of the leash.
const LEAST_LEASH: f64 = 0.1;
/// Pull down the tent while following through, units/s²: a flick of 0.3 m/s turns a page of 130 mm.
const SLOPE_PULL: f64 = 60.0;
/// Slowest release that follows through, units/s.
const LEAST_SPEED: f64 = 6.0;
/// How fast a hand carries a leaf back, units/s.
const BACK: f64 = 40.0;
/// Least way the finger went before its speed counts, as a share of the node's distance.
const LEAST_WAY: f64 = 0.05;
/// How far past the peak the leaf is let go, as a share of the reach.
const BEYOND: f64 = 0.25;
/// Way of the finger over which the node comes from where it lay to the tent, as a share of its distance.
const FADE: f64 = 0.15;
/// The same for a node that has to come from far, as a share of that way.
const FAR: f64 = 0.6;
/// Longest a hand follows through, seconds: a leaf that cannot be moved is let go.
const LONGEST: f64 = 1.0;
/// Finger speed is measured over at least this long, microseconds.
const WINDOW_US: u64 = 60_000;

/// A place of the target and when it was wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Mark<R> {
    t_us: u64,
    x: R,
}

/// What the hand is doing.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Motion<R> {
    /// The finger leads.
    Dragging,
    /// The finger left at this speed across.
    Following(R),
}

/// A hand on a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guide<R> {
    /// Pointer that holds.
    pub id: u8,
    /// Column and row held.
    pub node: (usize, usize),
    /// The paper under the finger when it came down.
    place: Place<R>,
    /// Where the node was then.
    origin: V3<R>,
    /// From where the finger asked for it to where it was then: from the tent for a firm hand, else from the drag
    /// plane.
    lag: V3<R>,
    /// The finger's ray now.
    ray: Ray<R>,
    /// Wanted place of the node, before the leash.
    wanted: V3<R>,
    /// What a firm hand asks for beyond that, so that the sheet's resistance does not keep the node from it.
    lean: V3<R>,
    /// The finger asks for more than the sheet can follow.
    beyond: bool,
    /// Where the finger was lately, newest last.
    marks: [Mark<R>; 4],
    motion: Motion<R>,
    /// Seconds since the finger left.
    followed: R,
}

/// What a hand does in one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull<R> {
    /// Where it wants the node.
    pub target: V3<R>,
    /// The leash held it back.
    pub leashed: bool,
    /// How firmly it pulls, in weights of the sheet's own: with a grip as hard from anywhere on the leash, so that
    /// what rests under a finger stays there.
    pub firm: R,
    /// It still holds.
    pub holds: bool,
}

/// What bounds a target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach<R> {
    /// The tent over the book.
    pub tent: Tent<R>,
    /// The camera the finger's rays come from.
    pub camera: Camera<R>,
    /// From the paper that was touched to the node, now.
    pub aside: V3<R>,
    /// The hand is firm: the paper that was touched stays under the finger. Else it follows the finger's way over
    /// the drag plane, as the seed's.
    pub firm: bool,
}

impl<R: Real> Reach<R> {
    /// Where the node has to be for the paper that was touched to be under the finger.
    fn aim(&self, ray: &Ray<R>) -> Aim<R> {
        self.tent.aim(&Ray { from: ray.from + self.aside, ..*ray })
    }

    /// Where a ray meets the drag plane through a place.
    fn plane(&self, ray: &Ray<R>, through: V3<R>) -> Option<V3<R>> {
        ray.meet(through, self.camera.forward)
    }
}

impl<R: Real> Guide<R> {
    /// Takes a node at `origin` by a finger on `place`.
    pub fn take(
        sample: &Sample,
        node: (usize, usize),
        place: Place<R>,
        origin: V3<R>,
        reach: &Reach<R>,
    ) -> Self {
        let mark = Mark { t_us: sample.t_us, x: origin.0[0] - reach.tent.root };
        let ray = reach.camera.ray(sample.x, sample.y);
        let asked = match reach.firm {
            true => reach.aim(&ray).at,
            false => reach.plane(&ray, origin).unwrap_or(origin),
        };
        Self {
            id: sample.id,
            node,
            place,
            origin,
            lag: origin - asked,
            ray,
            wanted: origin,
            lean: V3::zero(),
            beyond: false,
            marks: [mark; 4],
            motion: Motion::Dragging,
            followed: R::ZERO,
        }
    }

    /// The paper that was touched.
    pub fn place(&self) -> &Place<R> {
        &self.place
    }
    /// Where the node was when it was taken.
    pub fn origin(&self) -> V3<R> {
        self.origin
    }
    /// The finger asks for more than the sheet can follow: the paper it touched is not under it.
    pub fn beyond(&self) -> bool {
        self.beyond
    }

    /// The finger moved. Answers whether the place it asks for had to be clamped.
    pub fn drag(&mut self, sample: &Sample, reach: &Reach<R>) -> bool {
        self.ray = reach.camera.ray(sample.x, sample.y);
        if reach.firm {
            self.aim(reach);
        } else {
            self.slide(reach);
        }
        self.mark(sample.t_us, self.wanted.0[0] - reach.tent.root);
        self.beyond
    }

    /// The place under the finger; at first where the node lay, and on the tent once the finger has gone some way.
    fn aim(&mut self, reach: &Reach<R>) {
        let aim = reach.aim(&self.ray);
        let way = (aim.at + self.lag - self.origin).norm();
        let fade = (reach.tent.radius * R::of(FADE)).larger(self.lag.norm() * R::of(FAR));
        let left = (R::of(1.0) - way / fade).larger(R::ZERO);
        self.wanted = reach.tent.nearest(aim.at + self.lag * left);
        self.beyond = aim.clamped;
    }

    /// The place on the tent as far across and along as the finger went over the drag plane. Source: Book Fig. 7.
    fn slide(&mut self, reach: &Reach<R>) {
        let Some(met) = reach.plane(&self.ray, self.origin) else {
            self.beyond = true;
            return;
        };
        let (asked, tent) = (met + self.lag, &reach.tent);
        let x = clamp(asked.0[0] - tent.root, tent.reach(R::ZERO));
        let [tail, head] = tent.sideways(x, tent.height(x));
        let dz = (asked.0[2] - self.origin.0[2]).smaller(tail).larger(-head);
        self.wanted = V3([tent.root + x, tent.height(x), self.origin.0[2] + dz]);
        self.beyond = x != asked.0[0] - tent.root || dz != asked.0[2] - self.origin.0[2];
    }

    fn mark(&mut self, t_us: u64, x: R) {
        let [_, b, c, newest] = self.marks;
        let new = Mark { t_us, x };
        // A mark stays until the next is far enough away to measure a speed.
        if t_us.saturating_sub(c.t_us) < WINDOW_US / 3 {
            self.marks[3] = new;
        } else {
            self.marks = [b, c, newest, new];
        }
    }

    /// Speed of the finger across, over the last marks.
    fn speed(&self, t_us: u64) -> R {
        let newest = self.marks[3];
        let oldest = self
            .marks
            .iter()
            .find(|m| t_us.saturating_sub(m.t_us) <= 2 * WINDOW_US)
            .unwrap_or(&newest);
        let us = t_us.saturating_sub(oldest.t_us).max(1000);
        (newest.x - oldest.x) / R::of(us as f64 * 1e-6)
    }

    /// The finger left. Answers whether the hand follows through; if not, the leaf is free.
    pub fn release(&mut self, reach: &Reach<R>, t_us: u64) -> bool {
        let x = self.wanted.0[0] - reach.tent.root;
        let speed = self.speed(t_us);
        let way = (self.wanted.0[0] - self.origin.0[0]).magnitude();
        let rising = (x < R::ZERO) == (speed > R::ZERO);
        let climb = reach.tent.height(R::ZERO) - reach.tent.height(x);
        // Past the peak there is nothing left to climb; the leaf may still lag behind on the other side.
        let enough = !rising || speed * speed * R::of(0.5) > R::of(SLOPE_PULL) * climb;
        let meant =
            speed.magnitude() > R::of(LEAST_SPEED) && way > reach.tent.radius * R::of(LEAST_WAY);
        self.motion = Motion::Following(speed);
        self.lean = V3::zero();
        meant && enough
    }

    /// The finger was taken away: the hand carries the leaf back to the side it came from.
    pub fn put_back(&mut self, from_right: bool) {
        self.motion = Motion::Following(R::of(if from_right { BACK } else { -BACK }));
        self.lean = V3::zero();
    }

    /// Moves the target by one step of `h` seconds, as near `node` as the leash asks.
    ///
    /// The leash runs along the tent: a target far ahead leads the node over the peak, not through the block.
    /// It is the shorter, the more the sheet is strained: a finger that jumps about does not tear it.
    pub fn advance(&mut self, node: V3<R>, reach: &Reach<R>, strain: R, h: R, grip: R) -> Pull<R> {
        let tent = &reach.tent;
        let here = node.0[0] - tent.root;
        let holds = match self.motion {
            Motion::Dragging => {
                if reach.firm {
                    let before = self.wanted;
                    self.aim(reach);
                    let rests = (self.wanted - before).norm() < R::of(RESTS);
                    self.lean_on(node, rests && !self.beyond, h);
                }
                true
            }
            Motion::Following(speed) => self.follow(speed, here, reach, h),
        };
        let spare = (R::of(TORN) - strain) * R::of(1.0 / (TORN - STRAINED));
        let leash = R::of(LEASH) * spare.smaller(R::of(1.0)).larger(R::of(LEAST_LEASH));
        let goal = self.wanted + self.lean;
        let asked = goal.0[0] - tent.root;
        let x = asked.larger(here - leash).smaller(here + leash);
        let z = goal.0[2].larger(node.0[2] - leash).smaller(node.0[2] + leash);
        let held_back = x != asked || z != goal.0[2];
        let target = if held_back { V3([tent.root + x, self.level(x, tent), z]) } else { goal };
        let firm = grip * leash / (target - node).norm().larger(leash * R::of(1.0 / CLOSE));
        Pull { target, leashed: held_back, firm: firm.larger(R::of(1.0)), holds }
    }

    /// Asks for a little more than is wanted as long as the finger rests and the node stays short of it.
    fn lean_on(&mut self, node: V3<R>, rests: bool, h: R) {
        let short = self.wanted - node;
        if short.norm() > R::of(NEARBY) || !rests {
            self.lean = self.lean * R::of(0.5);
            return;
        }
        let lean = self.lean + short * (h * R::of(LEANING)).smaller(R::of(0.5));
        self.lean = lean * (R::of(LEAN) / lean.norm().larger(R::of(LEAN)));
    }

    /// As far below the tent at `x` as the wanted place is below it where that is.
    fn level(&self, x: R, tent: &Tent<R>) -> R {
        tent.height(x) + self.wanted.0[1] - tent.height(self.wanted.0[0] - tent.root)
    }

    /// Runs on along the tent. Answers false once the node itself is over, or nothing drives it any more.
    fn follow(&mut self, speed: R, here: R, reach: &Reach<R>, h: R) -> bool {
        let tent = &reach.tent;
        let x = self.wanted.0[0] - tent.root;
        let limit = tent.reach(speed);
        let uphill = if (x < R::ZERO) == (speed > R::ZERO) { R::of(-1.0) } else { R::of(1.0) };
        let slope = tent.height(R::ZERO) / limit;
        let faster =
            (speed.magnitude() + uphill * R::of(SLOPE_PULL) * slope * h).larger(R::of(LEAST_SPEED));
        let sign = if speed < R::ZERO { R::of(-1.0) } else { R::of(1.0) };
        let next = clamp(x + sign * faster * h, limit);
        self.wanted =
            tent.nearest(V3([tent.root + next, self.level(next, tent), self.wanted.0[2]]));
        self.motion = Motion::Following(sign * faster);
        self.followed += h;
        sign * here < limit * R::of(BEYOND) && self.followed < R::of(LONGEST)
    }

    /// Adds everything that decides the hand's future to a state hash.
    pub fn digest(&self, hash: &mut Fnv) {
        hash.word(u64::from(self.id) | (self.node.0 as u64) << 8 | (self.node.1 as u64) << 24);
        self.place.digest(hash);
        let places = [self.origin, self.lag, self.wanted, self.lean, self.ray.from, self.ray.along];
        places.iter().flat_map(|v| v.0).for_each(|c| hash.real(c));
        for mark in &self.marks {
            hash.word(mark.t_us);
            hash.real(mark.x);
        }
        match self.motion {
            Motion::Dragging => hash.word(0),
            Motion::Following(speed) => hash.real(speed),
        }
        hash.real(self.followed);
    }

    /// The finger still leads.
    pub fn dragging(&self) -> bool {
        self.motion == Motion::Dragging
    }
}

fn clamp<R: Real>(v: R, limit: R) -> R {
    v.larger(-limit).smaller(limit)
}
