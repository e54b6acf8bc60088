//! The gradient of everything that is minimised, alone: for oracles, for methods without a Hessian, and for tests.
//!
//! Rigid-body statics: a crease's gradient is the moment about its axis of all that pulls beyond it.
//!
//! Source: Ribbon App. C, whose products of 4x4 matrices it replaces by one wrench. Checked by
//! `tests/ribbon_derivatives.rs`.

use super::barrier::wall;
use super::bending;
use super::body::Body;
use super::contact::touch::Touch;
use super::forces::Pushed;
use super::frame::{Six, dot6};
use super::inertia::Common;
use super::joint::{Crease, about};
use super::load::{Ask, Loads, Pull};
use super::resample::Pair;
use super::sweep::pulls;
use crate::real::{Real, V3};

impl<R: Real, const N: usize> Body<R, N> {
    /// Adjoint sweep (Ribbon App. C): hands each crease's gradient to `take`, last crease first; answers the start's.
    ///
    /// # Cost
    ///
    /// That of assembling; for oracles and tests.
    pub fn gradient(
        &self,
        ask: &Ask<R>,
        loads: &impl Loads<R>,
        touch: &impl Touch<R>,
        mut take: impl FnMut(usize, [R; 2]),
    ) -> Six<R> {
        let strip = &self.strip;
        let common = Common::of(strip, &self.motion, R::ZERO, |x| x);
        let mut beyond = [R::ZERO; 6];
        let mut at_start = [R::ZERO; 6];
        if self.looped() {
            [beyond, at_start] = self.hold.gradient(&self.gap);
        }
        let none: Pair<R> = [V3([R::ZERO; 3]); 2];
        let mut pull = Pull::none();
        pulls(ask, loads, strip.n, &self.end.pair, &mut pull);
        let mut pulled = pull.gradient;
        let mut carried = [R::ZERO; 2];
        let mut next = (self.end.pair, self.end.want, Crease::default());
        for (j, s) in self.used().iter().enumerate().rev() {
            let near = j.checked_sub(1).and_then(|i| self.stages.get(i));
            let f = near.map_or(&self.base, |s| &s.frame);
            pulls(ask, loads, j, &s.pair, &mut pull);
            let own = pull.gradient;
            let cell = Self::cell(s, (&next.0, &next.1, next.2.c));
            let mut m = common.model(&cell);
            let pulls = [own, pulled];
            let pushed = Pushed { x: cell.x, pulls, lean: ask.guide(j), rough: R::ZERO };
            let more = pushed.model(strip, &s.frame, (touch, j));
            m.x.iter_mut().zip(&more.x).for_each(|(x, &m)| *x += m);
            m.c = [m.c[0] + more.c[0], m.c[1] + more.c[1]];
            let bent = bending::derivatives(strip, j, s.crease, next.2);
            let w = wall(cell.spread, strip.limit, self.mu, s.dual);
            if j + 1 < strip.n {
                take(j + 1, [carried[0] + bent.g[2], carried[1] + bent.g[3] + m.c[1] + w.slope]);
            }
            for (b, &x) in beyond.iter_mut().zip(&m.x) {
                *b += x;
            }
            let step = if j == 0 { R::ZERO } else { strip.cell };
            let [a, b] = s.turn.axes(f).map(|a| dot6(&about(a, f.p + f.t * step), &beyond));
            carried = [a + bent.g[0], b + bent.g[1] + m.c[0] - w.slope];
            pulled = none;
            next = (s.pair, s.want, s.crease);
        }
        take(0, carried);
        for (b, &s) in beyond.iter_mut().zip(&at_start) {
            *b += s;
        }
        beyond
    }
}
