//! Inner loops in versions for several sets of vector instructions, chosen while the program runs.

use fearless_simd::Level;

/// Evaluates an expression in the version for the widest vectors that this processor has.
///
/// The versions differ in how many numbers one instruction handles and in nothing else: each
/// operation and the order of sums are those of the source, so that the results are the same to the
/// last bit. What the expression calls belongs to a version only if it is inlined.
macro_rules! vectorised {
    ($pass:expr) => {
        fearless_simd::dispatch!($crate::simd::level(), _vectors => $pass)
    };
}
pub(crate) use vectorised;

/// The widest vectors.
pub(crate) fn level() -> Level {
    #[cfg(test)]
    if tests::IS_PLAIN.load(std::sync::atomic::Ordering::Relaxed) {
        return Level::baseline();
    }
    Level::new()
}

#[cfg(test)]
mod tests {
    use crate::{Load, Precision, Solver};
    use contact_types::{ContactModulus, Grid, HeightMap};
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Makes every pass take the version that all processors have.
    pub(super) static IS_PLAIN: AtomicBool = AtomicBool::new(false);

    /// Answers are the same to the last bit whatever the vectors of the processor.
    #[test]
    fn vectors_change_no_bit() {
        for shape in [[96, 128], [37, 101]] {
            let grid = Grid::new(shape, [1.0, 1.0]).unwrap();
            let height = |y: f64, x: f64| {
                (0.7 * y).sin() * (0.9 * x + 0.2 * y).cos() + 0.3 * (2.1 * x - 1.3 * y).sin()
            };
            let surface = HeightMap::from_fn(grid, height).unwrap();
            for (precision, tolerance) in [(Precision::Double, 1e-8), (Precision::Single, 1e-3)] {
                let solve = |is_plain: bool| {
                    IS_PLAIN.store(is_plain, Ordering::Relaxed);
                    let modulus = ContactModulus::from_pascals(1.0).unwrap();
                    let builder = Solver::builder().precision(precision).tolerance(tolerance);
                    let mut solver = builder.build(grid, modulus).unwrap();
                    let solution = solver.solve(&surface, Load::MeanPressure(0.05)).unwrap();
                    IS_PLAIN.store(false, Ordering::Relaxed);
                    let bits = |field: &[f64]| field.iter().map(|x| x.to_bits()).collect();
                    let both: [Vec<u64>; 2] = [bits(&solution.pressure), bits(&solution.gap)];
                    both
                };
                assert!(solve(true) == solve(false), "{shape:?} {precision:?}");
            }
        }
    }
}
