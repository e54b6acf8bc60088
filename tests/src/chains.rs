//! Chains of closed ribbons, and three looks at whether one passed through another: rims and creases against faces, how
//! often centrelines are linked, energy.

use crate::random::Pcg;
use crate::ribbons::open;
use dogleaf_core::effect::ribbon::contact::{Cushion, HalfSpace, Near};
use dogleaf_core::effect::ribbon::frame::Frame;
use dogleaf_core::effect::ribbon::{Closure, Ribbon, RibbonSpec, Root, Settings};
use dogleaf_core::real::V3;

/// A ribbon of a chain.
pub type Link = Ribbon<f64, 50>;
/// What is near a link.
pub type Around = Near<f64, HalfSpace<f64>, 50, 1024, 8192>;

/// What links are made of: a metre by five centimetres, a hundred grams per square metre.
pub fn spec(closure: Closure) -> RibbonSpec {
    RibbonSpec {
        closure,
        root: Root::Free,
        rigidity_nm: 2e-3,
        regularisation: 4e-2,
        damping_per_s: 3.0,
        ..RibbonSpec::default()
    }
}

/// A closed ribbon at rest, and its middle.
fn at_rest(closure: Closure) -> (Link, V3<f64>) {
    let mut link = open::<f64, 50>(&spec(closure));
    link.wind(&Frame::at(V3([0.0; 3])), &Settings::EXACT);
    let middle = link.pairs().take(50).fold(V3([0.0; 3]), |m, p| m + (p[0] + p[1]) * 0.01);
    (*link, middle)
}

/// The link with its middle at `place`, turned by a rotation vector.
fn placed((link, middle): &(Link, V3<f64>), place: V3<f64>, turn: V3<f64>) -> Link {
    let (mut link, creases): (Link, Vec<_>) = (link.clone(), link.creases().collect());
    let [x, y, z] = turn.0;
    let turned = Frame::at(-*middle).moved(&[x, y, z, 0.0, 0.0, 0.0]);
    link.lay(&Frame { p: turned.p + place, ..turned }, |j| creases[j]);
    link.gravity = [0.0, 0.0, -9.81];
    link
}

/// How every second link is turned, and how far apart they are, so that each goes through its neighbours and nothing
/// touches.
fn fitting(rest: &(Link, V3<f64>), along: V3<f64>) -> ([V3<f64>; 2], f64) {
    let mut random = Pcg::new(1);
    loop {
        let (turns, way) = ([random.v3() * 3.0, random.v3() * 3.0], random.within(0.2, 0.26));
        let row: Vec<Link> =
            (0..4).map(|k| placed(rest, along * (way * k as f64), turns[k % 2])).collect();
        let linked = |i: usize, k: usize| linking(&row[i], &row[k]).abs();
        let each = linked(0, 1) == 1 && linked(1, 2) == 1 && linked(0, 2) == 0 && linked(1, 3) == 0;
        if each && all_crossings(&row) == 0 {
            return (turns, way);
        }
    }
}

/// Links in a row from `start`, every second one turned, each through its neighbours; gravity along `-Z`.
pub fn chain(closure: Closure, count: usize, start: [f64; 3], along: [f64; 3]) -> Vec<Link> {
    let (rest, along) = (at_rest(closure), V3(along));
    let (turns, way) = fitting(&rest, along);
    let place = |k: usize| V3(start) + along * (way * k as f64);
    (0..count).map(|k| placed(&rest, place(k), turns[k % 2])).collect()
}

/// Nothing near yet but the ground at `z = 0`.
pub fn around() -> Box<Around> {
    let ground = HalfSpace { point: V3([0.0; 3]), normal: V3([0.0, 0.0, 1.0]) };
    Box::new(Near::over(ground, Cushion::default()))
}

/// The triangles of a ribbon, two a segment.
fn faces(link: &Link) -> Vec<[V3<f64>; 3]> {
    let pairs: Vec<_> = link.pairs().collect();
    let cell = |w: &[[V3<f64>; 2]]| [[w[0][0], w[0][1], w[1][0]], [w[0][1], w[1][1], w[1][0]]];
    pairs.windows(2).flat_map(cell).collect()
}

fn volume(a: V3<f64>, b: V3<f64>, c: V3<f64>, d: V3<f64>) -> f64 {
    (b - a).cross(c - a).dot(d - a)
}

/// Whether a line pierces a triangle.
fn pierces([p, q]: [V3<f64>; 2], [a, b, c]: [V3<f64>; 3]) -> bool {
    let sides = [volume(a, b, c, p), volume(a, b, c, q)];
    let around = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    sides[0] * sides[1] < 0.0
        && (around.iter().all(|&v| v > 0.0) || around.iter().all(|&v| v < 0.0))
}

fn far(a: &[V3<f64>; 3], b: &[V3<f64>; 3]) -> bool {
    (0..3).any(|i| {
        let span = |t: &[V3<f64>; 3]| {
            let x = t.map(|v| v.0[i]);
            [x[0].min(x[1]).min(x[2]), x[0].max(x[1]).max(x[2])]
        };
        let ([l, h], [m, g]) = (span(a), span(b));
        l > g || m > h
    })
}

/// Whether two triangles cross.
pub fn cross(s: &[V3<f64>; 3], t: &[V3<f64>; 3]) -> bool {
    let edge = |t: &[V3<f64>; 3], i: usize| [t[i], t[(i + 1) % 3]];
    !far(s, t) && (0..3).any(|i| pierces(edge(s, i), *t) || pierces(edge(t, i), *s))
}

/// How many triangles of two ribbons cross.
pub fn crossings(a: &Link, b: &Link) -> usize {
    let (a, b) = (faces(a), faces(b));
    a.iter().map(|s| b.iter().filter(|t| cross(s, t)).count()).sum()
}

/// How many triangles of one ribbon cross, neighbours left out.
pub fn own_crossings(link: &Link) -> usize {
    let faces = faces(link);
    let n = faces.len() / 2;
    let mut count = 0;
    for i in 0..2 * n {
        for k in i + 1..2 * n {
            let apart = (k / 2 - i / 2).min(n - (k / 2 - i / 2));
            count += usize::from(apart > 3 && cross(&faces[i], &faces[k]));
        }
    }
    count
}

/// How often two closed centrelines are linked: signed crossings in a projection, where the first lies above.
pub fn linking(a: &Link, b: &Link) -> i32 {
    let look = V3([0.123, 0.456, 0.881]);
    let look = look * (1.0 / look.norm());
    let u = look.cross(V3([1.0, 0.0, 0.0]));
    let u = u * (1.0 / u.norm());
    let v = look.cross(u);
    let flat = |link: &Link| -> Vec<[f64; 3]> {
        let middle = link.pairs().take(50).map(|p| (p[0] + p[1]) * 0.5);
        middle.map(|p| [p.dot(u), p.dot(v), p.dot(look)]).collect()
    };
    let (a, b) = (flat(a), flat(b));
    let mut sum = 0;
    for i in 0..a.len() {
        for k in 0..b.len() {
            let ([p, q], [r, s]) = ([a[i], a[(i + 1) % a.len()]], [b[k], b[(k + 1) % b.len()]]);
            let (d, e, w) = (
                [q[0] - p[0], q[1] - p[1]],
                [s[0] - r[0], s[1] - r[1]],
                [r[0] - p[0], r[1] - p[1]],
            );
            let cross = d[0] * e[1] - d[1] * e[0];
            let t = (w[0] * e[1] - w[1] * e[0]) / cross;
            let x = (w[0] * d[1] - w[1] * d[0]) / cross;
            let inside = (0.0..1.0).contains(&t) && (0.0..1.0).contains(&x);
            let above = p[2] + t * (q[2] - p[2]) > r[2] + x * (s[2] - r[2]);
            if inside && above {
                sum += if cross > 0.0 { 1 } else { -1 };
            }
        }
    }
    sum
}

/// All linking numbers.
pub fn links(chain: &[Link]) -> Vec<i32> {
    let pairs = (0..chain.len()).flat_map(|i| (0..i).map(move |k| (i, k)));
    pairs.map(|(i, k)| linking(&chain[i], &chain[k])).collect()
}

/// How many triangles of all cross.
pub fn all_crossings(chain: &[Link]) -> usize {
    let pairs = (0..chain.len()).flat_map(|i| (0..i).map(move |k| (i, k)));
    let others: usize = pairs.map(|(i, k)| crossings(&chain[i], &chain[k])).sum();
    others + chain.iter().map(own_crossings).sum::<usize>()
}

/// Energy of all: of motion, of bending, of height, of contact; joules.
pub fn energy(chain: &[Link], around: &mut Around) -> [f64; 4] {
    let own = chain.iter().map(Link::energy);
    let [k, b, h] = own.fold([0.0; 3], |[k, b, h], e| [k + e.kinetic, b + e.bending, h + e.height]);
    let mut contact = 0.0;
    for (i, link) in chain.iter().enumerate() {
        around.begin(link, 0.0);
        chain[..i].iter().for_each(|o| around.add(o));
        contact += around.stored(link);
    }
    [k, b, h, contact]
}
