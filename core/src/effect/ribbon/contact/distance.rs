//! How near two segments are: each a flat quadrilateral of two triangles, its vertices A and B of one crease, then of the
//! next.
//!
//! Source: the nearest points of a triangle and of a line as in Ericson's "Real-Time Collision Detection", Sec. 5.1.
//! Checked by `tests/ribbon_contact.rs`.

use super::super::inertia::Four;
use crate::real::{Real, V3};

/// A segment's vertices.
pub type Quad<R> = Four<V3<R>>;

/// Edges: the crease, both rims, the next crease, the diagonal.
const EDGES: [[usize; 2]; 5] = [[0, 1], [0, 2], [1, 3], [2, 3], [1, 2]];
/// Triangles.
const FACES: [[usize; 3]; 2] = [[0, 1, 2], [1, 3, 2]];

/// Which vertices and edges of a segment count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parts {
    /// The first so many vertices.
    pub vertices: usize,
    /// The first so many edges.
    pub edges: usize,
}

impl Parts {
    /// All: for distances.
    pub const ALL: Self = Self { vertices: 4, edges: 5 };
    /// Those that no other segment has: for energies.
    pub const fn own(last: bool) -> Self {
        if last { Self { vertices: 4, edges: 4 } } else { Self { vertices: 2, edges: 3 } }
    }
}

/// Two points near each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting<R> {
    /// Shares of the first segment's vertices.
    pub here: Four<R>,
    /// Shares of the other's.
    pub there: Four<R>,
    /// From the other's point to the first's.
    pub way: V3<R>,
}

#[inline(always)]
fn at<T: Copy>(four: &Four<T>, i: usize) -> T {
    let [a, b, c, d] = *four;
    match i {
        0 => a,
        1 => b,
        2 => c,
        _ => d,
    }
}

/// `Σ share_i` at the vertices named.
#[inline(always)]
fn shares<R: Real, const M: usize>(of: [usize; M], shares: [R; M]) -> Four<R> {
    let share = |v: usize| {
        of.iter().zip(&shares).fold(R::ZERO, |sum, (&i, &s)| if i == v { sum + s } else { sum })
    };
    [share(0), share(1), share(2), share(3)]
}

fn unit<T: Real>(x: T) -> T {
    x.larger(T::ZERO).smaller(T::one())
}

/// Shares along two lines of their nearest points.
pub fn lines<R: Real>([p, q]: [V3<R>; 2], [r, s]: [V3<R>; 2]) -> [R; 2] {
    let (d, e, w, o) = (q - p, s - r, p - r, R::ZERO);
    let (dd, ee, de) = (d.norm_sq(), e.norm_sq(), d.dot(e));
    let (dw, ew) = (d.dot(w), e.dot(w));
    let denominator = dd * ee - de * de;
    let parallel = denominator <= dd * ee * R::of(16.0 * R::EPSILON);
    let along = if parallel { o } else { unit((de * ew - dw * ee) / denominator) };
    let on = |x: R, xx: R| if xx > o { unit(x / xx) } else { o };
    let t = on(de * along + ew, ee);
    [on(de * t - dw, dd), t]
}

/// Shares of a triangle's corners in the point of it nearest to `p`.
pub fn triangle<R: Real>(p: V3<R>, [a, b, c]: [V3<R>; 3]) -> [R; 3] {
    let (u, v, w, o, one) = (b - a, c - a, p - a, R::ZERO, R::one());
    let (d1, d2) = (u.dot(w), v.dot(w));
    if d1 <= o && d2 <= o {
        return [one, o, o];
    }
    let (d3, d4) = (u.dot(p - b), v.dot(p - b));
    if d3 >= o && d4 <= d3 {
        return [o, one, o];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= o && d1 >= o && d3 <= o {
        let t = d1 / (d1 - d3);
        return [one - t, t, o];
    }
    let (d5, d6) = (u.dot(p - c), v.dot(p - c));
    if d6 >= o && d5 <= d6 {
        return [o, o, one];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= o && d2 >= o && d6 <= o {
        let t = d2 / (d2 - d6);
        return [one - t, o, t];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= o && d4 >= d3 && d5 >= d6 {
        let t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return [o, one - t, t];
    }
    let inverse = one / (va + vb + vc);
    [one - vb * inverse - vc * inverse, vb * inverse, vc * inverse]
}

/// The vertex of `a` against the nearer triangle of `b`: its shares of `b` and the way.
fn above<R: Real>(p: V3<R>, b: &Quad<R>) -> (Four<R>, V3<R>) {
    let face = |f: [usize; 3]| {
        let corners = f.map(|i| at(b, i));
        let s = triangle(p, corners);
        let [x, y, z] = corners;
        (shares(f, s), p - (x * s[0] + y * s[1] + z * s[2]))
    };
    let (first, second) = (face(FACES[0]), face(FACES[1]));
    if second.1.norm_sq() < first.1.norm_sq() { second } else { first }
}

/// Hands over the nearest points of every vertex with the other's face, both ways, and of every edge with every edge.
///
/// # Cost
///
/// Of all parts 33 pairs, of own parts 13; some fifty operations each.
pub fn meetings<R: Real>(
    [a, b]: [&Quad<R>; 2],
    [own, other]: [Parts; 2],
    mut take: impl FnMut(&Meeting<R>),
) {
    let one = R::one();
    for v in 0..own.vertices {
        let (there, way) = above(at(a, v), b);
        take(&Meeting { here: shares([v], [one]), there, way });
    }
    for v in 0..other.vertices {
        let (here, way) = above(at(b, v), a);
        take(&Meeting { here, there: shares([v], [one]), way: -way });
    }
    for e in EDGES.iter().take(own.edges) {
        let [p, q] = e.map(|i| at(a, i));
        for f in EDGES.iter().take(other.edges) {
            let [r, s] = f.map(|i| at(b, i));
            let [t, u] = lines([p, q], [r, s]);
            let way = (p + (q - p) * t) - (r + (s - r) * u);
            let (here, there) = (shares(*e, [one - t, t]), shares(*f, [one - u, u]));
            take(&Meeting { here, there, way });
        }
    }
}

/// The distance of two segments.
pub fn apart<R: Real>(a: &Quad<R>, b: &Quad<R>) -> R {
    let mut least = R::of(f64::INFINITY);
    meetings([a, b], [Parts::ALL; 2], |m| least = least.smaller(m.way.norm_sq()));
    least.root()
}

/// A box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds<R> {
    /// Least coordinates.
    pub low: V3<R>,
    /// Greatest.
    pub high: V3<R>,
}

impl<R: Real> Bounds<R> {
    /// Of nothing.
    pub fn none() -> Self {
        Self { low: V3([R::of(f64::INFINITY); 3]), high: V3([R::of(f64::NEG_INFINITY); 3]) }
    }
    /// Of points.
    pub fn of(points: &[V3<R>]) -> Self {
        points.iter().fold(Self::none(), |b, p| b.with(&Self { low: *p, high: *p }))
    }
    /// Of both.
    #[must_use]
    pub fn with(&self, o: &Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.low.0, o.low.0);
        let ([g, h, i], [j, k, l]) = (self.high.0, o.high.0);
        Self {
            low: V3([a.smaller(d), b.smaller(e), c.smaller(f)]),
            high: V3([g.larger(j), h.larger(k), i.larger(l)]),
        }
    }
    /// Whether less than `way` lies between them along every axis.
    pub fn within(&self, o: &Self, way: R) -> bool {
        let pairs = self.low.0.iter().zip(&self.high.0).zip(o.low.0.iter().zip(&o.high.0));
        pairs.fold(true, |near, ((&l, &h), (&m, &i))| near & (l - i < way) & (m - h < way))
    }
}
