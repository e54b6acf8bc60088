//! Promise: the step converges as its method says, on a sheet that rolls up and whose motion is known exactly.

use dogleaf_cost::study::orders::{in_space, in_time};

/// Stack of the thread that works: the finest grid in `f64` is built on it.
const STACK: usize = 256 << 20;

fn on_a_big_stack(work: fn()) {
    let worker = std::thread::Builder::new().stack_size(STACK).spawn(work);
    worker.expect("a thread").join().expect("the order is as promised");
}

#[test]
fn second_order_in_space() {
    on_a_big_stack(|| {
        let found = in_space();
        println!("{:.2} {:?}", found.order, found.points);
        assert!(found.order >= 1.8, "order {:.3} in space: {:?}", found.order, found.points);
    });
}

#[test]
fn first_order_in_time() {
    on_a_big_stack(|| {
        let found = in_time();
        println!("{:.2} {:?}", found.order, found.points);
        assert!(found.order >= 0.9, "order {:.3} in time: {:?}", found.order, found.points);
    });
}

/// What the promise is worth: an error of the first order is not taken for one of the second.
#[test]
fn the_check_can_fail() {
    let slope = |p: i32| {
        let points: Vec<[f64; 2]> = [0.2, 0.1, 0.05].map(|h: f64| [h, 3.0 * h.powi(p)]).to_vec();
        dogleaf_cost::reference::order(&points)
    };
    assert!((slope(1) - 1.0).abs() < 1e-12 && (slope(2) - 2.0).abs() < 1e-12, "slopes");
}
