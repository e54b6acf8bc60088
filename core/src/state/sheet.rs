//! From paper in physical units, or the seed's weights, to the coefficients a step reads.

use super::field::Field;
use super::leaf::Sheet;
use crate::grid::Grid;
use crate::real::{Num, Real};
use crate::scene::{PaperSpec, Units, Weights};

/// Dual regularisation of the blocks' chains; the leaf's is a dial, and the same unless turned:
/// large enough for `f32`, small enough to leave the net developable.
pub const DELTA: f64 = 1e-6;
/// Weight of in-solve contact; 400 to 10⁶ behave alike.
pub const CONTACT: f64 = 4000.0;

impl<R: Real, G: Grid> Sheet<R, G> {
    /// Fills the sheet for a leaf of `width` by `height` model units. `pull` is gravity over the gravity the
    /// seed's weights belong to: paper in physical units has its soft constraints scaled by it.
    ///
    /// ```text
    /// paper:  a = √(D l_z / 2 l_x³)   b = √(D l_x / 2 l_z³)   c = √(D / l_x l_z)   χ = 0
    /// seed:   a = √w / l_x            b = √w / l_z            c = 0                χ = 1
    /// ```
    ///
    /// so that a cylinder of curvature κ stores `D κ² / 2` per area, whichever way it is bent. Paper's
    /// masses follow the area (border rows half), the seed's are even.
    pub fn fill(&mut self, width: f64, height: f64, paper: &PaperSpec, units: &Units, pull: f64) {
        let (lx, lz) = (width / (G::NX - 1) as f64, height / (G::NZ - 1) as f64);
        let weights = paper.weights.unwrap_or_default();
        self.spacing = [R::of(lx), R::of(lz)];
        let soft = Soft::of(paper, pull, units.energy(paper.rigidity_nm()));
        self.isometry =
            isometry(weights.iso_3d * soft.isometry, [lx, lz], [width / 10.0, height / 7.0]);
        self.position = R::of(weights.position * soft.position);
        self.contact = R::of(CONTACT * soft.contact);
        let [a, b, c] = coefficients(paper, units, lx, lz);
        self.cross = if paper.weights.is_some() { R::of(1.0) } else { R::ZERO };
        self.hinge = R::of(2.0 * a * a).root();
        let even = paper.weights.is_some();
        for (i, k) in Field::<R, G>::nodes() {
            let (column, row) = (border(i, G::NX), border(k, G::NZ));
            self.mass.set(i, k, R::of(mass::<G>(even, column, row)));
            let share = |half: bool| if half && !even { R::of(0.5).root() } else { R::of(1.0) };
            let across = if column { R::ZERO } else { R::of(a) * share(row) };
            let along = if row || i == 0 { R::ZERO } else { R::of(b) * share(column) };
            self.across.set(i, k, across);
            self.along.set(i, k, along);
            let cell = i + 1 < G::NX && k + 1 < G::NZ;
            self.twist.set(i, k, if cell { R::of(c) } else { R::ZERO });
        }
        self.regularise(DELTA);
    }

    /// Sets the dual regularisation: the stars of inner nodes weigh `1/√δ`.
    pub fn regularise(&mut self, delta: f64) {
        self.delta = R::of(delta);
        let weight = R::of(1.0) / self.delta.root();
        for (i, k) in Field::<R, G>::nodes() {
            let inner = !border(i, G::NX) && !border(k, G::NZ);
            self.star.set(i, k, if inner { weight } else { R::ZERO });
        }
    }
}

/// Factors on the seed's soft constraints for paper in physical units, found on 200 gestures: the stretch
/// is least for a stiff sheet on a stiff block, drawn by a hand that is not much stiffer.
struct Soft {
    isometry: f64,
    position: f64,
    contact: f64,
}

/// Rigidity that asks for as much strength as one of the seed's gravities.
const RIGIDITY_PER_PULL: f64 = 195.0;
/// Strength at which the hand has its least weight: office paper in a book of 130 mm.
const OFFICE: f64 = 9.24;

impl Soft {
    /// Strength grows with what it has to bear: weight, or the stiffness of thick paper.
    fn of(paper: &PaperSpec, pull: f64, rigidity: f64) -> Self {
        if paper.weights.is_some() {
            return Self { isometry: 1.0, position: 1.0, contact: 1.0 };
        }
        let strength = pull.larger(rigidity / RIGIDITY_PER_PULL).larger(1.0);
        Self {
            isometry: 2.0 * strength,
            position: 2.0 * (strength / OFFICE).larger(1.0),
            contact: 5.0 * strength,
        }
    }
}

/// Share of its stiffness a leaf keeps where it rounds the gutter.
const GUTTER: f64 = 0.3;

impl<R: Real, G: Grid> Sheet<R, G> {
    /// Softens the columns that lie within `arc` of the spine: where the leaf rounds the edge of a block.
    ///
    /// The seed's spine is a rigid rectangle. In a book that has been opened before it gives there, and
    /// the feet of the leaves turn with it; a leaf as stiff at its foot as elsewhere would never lie down
    /// in a thick book. The seed's own weights are left as they are.
    pub fn soften(&mut self, arc: R, paper: &PaperSpec, units: &Units) {
        if paper.weights.is_some() {
            return;
        }
        let [lx, lz] = self.spacing.map(Real::wide);
        let [a, _, _] = coefficients(paper, units, lx, lz);
        for (i, k) in Field::<R, G>::nodes().filter(|&(i, _)| !border(i, G::NX)) {
            let inside = R::of(lx * (i as f64 - 0.5)) < arc;
            let soft = if inside { R::of(GUTTER).root() } else { R::of(1.0) };
            let half = if border(k, G::NZ) { R::of(0.5).root() } else { R::of(1.0) };
            self.across.set(i, k, R::of(a) * soft * half);
        }
    }
}

/// Compliances at a clamp and at the first nodes after it, in cells: Gregory's end correction of the trapezoid
/// rule, which would have them a half and one.
const AT_CLAMP: f64 = 9.0 / 24.0;
const AFTER_CLAMP: [f64; 2] = [28.0 / 24.0, 23.0 / 24.0];

impl<R: Real, G: Grid> Sheet<R, G> {
    /// Weighs the bending where the leaf leaves a clamp so that a small droop is exact to third order.
    ///
    /// The droop is the integral of the compliance times the moment, which the joints sample. Near the clamp the
    /// moment is steepest: left to the trapezoid rule, a strip of ten cells droops one percent too far however
    /// stiff it is. The seed's own weights are left as they are.
    pub fn clamp(&mut self, paper: &PaperSpec) {
        if paper.weights.is_some() {
            return;
        }
        self.hinge *= R::of(0.5 / AT_CLAMP).root();
        for (i, share) in (1..).zip(AFTER_CLAMP) {
            for k in 0..G::NZ {
                self.across.set(i, k, self.across.at(i, k) * R::of(1.0 / share).root());
            }
        }
    }
}

fn border(n: usize, count: usize) -> bool {
    n == 0 || n + 1 == count
}

/// Coefficients of the second differences across and along, and of the mixed one.
fn coefficients(paper: &PaperSpec, units: &Units, lx: f64, lz: f64) -> [f64; 3] {
    if let Some(Weights { bend_3d, .. }) = paper.weights {
        let w = bend_3d.root();
        return [w / lx, w / lz, 0.0];
    }
    let d = units.energy(paper.rigidity_nm());
    [
        (0.5 * d * lz / (lx * lx * lx)).root(),
        (0.5 * d * lx / (lz * lz * lz)).root(),
        (d / (lx * lz)).root(),
    ]
}

/// Mass of a node; the leaf's is one.
fn mass<G: Grid>(even: bool, column: bool, row: bool) -> f64 {
    if even {
        return 1.0 / (G::NX * G::NZ) as f64;
    }
    let half = |border: bool| if border { 0.5 } else { 1.0 };
    half(column) * half(row) / ((G::NX - 1) * (G::NZ - 1)) as f64
}

/// Weights of edges across and along: the given one at 11x8, elsewhere so that the sheet is as stiff.
fn isometry<R: Real>(w: f64, [lx, lz]: [f64; 2], [x0, z0]: [f64; 2]) -> [R; 2] {
    let cubed = |v: f64| v * v * v;
    [R::of(w * (lz / z0) * cubed(x0 / lx)), R::of(w * (lx / x0) * cubed(z0 / lz))]
}
