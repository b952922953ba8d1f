//! By how much a count of touching points exceeds the area: a point stays in contact until the true edge has
//! passed it by some part of the pixel.
//!
//! Of a straight edge that part follows from the discrete operator alone. Let the edge have its normal along
//! the lattice vector `(m, n)`, so that rows of points parallel to it stand `d = h/√(m² + n²)` apart. Then the
//! problem is one-dimensional, with the symbol `1/r(θ)`, `r = |wrapped θ (m, n)| / √(m² + n²)`, and its
//! Wiener–Hopf factors are known: with `2 sin(θ/2)/r(θ) = s(z) s(1/z)` the pressure of the row `k` behind the
//! edge is the coefficient of `z^k` in `(1 − z)^(−3/2) / s(z)` at the moment when the row before it comes in.
//! Its expansion far inside, `√(k − x₀)`, says where the true edge is then, and the mean excess of the count per
//! length of the edge is
//!
//! ```math
//! d \left( \frac14 + \frac{1}{2\pi} \int_0^\pi \cot\frac\theta2 \left( \frac12 \cot\frac\theta2
//!   - \frac{r'}{r} \right) d\theta \right)
//! ```
//!
//! 0.190 pixels for an edge along a row of points, 0.134 at 45°, 0.114 to 0.13 between. The mean over all
//! directions, per edge between a point in contact and one that is not (4/π per length), is the constant below.

/// Area by which a count of points is too large, in pixels per edge of the contact line, for straight edges of all
/// directions and the periodic half-space: derived in this module.
///
/// On rough maps 0.104 fits best (68 %: 0.092 to 0.122; `examples/coverage` of `contact-accuracy`). The constant
/// for a *given* region whose points are counted, (π − 1 + ln 2)/24 = 0.118 (Yastrebov, Anciaux & Molinari
/// 2017, doi:10.1016/j.triboint.2017.04.023), is another: the contact of a discrete solution is not the region
/// sampled.
pub const PERIMETER_CORRECTION: f64 = 0.1013;

#[cfg(test)]
mod tests {
    use super::PERIMETER_CORRECTION;
    use std::f64::consts::{PI, TAU};

    /// Excess per length of an edge with the normal (m, n), in pixels: the formula of the module, by Gauss's
    /// rule of three points between the kinks of the symbol.
    fn excess(m: i32, n: i32) -> f64 {
        let (m, n) = (f64::from(m), f64::from(n));
        let wrapped = |t: f64| t - TAU * (t / TAU).round();
        let integrand = |t: f64| {
            let (x, y) = (wrapped(t * m), wrapped(t * n));
            let cot = 1.0 / (0.5 * t).tan();
            cot * (0.5 * cot - (m * x + n * y) / (x * x + y * y))
        };
        let mut kinks: Vec<f64> = [m, n]
            .iter()
            .flat_map(|k| (1..=*k as u32).map(move |j| PI * f64::from(j) / k))
            .chain([0.0, PI])
            .collect();
        kinks.sort_by(f64::total_cmp);
        let panel = |a: f64, b: f64| {
            let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
            let off = half * 0.6f64.sqrt();
            let ends = integrand(middle - off) + integrand(middle + off);
            half * (5.0 * ends + 8.0 * integrand(middle)) / 9.0
        };
        let between = |ends: &[f64]| {
            let width = (ends[1] - ends[0]) / 8.0;
            (0..8).map(|i| f64::from(i) * width + ends[0]).map(|a| panel(a, a + width)).sum::<f64>()
        };
        let wide = |ends: &&[f64]| ends[1] - ends[0] > 1e-12;
        let integral: f64 = kinks.windows(2).filter(wide).map(between).sum();
        (0.25 + integral / TAU) / m.hypot(n)
    }

    #[test]
    fn the_constant_is_the_mean_over_the_directions_of_straight_edges() {
        assert!((excess(1, 0) - 0.19001).abs() < 1e-4, "{}", excess(1, 0));
        assert!((excess(1, 1) - 0.13436).abs() < 1e-4, "{}", excess(1, 1));
        // Directions that are far from all with small numbers: a prime and whole numbers below it.
        let prime = 101;
        let (mut sum, mut edges) = (0.0, 0.0);
        for n in 1..prime {
            let angle = f64::from(n).atan2(f64::from(prime));
            // Equal steps in n are not equal steps in direction.
            let weight = angle.cos().powi(2);
            sum += weight * excess(prime, n);
            edges += weight * (angle.cos() + angle.sin());
        }
        assert!((sum / edges - PERIMETER_CORRECTION).abs() < 5e-4, "{}", sum / edges);
    }

    /// Strips under the periodic half-space: the count of touching points exceeds what it tends to on finer grids by
    /// 0.19 points an edge in the mean over the places of the grid.
    #[test]
    fn edges_along_rows_exceed_by_as_much_as_the_formula_says() {
        use crate::{ContactModulus, Grid, HeightMap, Load, Solver};
        let (n, loads) = (96, 160);
        let grid = Grid::new([4, n], [1.0, 1.0]).unwrap();
        let wave = |x: f64| (TAU * x / n as f64).cos();
        let map = HeightMap::from_fn(grid, |_, x| wave(x)).unwrap();
        let modulus = ContactModulus::from_pascals(1.0).unwrap();
        let mut solver = Solver::builder().tolerance(1e-9).build(grid, modulus).unwrap();
        let full = PI / n as f64; // pressure that closes the wave (Westergaard 1939): π E* Δ/λ
        let excess = |k: i32| {
            // Widths 2a that rise by equal steps: sin²(π a/λ) = p/p*.
            let width = 30.0 + 12.0 * f64::from(k) / f64::from(loads);
            let load = full * (PI * width / (2.0 * n as f64)).sin().powi(2);
            let solution = solver.solve(&map, Load::MeanPressure(load)).unwrap();
            let counted = solution.touching_fraction() * n as f64;
            counted - width
        };
        let mean = (0..loads).map(excess).sum::<f64>() / f64::from(loads) / 2.0;
        assert!((mean - 0.19).abs() < 0.01, "{mean}");
    }
}
