//! Functions whose least points are known, with and without bounds.

use super::*;

/// Rosenbrock's valley in many numbers.
struct Valley;

impl Objective for Valley {
    fn evaluate(&mut self, x: &[f64], g: &mut [f64]) -> f64 {
        g.fill(0.0);
        let mut value = 0.0;
        for i in 1..x.len() {
            let (bend, wall) = (x[i] - x[i - 1] * x[i - 1], 1.0 - x[i - 1]);
            value += 100.0 * bend * bend + wall * wall;
            g[i] += 200.0 * bend;
            g[i - 1] -= 400.0 * bend * x[i - 1] + 2.0 * wall;
        }
        value
    }
}

fn descend(n: usize, bounds: &Bounds) -> (Vec<f64>, Outcome) {
    let mut x: Vec<f64> = (0..n).map(|i| if i % 2 == 0 { -1.2 } else { 1.0 }).collect();
    let out = minimise(&mut Valley, &mut x, bounds, &Limits::default(), |_, _| true);
    (x, out)
}

#[test]
fn a_valley_is_followed_to_its_end() {
    let free = Bounds { low: vec![f64::NEG_INFINITY; 20], high: vec![f64::INFINITY; 20] };
    let (x, out) = descend(20, &free);
    assert!(x.iter().all(|x| (x - 1.0).abs() < 1e-6), "{x:?} {out:?}");
    assert!(out.iterations < 200 && out.evaluations < 300, "{out:?}");
}

#[test]
fn bounds_hold_and_what_is_free_is_least() {
    let low: Vec<f64> = (0..20).map(|i| if i % 3 == 0 { 1.1 } else { -10.0 }).collect();
    let bounds = Bounds { low, high: vec![10.0; 20] };
    let (x, out) = descend(20, &bounds);
    let mut at = Point { gradient: vec![0.0; 20], value: 0.0, x };
    at.value = Valley.evaluate(&at.x, &mut at.gradient);
    assert!(bounds.slope(&at) < 1e-4, "stationary: {} {out:?}", bounds.slope(&at));
    assert!(at.x.iter().zip(&bounds.low).all(|(x, low)| x >= low), "inside: {:?}", at.x);
    assert!(at.x.iter().zip(&bounds.low).any(|(x, low)| x == low), "a bound is met: {:?}", at.x);
}

#[test]
fn a_quadratic_bowl_in_a_box_ends_in_its_corner() {
    struct Bowl;
    impl Objective for Bowl {
        fn evaluate(&mut self, x: &[f64], g: &mut [f64]) -> f64 {
            let stiff = |i: usize| 1.0 + i as f64;
            g.iter_mut().enumerate().for_each(|(i, g)| *g = stiff(i) * (x[i] - 3.0));
            (0..x.len()).map(|i| 0.5 * stiff(i) * (x[i] - 3.0).powi(2)).sum()
        }
    }
    let bounds = Bounds { low: vec![-1.0; 9], high: (0..9).map(f64::from).collect() };
    let mut x = vec![0.0; 9];
    minimise(&mut Bowl, &mut x, &bounds, &Limits::default(), |_, _| true);
    let wanted = [0.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0];
    assert!(x.iter().zip(wanted).all(|(x, w)| (x - w).abs() < 1e-8), "{x:?}");
}
