//! The leaf in the air: refined, offset on both sides, each side of true width, and its rim.
//!
//! | step | what | where it stands |
//! |---|---|---|
//! | across | splines through the rows of the net, kept out of the blocks | `up` |
//! | along | splines through those columns | `up`, then `down` |
//! | normals | from neighbours on the refined net | `down` |
//! | sides | offset by half the thickness, row by row, and walked | `up`, `down` |
//! | rim | between the borders of both | `rim` |

use super::clear::Clear;
use super::curve::{Knot, Polyline, unit};
use super::fold::Rows;
use super::layout::{ALONG, Layout};
use super::normals::{Net, direction};
use super::{Vertex, columns, spline};
use crate::book::Book;
use crate::grid::Grid;
use crate::real::{LANES, Lanes, Num, Real, V3};
use crate::scene::units::WIDTH;
use crate::state::field::blocks;
use crate::state::{Leaf, Sheet};

/// A corner of an offset row this little ahead of the last one, as a share of two columns, is dropped.
const LEAST: f32 = 0.1;
/// Rounds of smoothing a side gets where it is folded upon itself.
const MENDINGS: usize = 40;

/// What the sides of a leaf are drawn with.
#[derive(Debug, Clone, Copy)]
struct Pen {
    half: f32,
    columns: usize,
    rows: usize,
}

/// Fills the leaf's three parts.
pub(super) fn write<R: Real, G: Grid>(book: &Book<R, G>, leaf: &Leaf<R, G>, out: &mut [Vertex]) {
    let (columns, rows) = (Layout::<G>::COLUMNS, Layout::<G>::ROWS);
    let size = columns * rows;
    let Some((up, rest)) = out.split_at_mut_checked(size) else { return };
    let Some((down, rim)) = rest.split_at_mut_checked(size) else { return };
    let half = book.binding().half_held();
    let clear =
        Clear::new(book.binding().profiles(book.blocks()), book.blocks(), half, columns - 1);
    across(book.sheet(), leaf, &clear, up);
    along::<G>(up, down);
    let net = Net { columns, rows, side: 1.0 };
    net.normals(down);
    let metres = book.units().metres as f32;
    let pen = Pen { half: half.narrow(), columns, rows };
    let mut line = Polyline::new();
    for row in 0..rows {
        let at = Row { row, rows };
        at.offset(down, 1.0, &pen, &mut line);
        pen.draw(&at, up, 1.0, &line);
        at.offset(down, -1.0, &pen, &mut line);
        pen.draw(&at, down, -1.0, &line);
    }
    for (side, vertices) in [(1.0, &mut *up), (-1.0, &mut *down)] {
        mend(&Net { side, ..net }, vertices, &pen, &mut line);
        vertices.iter_mut().for_each(|v| v.position = (V3(v.position) * metres).0);
    }
    pen.rim(up, down, rim);
}

/// Normals of a side; where it is folded through itself, so that there are none, it is drawn straighter,
/// over more and more columns.
fn mend(net: &Net, vertices: &mut [Vertex], pen: &Pen, line: &mut Polyline) {
    net.normals(vertices);
    for round in 0..MENDINGS {
        let Some((first, last)) = net.folds(vertices) else { return };
        for _ in 0..=round / 8 {
            net.smooth(vertices, first.saturating_sub(round), last + round);
        }
        for row in 0..net.rows {
            let at = Row { row, rows: net.rows };
            at.trace(vertices, line);
            pen.draw(&at, vertices, net.side, line);
        }
        net.normals(vertices);
    }
}

/// Splines from spine to fore-edge through eight rows at a time.
fn across<R: Real, G: Grid>(
    sheet: &Sheet<R, G>,
    leaf: &Leaf<R, G>,
    clear: &Clear<R>,
    up: &mut [Vertex],
) {
    const {
        assert!(
            G::NX <= spline::MOST && G::NZ <= spline::MOST,
            "a spline row holds a column of every grid"
        );
    };
    let height = Layout::<G>::ROWS;
    let nothing = [V3::zero(); spline::MOST];
    let mut rows =
        Rows::<R> { nodes: nothing, slopes: nothing, count: G::NX, there: R::Lanes::zero() };
    for k in blocks::<G>() {
        rows.there = rows_there::<R, G>(k);
        fit(&mut rows, sheet, leaf, k);
        let shares = columns::shares(Layout::<G>::COLUMNS - 1);
        for (j, (share, column)) in shares.zip(up.chunks_exact_mut(height)).enumerate() {
            let t = share * (G::NX - 1) as f64;
            let i = (t as usize).min(G::NX - 2);
            let (p, m) = ([rows.node(i), rows.node(i + 1)], [rows.slope(i), rows.slope(i + 1)]);
            let p = spline::blend(p, m, spline::weights(t - i as f64));
            let s = R::of(share * WIDTH);
            let lifted = if j > 0 { clear.lift(p, j, s) } else { p };
            store::<R>(lifted, column.iter_mut().step_by(ALONG).skip(k));
        }
    }
}

/// Nodes and slopes of eight rows from row `k` on.
fn fit<R: Real, G: Grid>(rows: &mut Rows<R>, sheet: &Sheet<R, G>, leaf: &Leaf<R, G>, k: usize) {
    for (i, node) in rows.nodes.iter_mut().enumerate().take(G::NX) {
        *node = leaf.x.rows(i, k, 0);
    }
    let [edge, _] = sheet.spacing;
    rows.open(edge);
    spline::slopes(G::NX, &rows.nodes, &mut rows.slopes);
    if let Some(root) = rows.slopes.first_mut() {
        // Below the binding is no way out.
        root.0[1] = root.0[1].larger(R::Lanes::zero());
    }
    rows.turn();
    spline::even_out(&mut rows.slopes, R::Lanes::all(edge));
}

/// One for every lane that is a row, else zero.
fn rows_there<R: Real, G: Grid>(k: usize) -> R::Lanes {
    let one = |lane: usize| R::of(if k + lane < G::NZ { 1.0 } else { 0.0 });
    R::Lanes::from_array(core::array::from_fn(one))
}

fn store<'a, R: Real>(p: V3<R::Lanes>, slots: impl Iterator<Item = &'a mut Vertex>) {
    let [x, y, z] = p.0.map(|lanes| lanes.array());
    let eight: [[R; LANES]; 3] = [x, y, z];
    let [x, y, z] = eight;
    for (slot, ((x, y), z)) in slots.zip(x.into_iter().zip(y).zip(z)) {
        slot.position = [x.narrow(), y.narrow(), z.narrow()];
    }
}

/// Splines from tail to head through each column; the middle of each cell, and a copy of all.
fn along<G: Grid>(up: &mut [Vertex], down: &mut [Vertex]) {
    let rows = Layout::<G>::ROWS;
    let mut slopes = [V3::zero(); spline::MOST];
    let mut nodes = slopes;
    for (column, copy) in up.chunks_exact_mut(rows).zip(down.chunks_exact_mut(rows)) {
        for (slot, v) in nodes.iter_mut().zip(column.iter().step_by(ALONG)) {
            *slot = V3(v.position);
        }
        let node = |k: usize| nodes.get(k).copied().unwrap_or_else(V3::zero);
        spline::slopes(G::NZ, &nodes, &mut slopes);
        for (r, slot) in copy.iter_mut().enumerate() {
            let k = (r / ALONG).min(G::NZ - 2);
            let w = spline::weights((r - ALONG * k) as f64 / ALONG as f64);
            let slope = |k: usize| slopes.get(k).copied().unwrap_or_else(V3::zero);
            slot.position = spline::blend([node(k), node(k + 1)], [slope(k), slope(k + 1)], w).0;
        }
    }
}

/// One row of vertices, from spine to fore-edge.
#[derive(Debug, Clone, Copy)]
struct Row {
    row: usize,
    rows: usize,
}

impl Row {
    fn of<'a>(&self, net: &'a [Vertex]) -> impl Iterator<Item = &'a Vertex> + Clone {
        net.get(self.row..).unwrap_or_default().iter().step_by(self.rows)
    }
    fn of_mut<'a>(&self, net: &'a mut [Vertex]) -> impl Iterator<Item = &'a mut Vertex> {
        net.get_mut(self.row..).unwrap_or_default().iter_mut().step_by(self.rows)
    }

    /// The row shifted by half the thickness to one side.
    ///
    /// At the spine the leaves of a stack stand side by side along the binding edge, so there the shift
    /// is level; over twice the thickness it becomes the normal one.
    fn offset(&self, net: &[Vertex], side: f32, pen: &Pen, line: &mut Polyline) {
        line.clear();
        let Some(first) = net.get(self.row) else { return };
        let level = (V3([-1.0, 0.0, 0.0]) - V3(first.normal)) * (side * pen.half);
        for ((here, forward), share) in self.going(net).zip(columns::shares(pen.columns - 1)) {
            let n = V3(here.normal);
            let near = (1.0 - (share * WIDTH) as f32 / (4.0 * pen.half)).larger(0.0);
            let p = V3(here.position) + n * (side * pen.half) + level * (near * near);
            line.push(Knot { p, n: n * side }, forward, LEAST);
        }
    }

    /// The row as it is.
    fn trace(&self, net: &[Vertex], line: &mut Polyline) {
        line.clear();
        for (here, forward) in self.going(net) {
            line.push(Knot { p: V3(here.position), n: V3(here.normal) }, forward, LEAST);
        }
    }

    /// Vertices with the way from the one before to the one after.
    fn going<'a>(&self, net: &'a [Vertex]) -> impl Iterator<Item = (&'a Vertex, V3<f32>)> {
        let row = self.of(net);
        let next = row.clone().skip(1).chain(row.clone().last());
        let last = row.clone().take(1).chain(row.clone());
        let ways = next.zip(last).map(|(a, b)| V3(a.position) - V3(b.position));
        row.zip(ways)
    }
}

impl Pen {
    /// Walks the offset row and writes its vertices.
    fn draw(&self, at: &Row, net: &mut [Vertex], side: f32, line: &Polyline) {
        let v = 1.0 - at.row as f32 / (self.rows - 1) as f32;
        for ((share, knot), slot) in
            line.fitted(WIDTH as f32 / self.columns as f32).zip(at.of_mut(net))
        {
            let u = if side > 0.0 { share } else { 1.0 - share };
            *slot = Vertex { position: knot.p.0, normal: knot.n.0, uv: [u, v] };
        }
    }

    /// The four strips between the borders of both sides: tail, head, fore-edge, spine.
    fn rim(&self, up: &[Vertex], down: &[Vertex], rim: &mut [Vertex]) {
        let (columns, rows) = (self.columns, self.rows);
        let mut rest = rim;
        for (first, stride, count, sign) in [
            (0, rows, columns, 1.0),
            (rows - 1, rows, columns, -1.0),
            ((columns - 1) * rows, 1, rows, 1.0),
            (0, 1, rows, -1.0),
        ] {
            let Some((strip, others)) = rest.split_at_mut_checked(2 * count) else { return };
            let border = Border { first, stride, count, sign };
            border.write(up, down, strip);
            rest = others;
        }
    }
}

/// A border of the leaf: every `stride`-th vertex from `first`.
#[derive(Debug, Clone, Copy)]
struct Border {
    first: usize,
    stride: usize,
    count: usize,
    /// Which way out is from the direction of travel.
    sign: f32,
}

impl Border {
    fn write(&self, up: &[Vertex], down: &[Vertex], strip: &mut [Vertex]) {
        let at = |net: &[Vertex], i: usize| {
            net.get(self.first + self.stride * i).map_or(V3::zero(), |v| V3(v.position))
        };
        for (i, pair) in strip.chunks_exact_mut(2).enumerate() {
            let ends = [at(down, i), at(up, i)];
            let along = direction(i, self.count, |i| at(up, i) + at(down, i));
            let thick = unit((ends[1] - ends[0]) * 1e3, V3([0.0, 1.0, 0.0]));
            let normal = unit(along.cross(thick) * (self.sign * 1e3), thick);
            let u = i as f32 / (self.count - 1) as f32;
            for ((slot, end), v) in pair.iter_mut().zip(ends).zip([0.0, 1.0]) {
                *slot = Vertex { position: end.0, normal: normal.0, uv: [u, v] };
            }
        }
    }
}
