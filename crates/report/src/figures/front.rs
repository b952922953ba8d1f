//! Which of many ways to an answer no other beats, by cost and error.

/// The points `[cost, error]` that no other beats in both, from cheap to accurate. The list stops
/// at the first point within `floor`, the uncertainty of the errors themselves: below it they
/// cannot be ranked.
pub fn front(points: &[[f64; 2]], floor: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| {
        let ([cost_a, error_a], [cost_b, error_b]) = (points[a], points[b]);
        cost_a.total_cmp(&cost_b).then(error_a.total_cmp(&error_b))
    });
    let mut front: Vec<usize> = Vec::new();
    for i in order {
        if front.last().is_none_or(|&last| points[i][1] < points[last][1]) {
            front.push(i);
            if points[i][1] <= floor {
                break;
            }
        }
    }
    front
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn front_is_not_beaten_and_stops_at_the_floor() {
        let points = [[1e-8, 3.0], [1e-6, 0.2], [1e-5, 0.3], [1e-3, 0.008], [1.0, 0.001]];
        assert_eq!(front(&points, 0.0), [0, 1, 3, 4]);
        assert_eq!(front(&points, 0.01), [0, 1, 3]);
        assert_eq!(front(&[], 0.0), Vec::<usize>::new());
    }

    proptest! {
        /// A point is on the front if and only if no other is at least as good in both and better
        /// in one; of equal points one is kept.
        #[test]
        fn front_is_pareto(points in prop::collection::vec((1u8..9, 1u8..9), 1..30)) {
            let points: Vec<[f64; 2]> =
                points.iter().map(|&(t, e)| [f64::from(t), f64::from(e)]).collect();
            let front = front(&points, 0.0);
            let beaten = |[t, e]: [f64; 2]| {
                points.iter().any(|&[u, f]| u <= t && f <= e && (u < t || f < e))
            };
            for &i in &front {
                prop_assert!(!beaten(points[i]));
            }
            for &p in points.iter().filter(|&&p| !beaten(p)) {
                // Small whole numbers.
                let equal = |q: [f64; 2]| (q[0] - p[0]).abs() + (q[1] - p[1]).abs() < 0.5;
                prop_assert_eq!(front.iter().filter(|&&i| equal(points[i])).count(), 1);
            }
        }
    }
}
