//! The same 41 by 29 places of the paper on every grid, so that grids can be compared.

/// Places from spine to fore-edge.
pub const ACROSS: usize = 41;
/// Places from tail to head.
pub const ALONG: usize = 29;
/// All of them.
pub const POINTS: usize = ACROSS * ALONG;

/// Places of the material points on a grid, between its nodes: cubic along each direction, so that what is read
/// off a coarse grid is the grid's error and not the reading's.
pub fn resample(nodes: &[[f64; 3]], [nx, nz]: [usize; 2]) -> Vec<[f64; 3]> {
    let across: Vec<_> = (0..ACROSS).map(|a| weights(a, ACROSS, nx)).collect();
    let along: Vec<_> = (0..ALONG).map(|b| weights(b, ALONG, nz)).collect();
    let mut points = Vec::with_capacity(POINTS);
    for (i, wi) in &across {
        for (k, wk) in &along {
            let mut p = [0.0; 3];
            for (a, &wa) in wi.iter().enumerate() {
                for (b, &wb) in wk.iter().enumerate() {
                    let node = nodes[(i + a) * nz + k + b];
                    p.iter_mut().zip(node).for_each(|(c, n)| *c += wa * wb * n);
                }
            }
            points.push(p);
        }
    }
    points
}

/// First of four nodes round place `at` of `count`, and Lagrange's weights of them.
fn weights(at: usize, count: usize, nodes: usize) -> (usize, [f64; 4]) {
    let s = at as f64 / (count - 1) as f64 * (nodes - 1) as f64;
    let first = (s as usize).saturating_sub(1).min(nodes - 4);
    let t = s - first as f64;
    let mut w = [1.0; 4];
    for (n, w) in w.iter_mut().enumerate() {
        for m in (0..4).filter(|&m| m != n) {
            *w *= (t - m as f64) / (n as f64 - m as f64);
        }
    }
    (first, w)
}

#[cfg(test)]
mod check {
    use super::{ACROSS, ALONG, resample};

    #[test]
    fn a_cubic_is_read_exactly() {
        let f = |u: f64, v: f64| [u * u * u - v, u * v * v, 1.0 + v * v * v];
        let size = [6, 5];
        let nodes: Vec<_> =
            (0..6).flat_map(|i| (0..5).map(move |k| f(i as f64 / 5.0, k as f64 / 4.0))).collect();
        let points = resample(&nodes, size);
        for (n, p) in points.iter().enumerate() {
            let (a, b) = (n / ALONG, n % ALONG);
            let wanted = f(a as f64 / (ACROSS - 1) as f64, b as f64 / (ALONG - 1) as f64);
            let off = p.iter().zip(wanted).fold(0.0_f64, |m, (x, y)| m.max((x - y).abs()));
            assert!(off < 1e-12, "place {a} {b}: {off}");
        }
    }
}
