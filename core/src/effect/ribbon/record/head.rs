//! Lists of fields: what a ribbon was opened with, its state, what it was asked.

use crate::effect::ribbon::frame::Frame;
use crate::effect::ribbon::load::{Ask, GUIDES, Guide, SPRINGS, Spring};
use crate::effect::ribbon::newton::Solver;
use crate::effect::ribbon::spec::{Bending, Closure, Mass, Resample, RibbonSpec, Root};
use crate::effect::ribbon::{Ribbon, Settings};
use crate::real::{Real, V3};
use crate::record::code::coded;
use crate::record::header::this_build;
use crate::record::wire::{Done, Wire};
use crate::record::{RecordError, Tier};
use heapless::Vec;

coded!(Bending, "bending energy", Sadowsky = 0, Wunderlich = 1);
coded!(Mass, "spread of mass", Consistent = 0, Lumped = 1);
coded!(Resample, "interpolation", Smooth = 0, Linear = 1);
coded!(Root, "start of a ribbon", Clamp = 0, Segment = 1, Free = 2);
coded!(Closure, "closure", Open = 0, Ring = 1, Moebius = 2);

/// Tags of the stream.
pub(super) const ASKED: u8 = 1;
pub(super) const BASE: u8 = 2;
pub(super) const STEP: u8 = 3;
pub(super) const END: u8 = 255;

/// What a ribbon was opened with, and by whom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Head {
    pub(super) tier: Tier,
    pub(super) made_by: u64,
    pub(super) spec: RibbonSpec,
    pub(super) origin: [f64; 3],
}

impl Head {
    pub(super) fn of<R: Real, const N: usize>(ribbon: &Ribbon<R, N>) -> Self {
        let (tier, made_by) = (Tier::of::<R>(), this_build());
        Self { tier, made_by, spec: *ribbon.spec(), origin: ribbon.origin() }
    }
    pub(super) fn blank() -> Self {
        let spec = RibbonSpec::default();
        Self { tier: Tier::F32, made_by: 0, spec, origin: [0.0; 3] }
    }
    pub(super) fn same_build(&self) -> bool {
        self.made_by == this_build()
    }
    /// All fields from the version on.
    pub(super) fn fields(&mut self, wire: &mut impl Wire) -> Done {
        let Self { tier, made_by, spec, origin } = self;
        wire.code(tier)?;
        wire.u64(made_by)?;
        spec_fields(spec, wire)?;
        wire.point(origin)
    }
}

fn size(field: &mut usize, wire: &mut impl Wire) -> Done {
    let mut short = u32::try_from(*field).unwrap_or(u32::MAX);
    wire.u32(&mut short)?;
    *field = short as usize;
    Ok(())
}

fn spec_fields(spec: &mut RibbonSpec, wire: &mut impl Wire) -> Done {
    let RibbonSpec {
        length_m,
        width_m,
        segments,
        rigidity_nm,
        areal_mass_gsm,
        regularisation,
        damping_per_s,
        bending,
        mass,
        resample,
        root,
        closure,
        perturbation,
        seed,
    } = spec;
    let numbers = [length_m, width_m, rigidity_nm, areal_mass_gsm, regularisation];
    numbers.into_iter().chain([damping_per_s, perturbation]).try_for_each(|x| wire.f64(x))?;
    size(segments, wire)?;
    wire.code(bending)?;
    wire.code(mass)?;
    wire.code(resample)?;
    wire.code(root)?;
    wire.code(closure)?;
    wire.u64(seed)
}

fn real<R: Real>(field: &mut R, wire: &mut impl Wire) -> Done {
    let mut wide = field.wide();
    wire.f64(&mut wide)?;
    *field = R::of(wide);
    Ok(())
}

fn vector<R: Real>(field: &mut V3<R>, wire: &mut impl Wire) -> Done {
    field.0.iter_mut().try_for_each(|x| real(x, wire))
}

/// A frame.
pub(super) fn frame<R: Real>(field: &mut Frame<R>, wire: &mut impl Wire) -> Done {
    let Frame { t, b, n, p } = field;
    [t, b, n, p].into_iter().try_for_each(|v| vector(v, wire))
}

/// Everything that decides the future of an opened ribbon, out of it or into it.
pub(super) fn state<R: Real, const N: usize>(
    ribbon: &mut Ribbon<R, N>,
    wire: &mut impl Wire,
) -> Done {
    let (body, solver) = ribbon.memory();
    frame(&mut body.kept_base, wire)?;
    body.joint.iter_mut().chain(&mut body.hold.lambda).try_for_each(|x| real(x, wire))?;
    // Taken apart, so that what else it may carry does not compile here until it has a place.
    let Solver { shift } = solver;
    real(shift, wire)?;
    for s in body.used_mut() {
        real(&mut s.kept.psi, wire)?;
        real(&mut s.kept.c, wire)?;
        s.velocity.iter_mut().try_for_each(|v| vector(v, wire))?;
    }
    body.end.velocity.iter_mut().try_for_each(|v| vector(v, wire))
}

/// Numbers that the solver carries.
const CARRIED: usize = 1;

/// Numbers of a state of so many segments.
pub(super) const fn state_numbers(segments: usize) -> usize {
    26 + CARRIED + 8 * segments
}

/// What a ribbon is asked.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Asked {
    gravity: [f64; 3],
    settings: Settings,
    springs: Vec<Spring<f64>, SPRINGS>,
    guides: Vec<Guide<f64>, GUIDES>,
}

const NO_SPRING: Spring<f64> = Spring { crease: 0, rim: 0, target: V3([0.0; 3]), stiffness: 0.0 };
const NO_GUIDE: Guide<f64> = Guide { segment: 0, normal: V3([0.0; 3]), stiffness: 0.0 };

impl Asked {
    pub(super) fn nothing() -> Self {
        let (springs, guides) = (Vec::new(), Vec::new());
        Self { gravity: [0.0; 3], settings: Settings::STEP, springs, guides }
    }
    pub(super) fn of<R: Real, const N: usize>(ribbon: &Ribbon<R, N>) -> Self {
        let wide = |v: V3<R>| V3(v.0.map(|x| x.wide()));
        let spring = |s: &Spring<R>| {
            let (target, stiffness) = (wide(s.target), s.stiffness.wide());
            Spring { crease: s.crease, rim: s.rim, target, stiffness }
        };
        let guide = |g: &Guide<R>| {
            let (normal, stiffness) = (wide(g.normal), g.stiffness.wide());
            Guide { segment: g.segment, normal, stiffness }
        };
        Self {
            gravity: ribbon.gravity,
            settings: ribbon.settings,
            springs: ribbon.ask.springs.iter().map(spring).collect(),
            guides: ribbon.ask.guides.iter().map(guide).collect(),
        }
    }
    pub(super) fn give<R: Real, const N: usize>(&self, ribbon: &mut Ribbon<R, N>) {
        let narrow = |v: V3<f64>| V3(v.0.map(R::of));
        let spring = |s: &Spring<f64>| {
            let (target, stiffness) = (narrow(s.target), R::of(s.stiffness));
            Spring { crease: s.crease, rim: s.rim, target, stiffness }
        };
        let guide = |g: &Guide<f64>| {
            let (normal, stiffness) = (narrow(g.normal), R::of(g.stiffness));
            Guide { segment: g.segment, normal, stiffness }
        };
        (ribbon.gravity, ribbon.settings) = (self.gravity, self.settings);
        ribbon.ask = Ask {
            springs: self.springs.iter().map(spring).collect(),
            guides: self.guides.iter().map(guide).collect(),
        };
    }
    pub(super) fn fields(&mut self, wire: &mut impl Wire) -> Done {
        let Self { gravity, settings, springs, guides } = self;
        let Settings { iterations, tolerance, closure, trials, shifts, barrier, thorough } =
            settings;
        wire.point(gravity)?;
        [iterations, trials, shifts].into_iter().try_for_each(|n| wire.u32(n))?;
        [tolerance, closure, barrier].into_iter().try_for_each(|x| wire.f64(x))?;
        let mut search = u8::from(*thorough);
        wire.u8(&mut search)?;
        *thorough = search != 0;
        list(springs, &NO_SPRING, "number of springs", wire)?;
        for Spring { crease, rim, target, stiffness } in springs {
            size(crease, wire)?;
            let mut side = u8::from(*rim != 0);
            wire.u8(&mut side)?;
            *rim = usize::from(side);
            vector(target, wire)?;
            wire.f64(stiffness)?;
        }
        list(guides, &NO_GUIDE, "number of guides", wire)?;
        for Guide { segment, normal, stiffness } in guides {
            size(segment, wire)?;
            vector(normal, wire)?;
            wire.f64(stiffness)?;
        }
        Ok(())
    }
}

/// The length of a list, and as many places.
fn list<T: Clone, const M: usize>(
    list: &mut Vec<T, M>,
    blank: &T,
    name: &'static str,
    wire: &mut impl Wire,
) -> Done {
    let mut length = list.len() as u8;
    wire.u8(&mut length)?;
    let length = usize::from(length);
    list.truncate(length);
    while list.len() < length {
        list.push(blank.clone()).map_err(|_| RecordError::Unknown(name))?;
    }
    Ok(())
}
