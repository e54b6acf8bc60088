//! A leaf in a random smooth curved pose, held, touched and moving: what a step meets in earnest.

use crate::random::Pcg;
use dogleaf_core::grid::Grid;
use dogleaf_core::kkt::{Factor, Stencil};
use dogleaf_core::real::{Real, V2, V3};
use dogleaf_core::scene::units::WIDTH;
use dogleaf_core::scene::{PaperSpec, Units, Weights};
use dogleaf_core::state::{Field, Grab, Leaf, Root, Sheet};
use dogleaf_core::step::Ask;
use dogleaf_core::step::assemble::assemble;
use dogleaf_core::step::constant::Constant;
use dogleaf_core::step::matrix::Matrix;
use dogleaf_core::step::merit::merit;

/// Height of the leaf over its width.
const TALL: f64 = 1.4;

/// A leaf, where its inertia would carry it, and what is asked of the step.
#[derive(Debug, Clone)]
pub struct Posed<R: Real, G: Grid> {
    /// What it is made of.
    pub sheet: Sheet<R, G>,
    /// Where it is.
    pub leaf: Leaf<R, G>,
    /// `x̃`.
    pub aim: Field<R, G>,
    /// The step.
    pub ask: Ask<R>,
}

/// The seed's weights instead of a plate's.
pub fn seed_paper() -> PaperSpec {
    PaperSpec { weights: Some(Weights::default()), ..PaperSpec::default() }
}

impl<R: Real, G: Grid> Posed<R, G> {
    /// A flat leaf of this paper, hinged, at rest in the void.
    pub fn flat(paper: &PaperSpec) -> Self {
        let units = Units::of_leaf(0.13, 0.13 * TALL, paper.areal_mass_gsm);
        let mut sheet = Sheet::ZERO;
        sheet.fill(WIDTH, WIDTH * TALL, paper, &units, 1.0);
        let mut leaf = Leaf::ZERO;
        let places = (0..G::NX).map(|i| V2([sheet.spacing[0] * R::of(i as f64), R::ZERO]));
        leaf.lay(sheet.spacing, places);
        let aim = leaf.x.clone();
        let h = R::of(1.0 / 60.0);
        let ask = Ask { h, keep: R::of(1.0), gravity: V3::zero(), root: Root::Hinge, grab: None };
        Self { sheet, leaf, aim, ask }
    }

    /// A leaf of this paper rolled and waved, moving, in contact here and there, held by the hand.
    pub fn curved(paper: &PaperSpec, random: &mut Pcg) -> Self {
        let mut posed = Self::flat(paper);
        posed.roll(random);
        posed.carry(random);
        posed.touch(random);
        posed.ask.gravity = V3([R::of(3.0), R::of(-98.1), R::of(1.0)]);
        let node = (G::NX - 2, 1);
        let target = posed.leaf.x.at(node.0, node.1) + near(random, 1.0);
        posed.ask.grab = Some(Grab { node, target, firm: R::of(1.0) });
        posed
    }

    /// Onto an arc, with waves along and across; the spine stays.
    fn roll(&mut self, random: &mut Pcg) {
        let bend = random.within(0.05, 0.15);
        let phase = random.numbers(6);
        let [lx, lz] = self.sheet.spacing.map(Real::wide);
        for (i, k) in Field::<R, G>::nodes().filter(|n| n.0 > 0) {
            let (s, z) = (lx * i as f64, lz * ((G::NZ - 1) as f64 * 0.5 - k as f64));
            let (angle, share) = (bend * s, i as f64 / G::NX as f64);
            let wave = |n: usize| 0.3 * share * (0.4 * s + 0.3 * z + 3.0 * phase[n]).sin();
            let arc = [angle.sin() / bend, (1.0 - angle.cos()) / bend, z];
            let place = [arc[0] + wave(0), arc[1] + 2.0 * wave(1), arc[2] + wave(2)];
            self.leaf.x.set(i, k, V3(place.map(R::of)));
        }
    }

    fn carry(&mut self, random: &mut Pcg) {
        for (i, k) in Field::<R, G>::nodes() {
            self.aim.set(i, k, self.leaf.x.at(i, k) + near(random, 0.2));
        }
    }

    /// Every third node was pushed by the last collision pass.
    fn touch(&mut self, random: &mut Pcg) {
        for (i, k) in Field::<R, G>::nodes().filter(|(i, k)| (i + 2 * k) % 3 == 0) {
            let angle = random.within(0.0, 3.0);
            let n = V2([angle.cos(), angle.sin()].map(R::of));
            let offset = n.dot(self.leaf.x.at(i, k).xy()) + R::of(random.within(-0.1, 0.1));
            self.leaf.pushed.set(i, k, V3([n.0[0], n.0[1], offset]));
            self.leaf.holding.set(i, k, R::of(1.0));
        }
    }

    /// Matrix and gradient at the pose, as a step assembles them.
    pub fn assembled(&self) -> (Factor<R, G>, Field<R, G>) {
        let (mut factor, mut g) = (Factor::ZERO, Field::ZERO);
        let mut constant = Constant::ZERO;
        constant.fill(&self.sheet, self.ask.h, self.ask.root);
        let mut inertia = Field::ZERO;
        let rate = R::of(1.0) / (self.ask.h * self.ask.h);
        for (i, k) in Field::<R, G>::nodes() {
            let away = self.leaf.x.at(i, k) - self.aim.at(i, k);
            inertia.set(i, k, away * (self.sheet.mass.at(i, k) * rate));
        }
        let mut stencil = Stencil::ZERO;
        let (constant, stencil) = (&constant, &mut stencil);
        let mut matrix = Matrix { constant, stencil, factor: &mut factor };
        assemble(&self.sheet, &self.leaf, &inertia, &self.ask, &mut matrix, &mut g);
        (factor, g)
    }

    /// `Φ + ‖C‖² / 2δ` at the pose, of the line search's merit.
    pub fn energy(&self) -> R {
        let parts = merit(&self.sheet, &self.leaf, &self.leaf.x, &self.aim, &self.ask);
        parts.energy + parts.residual * parts.residual / (R::of(2.0) * self.sheet.delta)
    }

    /// The free coordinates, in the order of the unknowns.
    pub fn unknowns(&self) -> Vec<R> {
        unknowns(&self.leaf.x)
    }

    /// The same leaf with these free coordinates.
    #[must_use]
    pub fn at(&self, unknowns: &[R]) -> Self {
        let mut moved = self.clone();
        for ((i, k), place) in free::<R, G>().zip(unknowns.chunks(3)) {
            moved.leaf.x.set(i, k, V3([place[0], place[1], place[2]]));
        }
        moved
    }
}

/// The vectors of all free nodes, in the order of the unknowns.
pub fn unknowns<R: Real, G: Grid>(field: &Field<R, G>) -> Vec<R> {
    free::<R, G>().flat_map(|(i, k)| field.at(i, k).0).collect()
}

/// The free nodes, in the order of the unknowns.
pub fn free<R: Real, G: Grid>() -> impl Iterator<Item = (usize, usize)> {
    Field::<R, G>::nodes().filter(|n| n.0 > 0)
}

fn near<R: Real>(random: &mut Pcg, size: f64) -> V3<R> {
    V3(random.v3().0.map(|c| R::of(size * c)))
}
