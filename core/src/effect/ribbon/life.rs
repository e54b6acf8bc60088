//! What a caller holds: a ribbon in the world, laid, stepped, brought to rest.

use super::body::Body;
use super::contact::Touch;
use super::frame::Frame;
use super::joint::Crease;
use super::load::{Ask, Loads};
use super::newton::Solver;
use super::report::{Report, Settings, Status};
use super::resample::{Pair, Sample};
use super::spec::{Closure, RibbonSpec};
use super::strip::Strip;
use crate::real::{Real, V3};
use crate::scene::SpecError;
use crate::state::Fnv;

/// Parts in which a Möbius band's joint is turned.
const WINDINGS: u32 = 12;

/// A ribbon of at most `N` segments, placed by the caller: some 1,000 bytes a segment in `f64` and 10,000 beside them.
#[derive(Debug, Clone)]
pub struct Ribbon<R, const N: usize> {
    spec: RibbonSpec,
    /// The world's place of the ribbon's own origin, metres: numbers stay small where the ribbon is far away.
    origin: [f64; 3],
    /// Gravity, metres per second squared.
    pub gravity: [f64; 3],
    /// What pulls at it. In the ribbon's own coordinates: see [`Ribbon::origin`].
    pub ask: Ask<R>,
    /// What a solve is allowed.
    pub settings: Settings,
    body: Body<R, N>,
    solver: Solver<R>,
}

impl<R: Real, const N: usize> Ribbon<R, N> {
    /// No ribbon: for the caller to place.
    pub const EMPTY: Self = Self {
        spec: RibbonSpec {
            length_m: 1.0,
            width_m: 0.05,
            segments: 2,
            rigidity_nm: 1.0,
            areal_mass_gsm: 1.0,
            regularisation: 1.0,
            damping_per_s: 0.0,
            bending: super::spec::Bending::Sadowsky,
            mass: super::spec::Mass::Consistent,
            resample: super::spec::Resample::Smooth,
            root: super::spec::Root::Clamp,
            closure: super::spec::Closure::Open,
            perturbation: 0.0,
            seed: 1,
        },
        origin: [0.0; 3],
        gravity: [0.0; 3],
        ask: Ask::NONE,
        settings: Settings::STEP,
        body: Body::EMPTY,
        solver: Solver::NEW,
    };

    /// Lays it straight along X at `origin`, front up along Z, at rest.
    ///
    /// # Errors
    ///
    /// The first bad field; then nothing was changed.
    pub fn open(&mut self, spec: &RibbonSpec, origin: [f64; 3]) -> Result<(), SpecError> {
        spec.check(N)?;
        if origin.iter().any(|x| !x.is_finite()) {
            return Err(SpecError::NotFinite("ribbon.origin"));
        }
        (self.spec, self.origin) = (*spec, origin);
        self.body.strip = Strip::of(spec);
        self.solver = Solver::NEW;
        self.ask = Ask::NONE;
        self.turn_joint(if spec.closure == Closure::Moebius { core::f64::consts::PI } else { 0.0 });
        self.lay(&Frame::at(V3([R::ZERO; 3])), |_| Crease::default());
        Ok(())
    }

    /// Lays it in a shape, at rest: the start's frame in the ribbon's own coordinates, and each crease. Rulings that
    /// would meet are brought apart; the spec's perturbation is added.
    pub fn lay(&mut self, base: &Frame<R>, crease: impl Fn(usize) -> Crease<R>) {
        let hinged = self.body.strip.hinge > R::ZERO;
        let (mut noise, perturbation) = (Noise(self.spec.seed), self.spec.perturbation);
        for (j, s) in self.body.used_mut().iter_mut().enumerate() {
            let mut at = crease(j);
            at.psi += R::of(noise.next() * perturbation);
            if j == 0 {
                at = Crease { psi: if hinged { at.psi } else { R::ZERO }, c: R::ZERO };
            }
            (s.kept, s.velocity) = (at, [V3([R::ZERO; 3]); 2]);
        }
        self.body.part_rulings();
        self.body.place(R::ZERO);
        self.body.end.velocity = [V3([R::ZERO; 3]); 2];
        self.body.kept_base = *base;
        self.body.base = *base;
        self.hold_loop();
        self.body.reconstruct();
    }

    /// Turns the start's side of a loop's joint about the tangent, from which a ring becomes a Möbius band.
    pub fn turn_joint(&mut self, angle: f64) {
        self.body.joint = [R::of(angle.sine()), R::of(angle.cosine())];
    }

    /// Lays a loop's rest shape: a ring, whose joint a Möbius band then turns to half a turn, an angle at a time.
    ///
    /// # Cost
    ///
    /// A dozen static solves.
    pub fn wind(&mut self, base: &Frame<R>, settings: &Settings) -> Report<R> {
        let n = self.body.strip.n;
        let psi = R::of(2.0 * core::f64::consts::PI / n as f64);
        self.turn_joint(0.0);
        self.lay(base, |_| Crease { psi, c: R::ZERO });
        let rough = Settings { tolerance: 1e-2, closure: 1e-3, ..*settings };
        let mut spent = Report::NONE;
        for part in 1..=WINDINGS {
            let last = part == WINDINGS;
            if self.spec.closure == Closure::Moebius {
                self.turn_joint(core::f64::consts::PI * f64::from(part) / f64::from(WINDINGS));
            } else if !last {
                continue;
            }
            let report = self.settle(if last { settings } else { &rough });
            spent = report.after(&spent);
        }
        spent
    }

    fn hold_loop(&mut self) {
        self.body.hold.lambda = [R::ZERO; 6];
    }

    /// Lets `h` seconds pass: one implicit step (Ribbon Sec. 4).
    ///
    /// # Errors
    ///
    /// None: a bad number is [`Status::Held`], and the ribbon is left where it was, at rest.
    pub fn step(&mut self, h: f64) -> Report<R> {
        self.step_under(h, &())
    }

    /// As [`Ribbon::step`], with further loads, such as contact.
    pub fn step_under(&mut self, h: f64, loads: &impl Loads<R>) -> Report<R> {
        self.step_watched(h, loads, |_, _| {})
    }

    /// As [`Ribbon::step_under`]; `watch` sees the objective and the loop's gap before every iteration and at the end.
    pub fn step_watched(
        &mut self,
        h: f64,
        loads: &impl Loads<R>,
        watch: impl FnMut(R, R),
    ) -> Report<R> {
        self.step_with(h, loads, &mut (), watch)
    }

    /// As [`Ribbon::step_under`], with what [`contact`](super::contact) has found near.
    pub fn step_touching(
        &mut self,
        h: f64,
        loads: &impl Loads<R>,
        touch: &mut impl Touch<R>,
    ) -> Report<R> {
        self.step_with(h, loads, touch, |_, _| {})
    }

    /// A step with all of these.
    pub fn step_with(
        &mut self,
        h: f64,
        loads: &impl Loads<R>,
        touch: &mut impl Touch<R>,
        mut watch: impl FnMut(R, R),
    ) -> Report<R> {
        if !(h.is_finite() && h > 0.0) {
            return Report { status: Status::Held, ..Report::NONE };
        }
        let keep = (-self.spec.damping_per_s * h).exponential();
        let fall = V3(self.gravity.map(|g| R::of(g * h * h)));
        self.set_out(R::of(h * keep), fall);
        self.body.motion.kappa = R::of(1.0 / (h * h));
        self.body.motion.pull = V3([R::ZERO; 3]);
        let Self { solver, body, ask, settings, .. } = self;
        let report = solver.minimise(body, ask, loads, touch, settings, &mut watch);
        if report.status == Status::Held {
            let last = self.body.kept_base;
            self.rest_where_it_was(&last);
        } else {
            self.velocities(R::of(1.0 / h), fall, R::of(keep));
        }
        report
    }

    /// Finds the rest shape under gravity and loads, the start being held.
    pub fn settle(&mut self, settings: &Settings) -> Report<R> {
        self.settle_watched(settings, |_, _| {})
    }

    /// As [`Ribbon::settle`], watched.
    pub fn settle_watched(
        &mut self,
        settings: &Settings,
        mut watch: impl FnMut(R, R),
    ) -> Report<R> {
        let (start, free) = (self.body.kept_base, self.body.strip.free);
        self.body.strip.free = false;
        self.body.motion.kappa = R::ZERO;
        self.body.motion.pull = V3(self.gravity.map(R::of));
        self.body.used_mut().iter_mut().for_each(|s| s.want = [Sample::ZERO; 2]);
        self.body.end.want = [Sample::ZERO; 2];
        self.body.stand();
        let Self { solver, body, ask, .. } = self;
        let report = solver.minimise(body, ask, &(), &mut (), settings, &mut watch);
        self.body.strip.free = free;
        let base = if report.status == Status::Held { start } else { self.body.kept_base };
        self.rest_where_it_was(&base);
        report
    }

    /// Stops it where it is for a step.
    pub fn hold(&mut self) -> Report<R> {
        let last = self.body.kept_base;
        self.rest_where_it_was(&last);
        Report { status: Status::Held, ..Report::NONE }
    }

    fn rest_where_it_was(&mut self, base: &Frame<R>) {
        self.body.kept_base = *base;
        self.body.stand();
        self.body.used_mut().iter_mut().for_each(|s| s.velocity = [V3([R::ZERO; 3]); 2]);
        self.body.end.velocity = [V3([R::ZERO; 3]); 2];
    }

    /// `Y = X + h V + h² g` at the vertices as they are.
    fn set_out(&mut self, h: R, fall: V3<R>) {
        self.body.stand();
        let Body { strip, stages, end, table, .. } = &mut self.body;
        let ahead = |x: &Pair<R>, v: &Pair<R>| [x[0] + v[0] * h + fall, x[1] + v[1] * h + fall];
        let knots = stages.iter().map(|s| (s.crease.c, ahead(&s.pair, &s.velocity)));
        table.fill(strip, knots, ahead(&end.pair, &end.velocity));
    }

    /// `V' = (X' - R Y)/h + h g + keep R V`: what is left of inertia, plus what the old motion was.
    fn velocities(&mut self, rate: R, fall: V3<R>, keep: R) {
        let Body { strip, stages, end, table, .. } = &mut self.body;
        table.replace(stages.iter().map(|s| s.velocity), end.velocity);
        let kick = fall * rate;
        let speed =
            |x: V3<R>, want: &Sample<R>, v: Sample<R>| (x - want.y) * rate + kick + v.y * keep;
        let n = strip.n;
        for (j, s) in stages.iter_mut().take(n).enumerate() {
            let (at, lean) = (strip.cell * R::of(j as f64), strip.half * s.crease.c);
            let old = [table.sample(0, at - lean, j), table.sample(1, at + lean, j)];
            s.velocity =
                [speed(s.pair[0], &s.want[0], old[0]), speed(s.pair[1], &s.want[1], old[1])];
        }
        let at = strip.length();
        let old = [table.sample(0, at, n), table.sample(1, at, n)];
        end.velocity =
            [speed(end.pair[0], &end.want[0], old[0]), speed(end.pair[1], &end.want[1], old[1])];
    }

    /// What was asked for.
    pub fn spec(&self) -> &RibbonSpec {
        &self.spec
    }
    /// Where its own coordinates begin, metres.
    pub fn origin(&self) -> [f64; 3] {
        self.origin
    }
    /// The creases from the start, its hinge first.
    pub fn creases(&self) -> impl Iterator<Item = Crease<R>> {
        self.body.used().iter().map(|s| s.kept)
    }
    /// The vertex pairs from the start to the end, in its own coordinates.
    pub fn pairs(&self) -> impl Iterator<Item = Pair<R>> {
        self.body.used().iter().map(|s| s.pair).chain(core::iter::once(self.body.end.pair))
    }
    /// The segments' frames.
    pub fn frames(&self) -> impl Iterator<Item = Frame<R>> {
        self.body.used().iter().map(|s| s.frame)
    }
    /// The velocities of its vertices.
    pub fn velocities_now(&self) -> impl Iterator<Item = Pair<R>> {
        self.body.used().iter().map(|s| s.velocity).chain(core::iter::once(self.body.end.velocity))
    }
    /// Sets the velocity of every vertex from its position.
    pub fn launch(&mut self, velocity: impl Fn(V3<R>) -> V3<R>) {
        let both = |p: &Pair<R>| [velocity(p[0]), velocity(p[1])];
        self.body.used_mut().iter_mut().for_each(|s| s.velocity = both(&s.pair));
        self.body.end.velocity = both(&self.body.end.pair);
    }
    /// Adds to the velocity of every vertex, numbered along the ribbon and rim by rim, what a shift of it a step makes.
    pub(super) fn nudge(&mut self, rate: R, shift: impl Fn(usize) -> V3<R>) {
        let used = self.body.strip.n;
        for (j, s) in self.body.used_mut().iter_mut().enumerate() {
            let [a, b] = s.velocity;
            s.velocity = [a + shift(2 * j) * rate, b + shift(2 * j + 1) * rate];
        }
        let [a, b] = self.body.end.velocity;
        self.body.end.velocity = [a + shift(2 * used) * rate, b + shift(2 * used + 1) * rate];
    }
    /// Moves a clamped start.
    pub fn carry(&mut self, base: &Frame<R>) {
        self.body.kept_base = *base;
    }
    pub(super) fn posed(&self) -> &Body<R, N> {
        &self.body
    }
    /// What is carried from one solve to the next: not a part of the state, yet it decides the bits.
    pub(super) fn memory(&mut self) -> (&mut Body<R, N>, &mut Solver<R>) {
        (&mut self.body, &mut self.solver)
    }
    /// What is solved for: for oracles and tests.
    pub fn body(&mut self) -> &mut Body<R, N> {
        &mut self.body
    }
    /// The hash of everything that decides the future.
    pub fn state_hash(&self) -> u64 {
        let mut hash = Fnv::default();
        let base = &self.body.kept_base;
        [base.t, base.b, base.n, base.p].iter().flat_map(|v| v.0).for_each(|x| hash.real(x));
        for s in self.body.used() {
            [s.kept.psi, s.kept.c].into_iter().for_each(|x| hash.real(x));
        }
        self.velocities_now().flatten().flat_map(|v| v.0).for_each(|x| hash.real(x));
        hash.value()
    }
}

/// PCG32, from -1 to 1.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let old = self.0;
        self.0 = old.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        let mixed = ((((old >> 18) ^ old) >> 27) as u32).rotate_right((old >> 59) as u32);
        f64::from(mixed) / f64::from(u32::MAX) * 2.0 - 1.0
    }
}
