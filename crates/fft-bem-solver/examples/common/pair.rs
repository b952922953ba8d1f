//! The unit of work: one FFT pair, as one application of the half-space.

use contact_types::{ContactModulus, Grid};
use fft_bem_solver::{HalfSpace, Real, SolverError};
use std::time::Instant;

/// Seconds of one FFT pair on the threads of the caller's pool, the shortest of `repeats`.
pub(crate) fn one_pair<T: Real>(
    grid: Grid,
    modulus: ContactModulus,
    repeats: usize,
) -> Result<f64, SolverError> {
    let mut half_space = HalfSpace::<T>::new(grid, modulus);
    let mut field: Vec<T> = (0..grid.len()).map(|i| T::of((i % 97) as f64)).collect();
    let mut best = f64::INFINITY;
    for _ in 0..repeats {
        let clock = Instant::now();
        half_space.displace(&mut field)?;
        best = best.min(clock.elapsed().as_secs_f64());
    }
    Ok(best)
}
