//! The front: what nothing else beats both in cost and in error.

/// Whether each point lies on the front: no other is as good in both and better in one.
pub fn front(points: &[[f64; 2]]) -> Vec<bool> {
    points.iter().map(|p| !points.iter().any(|q| beats(*q, *p))).collect()
}

fn beats(q: [f64; 2], p: [f64; 2]) -> bool {
    q[0] <= p[0] && q[1] <= p[1] && (q[0] < p[0] || q[1] < p[1])
}

/// The point that beats another by most: cheapest of those as exact.
pub fn master(points: &[[f64; 2]], p: [f64; 2]) -> Option<usize> {
    let better = points.iter().enumerate().filter(|(_, q)| beats(**q, p));
    better.min_by(|a, b| a.1[0].total_cmp(&b.1[0])).map(|(n, _)| n)
}

#[cfg(test)]
mod check {
    use super::{front, master};

    #[test]
    fn what_is_beaten_is_not_on_the_front() {
        let points = [[1.0, 9.0], [2.0, 9.0], [2.0, 4.0], [3.0, 5.0], [9.0, 1.0], [9.0, 1.0]];
        assert_eq!(front(&points), [true, false, true, false, true, true]);
        assert_eq!(master(&points, points[3]), Some(2));
        assert_eq!(master(&points, points[0]), None);
    }
}
