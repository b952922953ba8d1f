//! Pressure to displacement on a periodic half space.

use crate::methods::Compliance;
use crate::row_work::{BLOCK_ROWS, Partial, RowWork, total};
use crate::simd::vectorised;
use crate::{Boundary, Real};
use contact_types::{ContactModulus, Grid};
use grid_fft::Convolution;

/// The surface of a periodic elastic half space.
pub(crate) struct PeriodicHalfSpace<T: Real> {
    grid: Grid,
    modulus: ContactModulus,
    transform: Convolution<T>,
    /// Square of the wavenumber along y, `ky` in `0..=ny/2`.
    qy2: Vec<T>,
}

impl<T: Real> PeriodicHalfSpace<T> {
    /// Plans the transforms for `grid`.
    pub(crate) fn new(grid: Grid, modulus: ContactModulus) -> Self {
        let transform = Convolution::new(grid.shape());
        let qy2 = |ky| T::of(grid.wavenumber(ky, 0).powi(2));
        let qy2 = (0..=grid.shape()[0] / 2).map(qy2).collect();
        Self { grid, modulus, transform, qy2 }
    }

    /// Square of the wavenumber along x of the waves `kx`.
    fn qx2(&self, kx: usize) -> T {
        T::of(self.grid.wavenumber(0, kx).powi(2))
    }

    /// Compliance `2 / (E* |q|)` of the waves `(0..=ny/2, kx)`, 0 for the mean.
    fn compliance(&self, kx: usize, column: &mut [T]) {
        let (factor, qx2) = (T::of(2.0 / self.modulus.pascals()), self.qx2(kx));
        vectorised!(for (s, qy2) in column.iter_mut().zip(&self.qy2) {
            *s = factor / (*qy2 + qx2).root();
        });
        if kx == 0 {
            column[0] = T::zero();
        }
    }
}

impl<T: Real> Compliance<T> for PeriodicHalfSpace<T> {
    fn apply(&mut self, pressure: &[T], displacement: &mut [T]) {
        let symbol = |kx: usize, column: &mut [T]| self.compliance(kx, column);
        self.transform.apply(pressure, symbol, displacement);
    }
    fn apply_in_place(&mut self, field: &mut [T]) {
        self.transform.apply_in_place(field, |kx, column| self.compliance(kx, column));
    }
    fn apply_around(
        &mut self,
        pressure: &mut [T],
        displacement: &mut [T],
        gap: &mut [f32],
        work: RowWork<'_, T>,
        partial: &mut [Partial],
    ) -> Option<Partial> {
        let [ny, nx] = self.grid.shape();
        let partial = &mut partial[..ny.div_ceil(BLOCK_ROWS)];
        let RowWork { prepare, factor, finish, .. } = work;
        self.transform.apply_around(
            pressure,
            |row, p| prepare(row * nx, p),
            |sums| factor(sums).map(T::of),
            |kx, column| self.compliance(kx, column),
            displacement,
            gap,
            |row, factor, p, u, gap| finish(row * nx, factor, [p, u], gap),
            partial,
        )?;
        Some(total(partial))
    }
    /// `p = E* |q| u / 2` for each wave.
    fn invert(&mut self, field: &mut [T]) -> bool {
        let factor = T::of(0.5 * self.modulus.pascals());
        self.transform.apply_in_place(field, |kx, column| {
            let qx2 = self.qx2(kx);
            for (s, qy2) in column.iter_mut().zip(&self.qy2) {
                *s = factor * (*qy2 + qx2).root();
            }
        });
        true
    }
    fn boundary(&self) -> Boundary {
        Boundary::Periodic
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    proptest! {
        /// p = p0 (1 + cos q·x)  =>  u = 2 p0 / (E* |q|) cos q·x, exactly (Johnson 1985, §13.2),
        /// and back. Odd, even and non-square grids, oblique waves; rounding alone.
        #[test]
        fn cosine_pressure_gives_cosine_displacement(
            ny in 1usize..40, nx in 1usize..40, ky in 0usize..20, kx in 0usize..20,
            e_star in 1e6..1e12,
        ) {
            prop_assume!(2 * ky < ny && 2 * kx < nx && (ky, kx) != (0, 0)); // resolved, not the mean
            let (p0, pixel) = (1e6, [2e-7, 1e-7]); // Pa, m
            let grid = Grid::new([ny, nx], pixel).unwrap();
            let wave = |i: usize| {
                let (iy, ix) = (i / nx, i % nx);
                let turns = (ky * iy) as f64 / ny as f64 + (kx * ix) as f64 / nx as f64;
                (TAU * turns).cos()
            };
            let q = TAU * (ky as f64 / (ny as f64 * pixel[0])).hypot(kx as f64 / (nx as f64 * pixel[1]));
            let amplitude = 2.0 * p0 / (e_star * q);

            let mut field: Vec<f64> = (0..grid.len()).map(|i| p0 * (1.0 + wave(i))).collect();
            let modulus = ContactModulus::from_pascals(e_star).unwrap();
            let mut half_space = PeriodicHalfSpace::new(grid, modulus);
            half_space.apply_in_place(&mut field);
            for (i, u) in field.iter().enumerate() {
                prop_assert!((u - amplitude * wave(i)).abs() < 1e-12 * amplitude);
            }
            half_space.invert(&mut field);
            for (i, p) in field.iter().enumerate() {
                prop_assert!((p - p0 * wave(i)).abs() < 1e-11 * p0);
            }
        }
    }
}
