//! The ribbon while it is solved for: creases, frames, vertices, and the value of everything that is minimised.

use super::assemble::Room;
use super::barrier::{Logs, duals, room};
use super::bending;
use super::closure::{Gap, Hold};
use super::contact::touch::Pose;
use super::frame::{Frame, Six};
use super::inertia::{Cell, Motion};
use super::joint::{Crease, Turn};
use super::load::{Ask, Loads};
use super::resample::{Pair, Sample, Table};
use super::riccati::Gain;
use super::spec::Closure;
use super::strip::Strip;
use crate::real::{Real, V3};

/// A segment and the crease at its near end.
#[derive(Debug, Clone, Copy)]
pub struct Stage<R> {
    /// The crease as evaluated.
    pub crease: Crease<R>,
    /// The crease as last accepted.
    pub kept: Crease<R>,
    /// The step sought for it.
    pub step: Crease<R>,
    /// Its turn.
    pub turn: Turn<R>,
    /// The segment's frame, at the crease's middle.
    pub frame: Frame<R>,
    /// The frame as last accepted.
    pub kept_frame: Frame<R>,
    /// The crease's ends.
    pub pair: Pair<R>,
    /// The crease's ends as last accepted.
    pub kept_pair: Pair<R>,
    /// What they aim at.
    pub want: [Sample<R>; 2],
    /// Velocity of the crease's ends.
    pub velocity: Pair<R>,
    /// Barrier duals between this crease and the next.
    pub dual: [R; 2],
    /// The rule for the next crease's step.
    pub gain: Gain<R>,
}

impl<R: Real> Stage<R> {
    /// Nothing.
    pub const ZERO: Self = Self {
        crease: Crease { psi: R::ZERO, c: R::ZERO },
        kept: Crease { psi: R::ZERO, c: R::ZERO },
        step: Crease { psi: R::ZERO, c: R::ZERO },
        turn: Turn::NONE,
        frame: Frame::WORLD,
        kept_frame: Frame::WORLD,
        pair: [V3([R::ZERO; 3]); 2],
        kept_pair: [V3([R::ZERO; 3]); 2],
        want: [Sample::ZERO; 2],
        velocity: [V3([R::ZERO; 3]); 2],
        dual: [R::ZERO; 2],
        gain: Gain::ZERO,
    };
}

/// The end of the ribbon, which no crease moves.
#[derive(Debug, Clone, Copy)]
pub struct End<R> {
    /// Its vertices.
    pub pair: Pair<R>,
    /// Its vertices as last accepted.
    pub kept_pair: Pair<R>,
    /// What they aim at.
    pub want: [Sample<R>; 2],
    /// Their velocity.
    pub velocity: Pair<R>,
}

impl<R: Real> End<R> {
    /// Nothing.
    pub const ZERO: Self = Self {
        pair: [V3([R::ZERO; 3]); 2],
        kept_pair: [V3([R::ZERO; 3]); 2],
        want: [Sample::ZERO; 2],
        velocity: [V3([R::ZERO; 3]); 2],
    };
}

/// Everything a solve works on, for up to `N` segments.
#[derive(Debug, Clone)]
pub struct Body<R, const N: usize> {
    /// What it is made of.
    pub strip: Strip<R>,
    /// Segments; those beyond the strip's number are not used.
    pub stages: [Stage<R>; N],
    /// The end.
    pub end: End<R>,
    /// The start's frame as evaluated, before the hinge there.
    pub base: Frame<R>,
    /// The start's frame as last accepted.
    pub kept_base: Frame<R>,
    /// The step sought for it.
    pub base_step: Six<R>,
    /// The rule for the hinge.
    pub root_gain: Gain<R>,
    /// Last step's vertices on their way.
    pub table: Table<R, N>,
    /// Inertia or weight.
    pub motion: Motion<R>,
    /// Barrier parameter, joules.
    pub mu: R,
    /// Share of what a force gains by turning that the model leaves out: with none it is exact, with all of it Gauss and
    /// Newton's, which always has a minimum.
    pub rough: R,
    /// What holds the loop.
    pub hold: Hold<R>,
    /// Sine and cosine of the angle about the tangent at which a loop's end meets its start.
    pub joint: [R; 2],
    /// The loop's joint as evaluated.
    pub gap: Gap<R>,
    /// Where segments are assembled.
    pub(super) room: Room<R>,
}

/// What is minimised, in its parts, joules.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy<R> {
    /// Inertia, bending, slopes, loads and guides.
    pub objective: R,
    /// The barrier's `-Σ ln`, without its parameter.
    pub wall: R,
    /// The loop's Lagrangian.
    pub joint: R,
}

impl<R: Real> Energy<R> {
    /// The merit under barrier parameter `mu`.
    pub fn total(&self, mu: R) -> R {
        self.objective + self.wall * mu + self.joint
    }
}

impl<R: Real, const N: usize> Body<R, N> {
    /// Nothing.
    pub const EMPTY: Self = Self {
        strip: Strip::ZERO,
        stages: [Stage::ZERO; N],
        end: End::ZERO,
        base: Frame::WORLD,
        kept_base: Frame::WORLD,
        base_step: [R::ZERO; 6],
        root_gain: Gain::ZERO,
        table: Table::EMPTY,
        motion: Motion { kappa: R::ZERO, pull: V3([R::ZERO; 3]) },
        mu: R::ZERO,
        rough: R::ZERO,
        hold: Hold::NONE,
        joint: [R::ZERO; 2],
        gap: Gap {
            turn: V3([R::ZERO; 3]),
            shift: V3([R::ZERO; 3]),
            end: V3([R::ZERO; 3]),
            start: V3([R::ZERO; 3]),
        },
        room: Room::EMPTY,
    };

    /// The segments in use.
    pub fn used(&self) -> &[Stage<R>] {
        self.stages.get(..self.strip.n).unwrap_or(&self.stages)
    }
    /// The segments in use.
    pub fn used_mut(&mut self) -> &mut [Stage<R>] {
        self.stages.get_mut(..self.strip.n).unwrap_or_default()
    }
    /// Whether the end is joined to the start.
    pub fn looped(&self) -> bool {
        self.strip.closure != Closure::Open
    }
    /// Penalties of a loop's joint at the start of a solve: so many times as stiff as the strip is as a whole.
    pub fn soften(&mut self, times: R) {
        let s = &self.strip;
        let (turn, length) = (s.stiff * times / R::of(s.n as f64), s.length());
        self.hold.turn = turn;
        self.hold.shift = turn * R::of(40.0) / (length * length);
    }
    /// Creases and start at a share of the step from where they were accepted.
    pub fn place(&mut self, share: R) {
        for s in self.used_mut() {
            s.crease.psi = s.kept.psi + s.step.psi * share;
            s.crease.c = s.kept.c + s.step.c * share;
        }
        self.base = self.kept_base;
        if self.strip.free && share > R::ZERO {
            self.base = self.kept_base.moved(&self.base_step.map(|v| v * share));
        }
    }
    /// Everything where it was accepted, evaluated anew.
    pub fn stand(&mut self) {
        self.place(R::ZERO);
        self.reconstruct();
    }
    /// Brings accepted rulings so far apart that the barrier has something to hold on to; answers whether it had to.
    pub fn part_rulings(&mut self) -> bool {
        let (limit, n) = (self.strip.limit * R::of(0.999), self.strip.n);
        let (mut before, mut moved) = (R::ZERO, false);
        for (j, s) in self.used_mut().iter_mut().enumerate().skip(1) {
            let reach = limit * R::of((n - j) as f64);
            let c = s.kept.c.smaller(before + limit).larger(before - limit);
            let c = c.smaller(reach).larger(-reach);
            moved |= c != s.kept.c;
            s.kept.c = c;
            before = c;
        }
        moved
    }
    /// Whether all rulings as placed keep apart, by more than rounding.
    pub fn inside(&self) -> bool {
        let limit = self.strip.limit;
        let far = self.used().iter().skip(1).map(|s| s.crease.c).chain(core::iter::once(R::ZERO));
        let mut pairs = self.used().iter().zip(far);
        pairs.all(|(s, far)| room(far - s.crease.c, limit) > R::of(64.0 * R::EPSILON))
    }
    /// Takes what was evaluated for good, and the barrier's duals with it.
    pub fn accept(&mut self) {
        let (mu, limit) = (self.mu, self.strip.limit);
        let mut stages = self.used_mut().iter_mut().peekable();
        while let Some(s) = stages.next() {
            let (kept, crease) =
                stages.peek().map_or((R::ZERO, R::ZERO), |n| (n.kept.c, n.crease.c));
            s.dual = duals(s.dual, kept - s.kept.c, crease - s.crease.c, limit, mu);
        }
        self.keep();
    }
    /// Takes what was evaluated for good.
    pub fn keep(&mut self) {
        self.used_mut().iter_mut().for_each(|s| s.kept = s.crease);
        self.kept_base = self.base;
        self.mark();
    }
    /// Takes frames and vertices as evaluated for those accepted.
    pub fn mark(&mut self) {
        for s in self.used_mut() {
            (s.kept_frame, s.kept_pair) = (s.frame, s.pair);
        }
        self.end.kept_pair = self.end.pair;
    }
    /// Everything as it was accepted last, to the bit, from what was marked then.
    pub fn recall(&mut self) {
        self.base = self.kept_base;
        let mut last = self.base;
        for s in self.used_mut() {
            (s.crease, s.frame, s.pair) = (s.kept, s.kept_frame, s.kept_pair);
            (s.turn, last) = (Turn::of(s.crease), s.frame);
        }
        self.finish(&last);
        self.aim();
    }
    /// Sets what is placed aside as the step: `place(1)` brings it back.
    pub fn set_aside(&mut self) {
        for s in self.used_mut() {
            s.step = Crease { psi: s.crease.psi - s.kept.psi, c: s.crease.c - s.kept.c };
        }
    }
    /// As contact sees it.
    pub fn pose(&self) -> Pose<'_, R> {
        Pose { stages: self.used(), end: &self.end }
    }
    /// Frames and vertices from creases and start (Ribbon Eq. 2).
    ///
    /// # Accuracy
    ///
    /// Exactly isometric but for rounding: every segment is moved rigidly.
    pub fn reconstruct(&mut self) {
        let (strip, base) = (self.strip, self.base);
        let mut frame = base;
        for (j, s) in self.used_mut().iter_mut().enumerate() {
            frame = s.turned(&frame, if j == 0 { R::ZERO } else { strip.cell }, strip.half);
        }
        self.finish(&frame);
    }
    /// Reads what the vertices aim at.
    fn aim(&mut self) {
        let moving = self.motion.kappa > R::ZERO;
        if !moving {
            return;
        }
        let (strip, n) = (self.strip, self.strip.n);
        let Self { stages, table, end, .. } = self;
        for (j, s) in stages.iter_mut().take(n).enumerate() {
            let (at, lean) = (strip.cell * R::of(j as f64), strip.half * s.crease.c);
            s.want = [table.sample(0, at - lean, j), table.sample(1, at + lean, j)];
        }
        let at = strip.length();
        end.want = [table.sample(0, at, n), table.sample(1, at, n)];
    }
    /// The cell of a segment, given what follows it.
    #[inline(always)]
    pub fn cell<'a>(s: &'a Stage<R>, next: (&Pair<R>, &'a [Sample<R>; 2], R)) -> Cell<'a, R> {
        let (pair, want, c) = next;
        Cell::between(s.frame.t, [&s.pair, pair], [&s.want, want], c - s.crease.c)
    }
    /// Evaluates everything at the creases as placed.
    ///
    /// # Cost
    ///
    /// Some 150 operations, a sine and a cosine a segment.
    pub fn evaluate(&mut self, ask: &Ask<R>, loads: &impl Loads<R>) -> Energy<R> {
        self.reconstruct();
        self.weigh(ask, loads)
    }
    /// As [`Body::evaluate`], with frames and vertices as they are.
    pub fn weigh(&mut self, ask: &Ask<R>, loads: &impl Loads<R>) -> Energy<R> {
        self.aim();
        let (mut energy, mut logs) = (Energy::default(), Logs::none());
        let (mut inside, brim) = (true, R::of(64.0 * R::EPSILON));
        let mut stages = self.used().iter().enumerate().peekable();
        while let Some((j, s)) = stages.next() {
            let (pair, want, crease) = match stages.peek() {
                Some((_, next)) => (&next.pair, &next.want, next.crease),
                None => (&self.end.pair, &self.end.want, Crease::default()),
            };
            let cell = Self::cell(s, (pair, want, crease.c));
            energy.objective += cell.energy(&self.strip.mass, &self.motion)
                + bending::energy(&self.strip, j, s.crease, crease)
                + loads.energy(j, &s.pair)
                + ask.energy(j, &s.pair)
                + ask.guided(j, s.frame.n);
            let room = room(cell.spread, self.strip.limit);
            inside &= room > brim;
            logs.take(room);
        }
        let (n, pair) = (self.strip.n, &self.end.pair);
        energy.objective += loads.energy(n, pair) + ask.energy(n, pair);
        energy.wall = if inside { -logs.sum() } else { R::of(f64::INFINITY) };
        if self.looped() {
            energy.joint = self.hold.energy(&self.gap);
        }
        energy
    }
}
