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
use super::curve::{Knot, Polyline};
use super::fold::{self, Eight};
use super::layout::{ALONG, Layout};
use super::normals::Net;
use super::spline::Line;
use super::{Vertex, columns, rim, spline};
use crate::book::Book;
use crate::grid::Grid;
use crate::real::{Eight as _, LANES, Lanes, Num, Real, V3};
use crate::scene::units::WIDTH;
use crate::state::field::eights;
use crate::state::{Field, Leaf, Sheet};

/// A corner of an offset row this little ahead of the last one, as a share of two columns, is dropped.
const LEAST: f32 = 0.1;
/// Rounds of smoothing a side gets where it is folded upon itself.
const MENDINGS: usize = 40;

/// What the sides of a leaf are drawn with.
#[derive(Debug, Clone, Copy)]
struct Pen {
    half: f32,
    /// The leaf stands along a binding edge.
    bound: bool,
    /// Way to each column from the one before.
    ways: [f32; columns::MOST],
    columns: usize,
    rows: usize,
}

/// A leaf to draw, model units.
#[derive(Debug)]
pub(super) struct Sheaf<'a, R: Real, G: Grid> {
    pub(super) sheet: &'a Sheet<R, G>,
    pub(super) leaf: &'a Leaf<R, G>,
    /// Half its thickness.
    pub(super) half: R,
    /// What it must not dip into; nothing for a lone leaf, which is not bound either.
    pub(super) clear: Option<Clear<R>>,
    /// Metres in a model unit.
    pub(super) metres: f64,
}

impl<'a, R: Real, G: Grid> Sheaf<'a, R, G> {
    /// The leaf, or the leaves held as one, over a book.
    pub(super) fn of_book(book: &'a Book<R, G>, leaf: &'a Leaf<R, G>) -> Self {
        let half = book.binding().half_held();
        let profiles = book.binding().profiles(book.blocks());
        let clear = Clear::new(profiles, book.blocks(), half, Layout::<G>::COLUMNS - 1);
        let metres = book.units().metres;
        Self { sheet: book.sheet(), leaf, half, clear: Some(clear), metres }
    }

    /// Fills the leaf's three parts.
    pub(super) fn write(&self, out: &mut [Vertex]) {
        let (columns, rows) = (Layout::<G>::COLUMNS, Layout::<G>::ROWS);
        let Some((up, rest)) = out.split_at_mut_checked(columns * rows) else { return };
        let Some((down, edges)) = rest.split_at_mut_checked(columns * rows) else { return };
        self.across(up);
        along::<G>(up, down);
        let net = Net { columns, rows, side: 1.0 };
        net.normals(down);
        let pen = Pen::new(self, columns, rows);
        let mut line = Polyline::new();
        for row in 0..rows {
            let at = Row { row, rows };
            at.offset(down, 1.0, &pen, &mut line);
            pen.draw(&at, up, 1.0, &line);
            at.offset(down, -1.0, &pen, &mut line);
            pen.draw(&at, down, -1.0, &line);
        }
        let metres = self.metres as f32;
        for (side, vertices) in [(1.0, &mut *up), (-1.0, &mut *down)] {
            mend(&Net { side, ..net }, vertices, &pen, &mut line);
            vertices.iter_mut().for_each(|v| v.position = (V3(v.position) * metres).0);
        }
        rim::write(columns, rows, up, down, edges);
    }

    /// Splines from spine to fore-edge through eight rows at a time.
    fn across(&self, up: &mut [Vertex]) {
        const {
            assert!(G::NX <= spline::MOST && G::NZ <= spline::MOST, "a spline has a fixed size");
        };
        let mut nodes = Field::<R, G>::ZERO;
        let mut slopes = Field::<R, G>::ZERO;
        nodes.copy_from(&self.leaf.x);
        for k in eights::<G>() {
            let mut p = Eight { field: &mut nodes, k };
            let mut m = Eight { field: &mut slopes, k };
            self.fit(&mut p, &mut m);
            let shares = columns::shares(Layout::<G>::COLUMNS - 1);
            let net = up.chunks_exact_mut(Layout::<G>::ROWS);
            for (j, (share, column)) in shares.zip(net).enumerate() {
                let t = share * (G::NX - 1) as f64;
                let i = (t as usize).min(G::NX - 2);
                let w = spline::weights(t - i as f64);
                let place = spline::blend([p.at(i), p.at(i + 1)], [m.at(i), m.at(i + 1)], w);
                let place = match &self.clear {
                    Some(clear) if j > 0 => clear.lift(place, j, R::of(share * WIDTH)),
                    _ => place,
                };
                store::<R>(place, column.iter_mut().step_by(ALONG).skip(k));
            }
        }
    }

    /// Slopes of eight rows; flat folds are opened.
    fn fit(&self, nodes: &mut Eight<'_, R, G>, slopes: &mut Eight<'_, R, G>) {
        let [edge, _] = self.sheet.spacing;
        fold::open(nodes, edge);
        spline::slopes(G::NX, nodes, slopes);
        if self.clear.is_some() {
            // Below the binding is no way out.
            let [x, y, z] = slopes.at(0).0;
            slopes.put(0, V3([x, y.larger(R::Eight::zero()), z]));
        }
        fold::turn(nodes, slopes);
        spline::even_out(G::NX, slopes, R::Eight::all(edge));
    }
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

fn store<'a, R: Real>(p: V3<R::Eight>, slots: impl Iterator<Item = &'a mut Vertex>) {
    let [x, y, z]: [[R; LANES]; 3] = p.0.map(R::Eight::array);
    for (slot, ((x, y), z)) in slots.zip(x.into_iter().zip(y).zip(z)) {
        slot.position = [x.narrow(), y.narrow(), z.narrow()];
    }
}

/// Splines from tail to head through each column; the middle of each cell, and a copy of all.
fn along<G: Grid>(up: &mut [Vertex], down: &mut [Vertex]) {
    let rows = Layout::<G>::ROWS;
    let mut slopes = [V3::zero(); spline::MOST];
    let mut nodes = slopes;
    for (column, copy) in up.chunks_exact_mut(rows.max(1)).zip(down.chunks_exact_mut(rows.max(1))) {
        for (slot, v) in nodes.iter_mut().zip(column.iter().step_by(ALONG)) {
            *slot = V3(v.position);
        }
        spline::slopes(G::NZ, &nodes, &mut slopes);
        for (r, slot) in copy.iter_mut().enumerate() {
            let k = (r / ALONG).min(G::NZ - 2);
            let w = spline::weights((r - ALONG * k) as f64 / ALONG as f64);
            let (p, m) = ([nodes.at(k), nodes.at(k + 1)], [slopes.at(k), slopes.at(k + 1)]);
            slot.position = spline::blend(p, m, w).0;
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
    /// The row shifted by half the thickness to one side.
    ///
    /// At the spine the leaves of a stack stand side by side along the binding edge, so there the shift
    /// is level; over twice the thickness it becomes the normal one.
    fn offset(&self, net: &[Vertex], side: f32, pen: &Pen, line: &mut Polyline) {
        let Some(first) = net.get(self.row) else { return };
        let level = (V3([-1.0, 0.0, 0.0]) - V3(first.normal)) * (side * pen.half);
        let mut ways = pen.ways.iter();
        let mut s = 0.0;
        self.offer(net, line, |here| {
            let n = V3(here.normal);
            let p = V3(here.position) + n * (side * pen.half);
            s += ways.next().copied().unwrap_or(0.0);
            if s >= 4.0 * pen.half || !pen.bound {
                return Knot { p, n };
            }
            let near = 1.0 - s / (4.0 * pen.half);
            Knot { p: p + level * (near * near), n }
        });
    }

    /// The row as it is.
    fn trace(&self, net: &[Vertex], line: &mut Polyline) {
        self.offer(net, line, |here| Knot { p: V3(here.position), n: V3(here.normal) });
    }

    /// Offers the line a corner for each vertex of the row.
    fn offer(&self, net: &[Vertex], line: &mut Polyline, mut knot: impl FnMut(&Vertex) -> Knot) {
        line.clear();
        let at = |j: usize| net.get(j * self.rows + self.row);
        let mut before = at(0);
        let mut j = 0;
        while let (Some(here), Some(last)) = (at(j), before) {
            j += 1;
            let next = at(j).unwrap_or(here);
            line.push(knot(here), V3(next.position) - V3(last.position), LEAST);
            before = Some(here);
        }
    }

    fn of_mut<'a>(&self, net: &'a mut [Vertex]) -> impl Iterator<Item = &'a mut Vertex> {
        net.get_mut(self.row..).unwrap_or_default().iter_mut().step_by(self.rows.max(1))
    }
}

impl Pen {
    fn new<R: Real, G: Grid>(sheaf: &Sheaf<'_, R, G>, columns: usize, rows: usize) -> Self {
        let mut ways = [0.0; columns::MOST];
        for (slot, way) in ways.iter_mut().zip(columns::steps(columns - 1)) {
            *slot = way;
        }
        Self { half: sheaf.half.narrow(), bound: sheaf.clear.is_some(), ways, columns, rows }
    }

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
}
