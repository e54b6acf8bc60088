//! How far vertices may go on straight ways before two segments touch.
//!
//! No point of a segment moves faster than its fastest vertex, so for a while that the distance and the two speeds give
//! nothing can meet; that is repeated from where it leads. Motion that both segments share does not count.
//!
//! Source: additive conservative advancement, Li et al. 2021, Alg. 1. Checked by `tests/ribbon_contact.rs`.

use super::distance::{Bounds, Quad, apart};
use crate::real::{Real, V3};

/// Advances at most; what is reached by then is free.
const ADVANCES: u32 = 24;
/// A way ends when the distance has shrunk to this share of what it was.
const LEFT: f64 = 0.1;
/// The same, where they are as near as they may get.
const NEARLY: f64 = 0.8;

/// A segment's vertices before and after.
pub type Way<'a, R> = [&'a Quad<R>; 2];

fn along<R: Real>([from, to]: Way<'_, R>, share: R) -> Quad<R> {
    let [a, b, c, d] = *from;
    let [e, f, g, h] = *to;
    let at = |p: V3<R>, q: V3<R>| p + (q - p) * share;
    [at(a, e), at(b, f), at(c, g), at(d, h)]
}

/// The farthest that a vertex goes, less the shared part.
fn farthest<R: Real>([from, to]: Way<'_, R>, shared: V3<R>) -> R {
    let ways = from.iter().zip(to).map(|(&p, &q)| (q - p - shared).norm_sq());
    ways.fold(R::ZERO, |most, w| most.larger(w)).root()
}

fn sum<R: Real>([from, to]: Way<'_, R>) -> V3<R> {
    from.iter().zip(to).fold(V3([R::ZERO; 3]), |sum, (&p, &q)| sum + (q - p))
}

/// The share of two ways, at most `most`, that is free of a meeting. They are not led nearer than `least`, and where they
/// are as near as that already only a little.
///
/// # Cost
///
/// A comparison of boxes where the ways are short against the distance; else a distance an advance, some two thousand
/// operations each.
///
/// # Hard case
///
/// Segments that meet already are free to go: nothing could part them else.
pub fn free<R: Real>(a: Way<'_, R>, b: Way<'_, R>, most: R, least: R) -> R {
    let o = R::ZERO;
    let shared = (sum(a) + sum(b)) * R::of(0.125);
    let speed = farthest(a, shared) + farthest(b, shared);
    if !Bounds::of(a[0]).within(&Bounds::of(b[0]), speed * most + least) || speed <= o {
        return most;
    }
    let first = apart(a[0], b[0]);
    if first > speed * most + least || first <= o {
        return most;
    }
    let left = (first * R::of(LEFT)).larger(least).smaller(first * R::of(NEARLY));
    let (mut share, mut distance) = (o, first);
    for _ in 0..ADVANCES {
        let next = share + (distance - left) * R::of(0.9) / speed;
        if next >= most {
            return most;
        }
        distance = apart(&along(a, next), &along(b, next));
        share = next;
        if distance <= left + (first - left) * R::of(0.05) {
            break;
        }
    }
    share
}
