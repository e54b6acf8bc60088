//! Systems of the size, pattern and conditioning of the seed's full KKT (its eq. 3-4), made without the core.
//!
//! A leaf of 11 x 8 nodes bends over the spine in 83 poses; the two blocks and the cover lie still. The
//! terms are those of a step with one Newton iteration: masses over the squared step, bending between
//! second neighbours, stretched edges, glue; rows for equal angles, lengths, the binding, the fixed spine.
//! The tests of the solvers run on it: the poses are drawn, so that no change of the core moves them.

use crate::matrices::Matrices;
use crate::triplets::Triplets;

const NX: usize = 11;
const NZ: usize = 8;
const MIDLINE: usize = 15;
/// The midline edge that the leaf is bound to starts at this node.
const BINDING: usize = 7;
const COVER: usize = 2;
const POSES: usize = 83;

/// The leaf's first column stays in its plane: no z there.
const LEAF: usize = 3 * NX * NZ - NZ;
const PRIMAL: usize = LEAF + 2 * MIDLINE + 2 * COVER;
const STARS: usize = (NX - 2) * (NZ - 2);
const DUAL: usize = 3 * STARS + (MIDLINE - 1 + COVER) + 2 * NZ + 2;

const WIDTH: f64 = 12.0;
const STEP_ACROSS: f64 = WIDTH / (NX - 1) as f64;
const STEP_ALONG: f64 = 2.36;
const BLOCK_STEP: f64 = WIDTH / 7.0;
const PER_STEP_SQ: f64 = 60.0 * 60.0;
const NODE_MASS: f64 = 1.0 / (NX * NZ) as f64;
const BLOCK_MASS: f64 = 14.0;
const BEND_LEAF: f64 = 120.0;
const BEND_BLOCK: f64 = 200.0;
const ISOMETRY: f64 = 4000.0;
const GLUE: f64 = 600.0;
/// Keeps a flat leaf from being singular; small enough to change nothing else.
const DUAL_DIAGONAL: f64 = -1e-8;
/// The place along the binding edge.
const Q: f64 = 0.4;

type Vec3 = [f64; 3];

/// The systems of one page turn.
pub(crate) fn page_turn() -> Matrices {
    let n = PRIMAL + DUAL;
    let mut set = Matrices {
        name: "synthetic full KKT, 11x8",
        n,
        starts: Vec::new(),
        rows: Vec::new(),
        values: Vec::new(),
        rhs: Vec::new(),
    };
    for pose in 0..POSES {
        let kkt = Pose::new(pose as f64 / (POSES - 1) as f64).kkt();
        if pose == 0 {
            (set.starts, set.rows) = kkt.pattern(n);
        }
        set.values.extend(kkt.values());
        set.rhs.extend((0..n).map(|i| ((i * 37 + pose * 11) as f64).sin()));
    }
    set
}

/// Where everything is at one moment.
#[derive(Debug)]
struct Pose {
    leaf: Vec<Vec3>,
    midline: Vec<[f64; 2]>,
    cover: [[f64; 2]; COVER],
}

/// The index of a leaf's coordinate in the unknowns; `None` for what is held.
fn leaf_dof(node: usize, axis: usize) -> Option<usize> {
    let held = 2 * NZ;
    match (node < NZ, axis) {
        (true, 2) => None,
        (true, _) => Some(2 * node + axis),
        (false, _) => Some(held + 3 * (node - NZ) + axis),
    }
}

fn midline_dof(node: usize, axis: usize) -> usize {
    LEAF + 2 * node + axis
}

fn cover_dof(side: usize, axis: usize) -> usize {
    LEAF + 2 * MIDLINE + 2 * side + axis
}

fn node(i: usize, k: usize) -> usize {
    i * NZ + k
}

impl Pose {
    /// `t` from 0 (leaf on the right) to 1 (on the left), bent and slightly conical in between.
    fn new(t: f64) -> Self {
        let midline: Vec<[f64; 2]> =
            (0..MIDLINE).map(|m| [(m as f64 - 7.5) * BLOCK_STEP, 0.2 * (m as f64).sin()]).collect();
        let cover = [[-WIDTH - 1.0, -0.3], [WIDTH + 1.0, -0.3]];
        let at = |axis: usize| (1.0 - Q) * midline[BINDING][axis] + Q * midline[BINDING + 1][axis];
        let mut leaf = vec![[0.0; 3]; NX * NZ];
        for k in 0..NZ {
            let along = k as f64 / (NZ - 1) as f64 - 0.5;
            let curl = 0.09 * (1.0 + 0.4 * along) * (std::f64::consts::PI * t).sin() + 0.004;
            let mut angle = 0.15 + 2.8 * t + 0.2 * along;
            let mut p = [at(0), at(1), k as f64 * STEP_ALONG];
            for i in 0..NX {
                leaf[node(i, k)] = p;
                angle -= curl * STEP_ACROSS;
                p = [p[0] + STEP_ACROSS * angle.cos(), p[1] + STEP_ACROSS * angle.sin(), p[2]];
            }
        }
        Self { leaf, midline, cover }
    }

    fn kkt(&self) -> Triplets {
        let mut k = Triplets::default();
        inertia(&mut k);
        bending(&mut k);
        self.isometry(&mut k);
        self.glue(&mut k);
        self.angles(&mut k);
        self.lengths(&mut k);
        binding(&mut k);
        for row in PRIMAL..PRIMAL + DUAL {
            k.add(row, row, DUAL_DIAGONAL);
        }
        k
    }

    /// Every leaf edge but those along the spine: `8 w e e^T + 4 w max(|e|^2 - l^2, 0) I`.
    fn isometry(&self, k: &mut Triplets) {
        for (a, b, rest) in leaf_edges() {
            let e = sub(self.leaf[a], self.leaf[b]);
            let over = (dot(e, e) - rest * rest).max(0.0);
            for (r, c) in axes() {
                let h = 8.0 * e[r] * e[c] + if r == c { 4.0 * over } else { 0.0 };
                couple(k, a, b, r, c, ISOMETRY * h);
            }
        }
    }

    /// The leaf leaves the binding at a right angle: `2 w dc dc^T` over the first segment and the binding edge.
    fn glue(&self, k: &mut Triplets) {
        let (m, n) = (self.midline[BINDING], self.midline[BINDING + 1]);
        for row in 0..NZ {
            let d = sub(self.leaf[node(1, row)], self.leaf[node(0, row)]);
            let normal = [m[1] - n[1], n[0] - m[0]];
            let scale = 1.0 / (BLOCK_STEP * STEP_ACROSS);
            let mut dc: Vec<(usize, f64)> = Vec::new();
            for (axis, (normal, turned)) in normal.into_iter().zip([-d[1], d[0]]).enumerate() {
                dc.extend(leaf_dof(node(1, row), axis).map(|dof| (dof, normal)));
                dc.extend(leaf_dof(node(0, row), axis).map(|dof| (dof, -normal)));
                dc.push((midline_dof(BINDING, axis), turned));
                dc.push((midline_dof(BINDING + 1, axis), -turned));
            }
            for (i, a) in &dc {
                for (j, b) in &dc {
                    k.add(*i, *j, 2.0 * GLUE * scale * scale * a * b);
                }
            }
        }
    }

    /// Three rows per star: `(<a,b>|c| - <b,c>|a|) / l^3`, each over three arms and the centre.
    fn angles(&self, k: &mut Triplets) {
        let mut row = PRIMAL;
        for (centre, arms) in stars() {
            let e = arms.map(|arm| sub(self.leaf[arm], self.leaf[centre]));
            for pick in [[0, 1, 2], [1, 2, 3], [3, 0, 1]] {
                let [a, b, c] = pick.map(|p| e[p]);
                let (la, lc) = (dot(a, a).sqrt(), dot(c, c).sqrt());
                let scale = 1.0 / (STEP_ACROSS * STEP_ACROSS * STEP_ALONG);
                let mut sum = [0.0; 3];
                for axis in 0..3 {
                    let grad = [
                        b[axis] * lc - dot(b, c) * a[axis] / la,
                        a[axis] * lc - c[axis] * la,
                        dot(a, b) * c[axis] / lc - b[axis] * la,
                    ];
                    for (p, g) in pick.iter().zip(grad) {
                        sum[axis] -= g;
                        constrain(k, row, leaf_dof(arms[*p], axis), scale * g);
                    }
                    constrain(k, row, leaf_dof(centre, axis), scale * sum[axis]);
                }
                row += 1;
            }
        }
    }

    /// Edges of the midline and of the cover do not stretch.
    fn lengths(&self, k: &mut Triplets) {
        let first = PRIMAL + 3 * STARS;
        for m in 0..MIDLINE - 1 {
            for axis in 0..2 {
                let d = (self.midline[m + 1][axis] - self.midline[m][axis]) / BLOCK_STEP;
                constrain(k, first + m, Some(midline_dof(m + 1, axis)), d);
                constrain(k, first + m, Some(midline_dof(m, axis)), -d);
            }
        }
        for side in 0..COVER {
            let hinge = BINDING + side;
            for axis in 0..2 {
                let d = (self.cover[side][axis] - self.midline[hinge][axis]) / WIDTH;
                let row = first + MIDLINE - 1 + side;
                constrain(k, row, Some(cover_dof(side, axis)), d);
                constrain(k, row, Some(midline_dof(hinge, axis)), -d);
            }
        }
    }
}

fn inertia(k: &mut Triplets) {
    for dof in 0..PRIMAL {
        let mass = if dof < LEAF { NODE_MASS } else { BLOCK_MASS };
        k.add(dof, dof, mass * PER_STEP_SQ);
    }
}

/// `2 w L^T L` of the leaf (inner stars, and triples along its free border) and of the two blocks.
fn bending(k: &mut Triplets) {
    let mut stencils: Vec<Vec<(usize, f64)>> =
        stars().map(|(c, [f, u, b, d])| laplacian(c, &[f, b], &[u, d])).collect();
    stencils.extend(
        (1..NZ - 1)
            .map(|z| laplacian(node(NX - 1, z), &[], &[node(NX - 1, z - 1), node(NX - 1, z + 1)])),
    );
    for z in [0, NZ - 1] {
        stencils.extend(
            (1..NX - 1).map(|i| laplacian(node(i, z), &[node(i - 1, z), node(i + 1, z)], &[])),
        );
    }
    for s in &stencils {
        for axis in 0..3 {
            let dofs = s.iter().filter_map(|(n, w)| Some((leaf_dof(*n, axis)?, *w)));
            square(k, &dofs.collect::<Vec<_>>(), 2.0 * BEND_LEAF);
        }
    }
    // Not at the binding, where the glue has its say.
    for m in (1..MIDLINE - 1).filter(|m| *m != BINDING && *m != BINDING + 1) {
        for axis in 0..2 {
            let s = [(m - 1, -1.0), (m, 2.0), (m + 1, -1.0)]
                .map(|(n, w)| (midline_dof(n, axis), w / BLOCK_STEP));
            square(k, &s, 2.0 * BEND_BLOCK);
        }
    }
}

/// The leaf's first column lies on the binding edge; the middle of that edge is fixed.
fn binding(k: &mut Triplets) {
    let first = PRIMAL + 3 * STARS + MIDLINE - 1 + COVER;
    for axis in 0..2 {
        for row in 0..NZ {
            let at = first + 2 * row + axis;
            constrain(k, at, leaf_dof(node(0, row), axis), 1.0);
            constrain(k, at, Some(midline_dof(BINDING, axis)), Q - 1.0);
            constrain(k, at, Some(midline_dof(BINDING + 1, axis)), -Q);
        }
        constrain(k, first + 2 * NZ + axis, Some(midline_dof(BINDING, axis)), 0.5);
        constrain(k, first + 2 * NZ + axis, Some(midline_dof(BINDING + 1, axis)), 0.5);
    }
}

fn constrain(k: &mut Triplets, row: usize, dof: Option<usize>, v: f64) {
    if let Some(dof) = dof {
        k.add_both(row, dof, v);
    }
}

/// Adds the 3x3 block's entry `(r, c)` of an edge `a - b` at its four places.
fn couple(k: &mut Triplets, a: usize, b: usize, r: usize, c: usize, v: f64) {
    for (i, j, sign) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
        if let (Some(row), Some(col)) = (leaf_dof(i, r), leaf_dof(j, c)) {
            k.add(row, col, sign * v);
        }
    }
}

fn square(k: &mut Triplets, row: &[(usize, f64)], weight: f64) {
    for (i, a) in row {
        for (j, b) in row {
            k.add(*i, *j, weight * a * b);
        }
    }
}

/// `sum of (p0 - p_j) / l_j` as node weights.
fn laplacian(centre: usize, across: &[usize], along: &[usize]) -> Vec<(usize, f64)> {
    let arms = across
        .iter()
        .map(|n| (*n, -1.0 / STEP_ACROSS))
        .chain(along.iter().map(|n| (*n, -1.0 / STEP_ALONG)));
    let mut row: Vec<(usize, f64)> = arms.collect();
    row.push((centre, -row.iter().map(|(_, w)| w).sum::<f64>()));
    row
}

/// Inner nodes with their arms: forward across, forward along, backward across, backward along.
fn stars() -> impl Iterator<Item = (usize, [usize; 4])> {
    let inner = (1..NX - 1).flat_map(|i| (1..NZ - 1).map(move |k| (i, k)));
    inner.map(|(i, k)| {
        (node(i, k), [node(i + 1, k), node(i, k + 1), node(i - 1, k), node(i, k - 1)])
    })
}

/// Edges with their rest lengths.
fn leaf_edges() -> impl Iterator<Item = (usize, usize, f64)> {
    let across =
        (1..NX).flat_map(|i| (0..NZ).map(move |k| (node(i, k), node(i - 1, k), STEP_ACROSS)));
    let along =
        (1..NX).flat_map(|i| (1..NZ).map(move |k| (node(i, k), node(i, k - 1), STEP_ALONG)));
    across.chain(along)
}

fn axes() -> impl Iterator<Item = (usize, usize)> {
    (0..3).flat_map(|r| (0..3).map(move |c| (r, c)))
}

fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{DUAL, POSES, PRIMAL, page_turn};

    #[test]
    fn the_size_of_the_seeds_system() {
        let set = page_turn();
        assert_eq!((PRIMAL, DUAL, set.count()), (290, 196, POSES));
        assert!((9000..9900).contains(&set.entries()), "{} entries", set.entries());
        assert_eq!(set.values.len(), POSES * set.entries(), "every pose has the same pattern");
    }

    #[test]
    fn every_matrix_is_symmetric() {
        let set = page_turn();
        let last = &set.values[(POSES - 1) * set.entries()..];
        let columns = (0..set.n)
            .flat_map(|col| (set.starts[col]..set.starts[col + 1]).map(move |_| col as i32));
        let entries: BTreeMap<(i32, i32), f64> =
            set.rows.iter().copied().zip(columns).zip(last.iter().copied()).collect();
        for ((row, col), v) in &entries {
            let mirror = entries.get(&(*col, *row)).expect("the mirror place exists");
            assert!((mirror - v).abs() <= 1e-9 * v.abs(), "({row}, {col})");
        }
    }
}
