//! One ribbon of a scene: laid as asked, stepped, told in SI.

use super::strands::Strand;
use super::{Bytes, Energy, EventName, RibbonWork, Rims, Strain};
use crate::error::CliError;
use crate::picture::{BandShot, band_shot};
use crate::scene::{Fabric, MOST_SEGMENTS, RibbonPart, Start, Twist};
use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near, Surface};
use dogleaf_core::effect::ribbon::event::{Ear, Sound};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::joint::Crease;
use dogleaf_core::effect::ribbon::record::Recorder;
use dogleaf_core::effect::ribbon::resample::Pair;
use dogleaf_core::effect::ribbon::{
    Closure, Guide, Loads, Report, Ribbon, RibbonSpec, Settings, Spring, Status, bending,
};
use dogleaf_core::real::{Real, V3};
use dogleaf_core::record::RecordError;
use dogleaf_core::scene::WorldSpec;
use dogleaf_core::step::StepStatus;

/// A ribbon and what the scene does to it.
pub(super) struct Band<R: Real> {
    ribbon: Box<Ribbon<R, MOST_SEGMENTS>>,
    /// The directions it was laid in.
    base: Frame<R>,
    twist: Option<Twist>,
    floor: Floor<R>,
    /// It touches what else does.
    pub(super) contact: bool,
    fabric: Fabric,
    /// Work since it was last told, and how the worst solve ended.
    work: Report<R>,
    bends: u32,
    ear: Box<Ear<R, MOST_SEGMENTS>>,
    recorder: Option<Recorder<Bytes, R>>,
    /// The recorder took everything so far.
    complete: bool,
}

/// What a step came to, and what it sounds like.
pub(super) struct Stepped<R> {
    pub(super) status: StepStatus,
    pub(super) sound: Sound<R>,
}

/// A floor, where there is one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Floor<R>(pub(super) Option<HalfSpace<R>>);

impl<R: Real> Floor<R> {
    /// At a height in the ribbon's own coordinates.
    pub(super) fn at(height: f64) -> Self {
        let up = V3([0.0, 1.0, 0.0].map(R::of));
        Self(Some(HalfSpace { point: up * R::of(height), normal: up }))
    }
}

impl<R: Real> Surface<R> for Floor<R> {
    fn above(&self, p: V3<R>) -> (R, V3<R>) {
        self.0.map_or_else(|| ().above(p), |plane| plane.above(p))
    }
}

/// What is near a ribbon of a scene.
pub(super) type Room<R> = Near<R, Floor<R>, MOST_SEGMENTS, 2048, 8192>;

/// Nothing near yet.
pub(super) fn room<R: Real>() -> Box<Room<R>> {
    Box::new(Near::over(Floor(None), Cushion::default()))
}

impl<R: Real> Band<R> {
    /// Lays a ribbon.
    pub(super) fn lay(
        part: &RibbonPart,
        world: &WorldSpec,
        settings: &Settings,
    ) -> Result<Self, CliError> {
        let mut ribbon = Box::new(Ribbon::<R, MOST_SEGMENTS>::EMPTY);
        ribbon.open(&part.spec, part.at_m)?;
        let vector = |v: [f64; 3]| V3(v.map(R::of));
        let base = Frame::leaning(V3([R::ZERO; 3]), vector(part.along), vector(part.normal));
        shape(&mut ribbon, part, &base);
        ribbon.settings = *settings;
        ribbon.gravity = world.gravity;
        set_off(&mut ribbon, part);
        for pull in &part.pulls {
            let to: [f64; 3] = std::array::from_fn(|i| pull.to_m[i] - part.at_m[i]);
            let spring = Spring {
                crease: pull.crease,
                rim: pull.rim,
                target: vector(to),
                stiffness: R::of(pull.n_per_m),
            };
            // The scene has counted them.
            let _ = ribbon.ask.springs.push(spring);
        }
        let own = |height: f64| Floor::at(height - part.at_m[1]);
        let floor = part.floor_m.map_or(Floor(None), own);
        let (twist, fabric) = (part.twist, part.fabric);
        let contact = part.contact;
        Ok(Self {
            ribbon,
            base,
            twist,
            floor,
            contact,
            fabric,
            work: Report::NONE,
            bends: 0,
            ear: Box::new(Ear::NEW),
            recorder: None,
            complete: true,
        })
    }

    /// Finds what is near it within a step.
    pub(super) fn look<'a>(
        &'a self,
        near: &mut Room<R>,
        step_us: u32,
        others: impl Iterator<Item = &'a Self>,
    ) {
        near.begin(&self.ribbon, f64::from(step_us) * 1e-6);
        near.surface = self.floor;
        others.filter(|o| o.contact).for_each(|o| near.add(&o.ribbon));
    }

    /// One step; `now_us` is the time at its end, `near` what it could meet of the bands before and after it.
    pub(super) fn step(
        &mut self,
        now_us: u64,
        step_us: u32,
        near: Option<&mut Room<R>>,
        others: [&[Self]; 2],
    ) -> Stepped<R> {
        self.turn_end(now_us as f64 * 1e-6);
        let h = f64::from(step_us) * 1e-6;
        self.ear.before(&self.ribbon);
        let (report, sound) = match near {
            Some(near) => {
                let report = self.taken(h, |ribbon, h| bent(ribbon, h, near));
                let other = |k: usize, segment: usize| {
                    let mut known = others.into_iter().flatten().filter(|o| o.contact);
                    known.nth(k).map_or([V3([R::ZERO; 3]); 4], |o| o.speeds(segment))
                };
                (report, self.ear.after(&self.ribbon, h, &report, near, other))
            }
            None => {
                let report = self.taken(h, |ribbon, h| ribbon.step(h));
                let none = |_, _| [V3([R::ZERO; 3]); 4];
                (report, self.ear.after(&self.ribbon, h, &report, &(), none))
            }
        };
        let worst = if rank(report.status) < rank(self.work.status) && self.bends > 0 {
            self.work.status
        } else {
            report.status
        };
        self.work = Report { status: worst, ..report.after(&self.work) };
        self.bends += 1;
        let status = match report.status {
            Status::Converged => StepStatus::Converged,
            Status::Capped | Status::Stalled | Status::Open => StepStatus::Reduced,
            Status::Held => StepStatus::Held,
        };
        Stepped { status, sound }
    }

    /// A step, through the recorder where there is one.
    fn taken(
        &mut self,
        h: f64,
        step: impl FnOnce(&mut Ribbon<R, MOST_SEGMENTS>, f64) -> Report<R>,
    ) -> Report<R> {
        let Some(recorder) = &mut self.recorder else { return step(&mut self.ribbon, h) };
        let (report, done) = recorder.step(&mut self.ribbon, h, step);
        self.complete &= done.is_ok();
        report
    }

    /// Velocities of a segment's vertices.
    fn speeds(&self, segment: usize) -> [V3<R>; 4] {
        let mut pairs = self.ribbon.velocities_now().skip(segment);
        let none = [V3([R::ZERO; 3]); 2];
        let ([a, b], [c, d]) = (pairs.next().unwrap_or(none), pairs.next().unwrap_or(none));
        [a, b, c, d]
    }

    /// Keeps a recording from now on.
    pub(super) fn record(&mut self) -> Result<(), RecordError> {
        self.recorder = Some(Recorder::start(Bytes::default(), &mut self.ribbon)?);
        Ok(())
    }

    /// What a recording kept, whether it is all, and what the ribbon could touch.
    pub(super) fn recording(&mut self) -> Result<(Strand, bool), RecordError> {
        let bytes = self.recorder.take().map_or(Ok(Bytes::default()), Recorder::finish)?.0;
        let floor = self.floor.0.map(|plane| plane.point.0[1].wide());
        Ok((Strand { bytes, contact: self.contact, floor }, self.complete))
    }

    fn turn_end(&mut self, now_s: f64) {
        let Some(twist) = self.twist else { return };
        let angle = twist.angle_at(now_s);
        let (sin, cos) = (R::of(angle.sin()), R::of(angle.cos()));
        let guide = Guide {
            segment: self.ribbon.spec().segments - 1,
            normal: self.base.n * cos - self.base.b * sin,
            stiffness: R::of(twist.stiffness_nm),
        };
        self.ribbon.ask.guides.clear();
        let _ = self.ribbon.ask.guides.push(guide);
    }

    /// Its end is still being turned.
    pub(super) fn turning(&self, now_us: u64) -> bool {
        self.twist.is_some_and(|t| now_us as f64 * 1e-6 < t.seconds)
    }

    /// Speed of its fastest vertex, metres per second.
    pub(super) fn fastest(&self) -> f64 {
        let speeds = self.ribbon.velocities_now().flatten();
        speeds.map(|v| V3(v.0.map(Real::wide)).norm()).fold(0.0, f64::max)
    }

    /// Bytes of the ribbon and its workspace.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.ribbon)
    }

    pub(super) fn hash(&self) -> u64 {
        self.ribbon.state_hash()
    }

    /// Everything a line of output says of it, `touching` joules of contact among it; the work is told once.
    pub(super) fn rims(&mut self, touching: f64) -> Rims {
        let (at, pairs) = (self.ribbon.origin(), self.ribbon.pairs());
        let (rim_a, rim_b) = pairs.map(|[a, b]| (world(a, at), world(b, at))).unzip();
        let work = std::mem::replace(&mut self.work, Report::NONE);
        let looped = self.ribbon.spec().closure != Closure::Open;
        let rims = Rims {
            rim_a,
            rim_b,
            status: name(work.status),
            work: RibbonWork {
                steps: self.bends,
                newton_steps: work.iterations,
                factorisations: work.factorisations,
                trials: work.trials,
            },
            gap: looped.then(|| work.gap.wide()),
            stretch: stretch(&self.ribbon),
            energy: self.energy().and(Energy { kinetic: 0.0, potential: touching }),
        };
        self.bends = 0;
        rims
    }

    /// Energy of contact with what [`Band::look`] found.
    pub(super) fn touching(&self, near: &mut Room<R>) -> f64 {
        near.stored(&self.ribbon).wide()
    }

    /// Kinetic energy; bending, weight above the world's origin, and pulls.
    fn energy(&mut self) -> Energy {
        let at = self.ribbon.origin();
        let gravity = self.ribbon.gravity;
        let weight = V3(gravity.map(R::of));
        let speeds: Vec<Pair<R>> = self.ribbon.velocities_now().collect();
        let pairs: Vec<Pair<R>> = self.ribbon.pairs().collect();
        let creases: Vec<Crease<R>> = self.ribbon.creases().chain([Crease::default()]).collect();
        let ask = self.ribbon.ask.clone();
        let strip = self.ribbon.body().strip;
        let (mut kinetic, mut potential) = (0.0, 0.0);
        for j in 0..strip.n {
            let spread = creases[j + 1].c - creases[j].c;
            let four = |v: &[Pair<R>]| [v[j][0], v[j][1], v[j + 1][0], v[j + 1][1]];
            let moved = strip.mass.times(spread, &four(&speeds));
            let flow = four(&speeds).iter().zip(moved).fold(R::ZERO, |s, (v, m)| s + v.dot(m));
            kinetic += 0.5 * flow.wide();
            let heavy = strip.mass.times(spread, &four(&pairs));
            let load = weight.dot(heavy[0] + heavy[1] + heavy[2] + heavy[3]);
            potential += bending::energy(&strip, j, creases[j], creases[j + 1]).wide();
            potential -= load.wide();
        }
        let lift: f64 = (0..3).map(|i| gravity[i] * at[i]).sum();
        potential -= lift * strip.cell_mass().wide() * strip.n as f64;
        for (j, pair) in pairs.iter().enumerate() {
            potential += ask.energy(j, pair).wide();
        }
        Energy { kinetic, potential }
    }

    /// It, ready to be drawn.
    pub(super) fn shot(&self) -> BandShot {
        let at = self.ribbon.origin();
        let rims: Vec<_> = self.ribbon.pairs().map(|p| p.map(|v| world(v, at))).collect();
        band_shot(&rims, self.fabric)
    }
}

/// A step against what is near; where that is more than has room, none.
pub(super) fn bent<R: Real>(
    ribbon: &mut Ribbon<R, MOST_SEGMENTS>,
    h: f64,
    near: &mut Room<R>,
) -> Report<R> {
    if near.full() { ribbon.hold() } else { ribbon.step_touching(h, &(), near) }
}

/// What a step of the ribbon of such a number sounds like, event by event.
pub(super) fn heard<R: Real>(ribbon: usize, sound: &Sound<R>) -> impl Iterator<Item = EventName> {
    let (vertices, m_per_s, joules) = (sound.touches, sound.speed.wide(), sound.snap.wide());
    let touched = (vertices > 0).then_some(EventName::Touched { ribbon, vertices, m_per_s });
    let snapped = (joules > 0.0).then_some(EventName::Snapped { ribbon, joules });
    touched.into_iter().chain(snapped)
}

/// The shape it begins in.
fn shape<R: Real>(ribbon: &mut Ribbon<R, MOST_SEGMENTS>, part: &RibbonPart, base: &Frame<R>) {
    let RibbonSpec { segments, .. } = part.spec;
    let [turns, slope] = part.helix;
    match part.start {
        Start::Straight => ribbon.lay(base, |_| Crease::default()),
        Start::Helix => {
            let psi = R::of(std::f64::consts::TAU * turns / segments as f64);
            ribbon.lay(base, |_| Crease { psi, c: R::of(slope) });
        }
        Start::Ring | Start::Moebius => {
            ribbon.gravity = [0.0; 3];
            ribbon.wind(base, &exact::<R>());
        }
    }
}

/// To rounding; single precision would go on in vain.
fn exact<R: Real>() -> Settings {
    if R::EPSILON > 1e-10 {
        return Settings { tolerance: 1e-4, closure: 1e-5, ..Settings::EXACT };
    }
    Settings::EXACT
}

/// The motion it begins with, its spin about its middle.
fn set_off<R: Real>(ribbon: &mut Ribbon<R, MOST_SEGMENTS>, part: &RibbonPart) {
    let [v, w] = [part.velocity, part.spin].map(|v| V3(v.map(R::of)));
    let count = R::of(2.0 * (part.spec.segments + 1) as f64);
    let sum = ribbon.pairs().flatten().fold(V3([R::ZERO; 3]), |s, p| s + p);
    let middle = sum * (R::one() / count);
    ribbon.launch(|x| v + w.cross(x - middle));
}

fn world<R: Real>(v: V3<R>, origin: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| v.0[i].wide() + origin[i])
}

/// How far rim edges are from their length in the flat ribbon, as a share of a segment.
fn stretch<R: Real>(ribbon: &Ribbon<R, MOST_SEGMENTS>) -> Strain {
    let spec = ribbon.spec();
    let cell = spec.length_m / spec.segments as f64;
    let slopes: Vec<f64> = ribbon.creases().map(|c| c.c.wide()).chain([0.0]).collect();
    let pairs: Vec<_> = ribbon.pairs().map(|p| p.map(|v| V3(v.0.map(Real::wide)))).collect();
    let (mut max, mut sum) = (0.0_f64, 0.0);
    for (pair, c) in pairs.windows(2).zip(slopes.windows(2)) {
        let spread = 0.5 * spec.width_m * (c[1] - c[0]);
        for (rim, rest) in [(0, cell - spread), (1, cell + spread)] {
            let off = ((pair[1][rim] - pair[0][rim]).norm() - rest).abs() / cell;
            (max, sum) = (max.max(off), sum + off * off);
        }
    }
    Strain { max, rms: (sum / (2 * spec.segments) as f64).sqrt() }
}

fn rank(status: Status) -> u8 {
    match status {
        Status::Converged => 0,
        Status::Capped => 1,
        Status::Stalled => 2,
        Status::Open => 3,
        Status::Held => 4,
    }
}

fn name(status: Status) -> &'static str {
    ["converged", "capped", "stalled", "open", "held"][usize::from(rank(status))]
}
