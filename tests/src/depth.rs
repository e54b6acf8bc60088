//! How deep a leaf is in the page blocks: by hand, node by node, in `f64`. An oracle for the collision pass.

use dogleaf_core::Book;
use dogleaf_core::grid::Grid;
use dogleaf_core::real::Real;

type Point = [f64; 2];

/// Deepest any node of the leaf in the air lies inside a block, model units; negative where none does.
pub fn deepest<R: Real, G: Grid>(book: &Book<R, G>) -> f64 {
    let Some(leaf) = book.leaf() else { return f64::NEG_INFINITY };
    let half = book.binding().half_held().wide();
    let sides = book.binding().thickness().map(|t| t.wide() + half);
    let mut worst = f64::NEG_INFINITY;
    for (side, (block, clear)) in book.blocks().iter().zip(sides).enumerate() {
        let line: Vec<Point> = block.x.iter().map(|p| p.0.map(Real::wide)).collect();
        let sign = if side == 0 { -1.0 } else { 1.0 };
        for (i, k) in (1..G::NX).flat_map(|i| (0..G::NZ).map(move |k| (i, k))) {
            let [x, y, _] = leaf.x.at(i, k).0.map(Real::wide);
            let p = [sign * x, y];
            if p[0] >= line[0][0] {
                worst = worst.max(clear - above(&line, p));
            } else if p[0] > -line[0][0] {
                // Between the blocks the spine is the floor.
                worst = worst.max(-y);
            }
        }
    }
    worst
}

/// Signed distance of a point to a chain whose last edge goes on for ever: positive above.
fn above(line: &[Point], p: Point) -> f64 {
    let mut nearest = (f64::INFINITY, 0.0);
    for (n, pair) in line.windows(2).enumerate() {
        let ([ax, ay], [bx, by]) = (pair[0], pair[1]);
        let (ex, ey) = (bx - ax, by - ay);
        let free = ((p[0] - ax) * ex + (p[1] - ay) * ey) / (ex * ex + ey * ey).max(1e-12);
        let t = if n + 2 == line.len() { free.max(0.0) } else { free.clamp(0.0, 1.0) };
        let (dx, dy) = (p[0] - ax - t * ex, p[1] - ay - t * ey);
        let distance = (dx * dx + dy * dy).sqrt();
        if distance < nearest.0 {
            nearest = (distance, if ex * dy - ey * dx < 0.0 { -distance } else { distance });
        }
    }
    nearest.1
}
