//! Pressure to displacement on an elastic half space.

use crate::half_space_free::love_coefficients;
use crate::methods::Compliance;
use crate::row_work::{BLOCK_ROWS, Partial, RowWork, total};
use crate::simd::vectorised;
use crate::{Boundary, Real};
use contact_types::{ContactModulus, Grid};
use grid_fft::Convolution;
use std::sync::Arc;

/// Writes the factors of the waves `(0..=ny/2, kx)` of the transforms.
type Symbol<T> = Box<dyn Fn(usize, &mut [T]) + Send + Sync>;

/// The surface of an elastic half space under a map. With the feature `parallel` on the threads of the pool of rayon
/// that it is called in.
pub struct HalfSpace<T: Real> {
    boundary: Boundary,
    shape: [usize; 2],
    convolution: Convolution<T>,
    compliance: Symbol<T>,
    /// One over the compliance, if that is positive.
    stiffness: Option<Symbol<T>>,
}

impl<T: Real> std::fmt::Debug for HalfSpace<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("HalfSpace").finish_non_exhaustive()
    }
}

impl<T: Real> HalfSpace<T> {
    /// Plans the transforms for `grid`.
    pub fn new(grid: Grid, modulus: ContactModulus, boundary: Boundary) -> Self {
        match boundary {
            Boundary::Periodic => Self::periodic(grid, modulus.pascals()),
            Boundary::Free => Self::free(grid, modulus.pascals()),
        }
    }

    /// On a grid whose finer pixel side is 1, with E* = 1.
    pub(crate) fn scaled(grid: Grid, boundary: Boundary) -> Self {
        let unit = ContactModulus::from_pascals(1.0).expect("1 Pa is a modulus");
        Self::new(grid, unit, boundary)
    }

    fn periodic(grid: Grid, e_star: f64) -> Self {
        let shape = grid.shape();
        let square = move |ky, kx| T::of(grid.wavenumber(ky, kx).powi(2));
        let qy2: Arc<[T]> = (0..=shape[0] / 2).map(|ky| square(ky, 0)).collect();
        let (qy2_of_compliance, factor) = (qy2.clone(), T::of(2.0 / e_star));
        let compliance = move |kx: usize, column: &mut [T]| {
            let qx2 = square(0, kx);
            vectorised!(for (s, qy2) in column.iter_mut().zip(&*qy2_of_compliance) {
                *s = factor / (*qy2 + qx2).root();
            });
            if kx == 0 {
                column[0] = T::zero(); // the mean
            }
        };
        let factor = T::of(0.5 * e_star);
        let stiffness = move |kx: usize, column: &mut [T]| {
            let qx2 = square(0, kx);
            for (s, qy2) in column.iter_mut().zip(&*qy2) {
                *s = factor * (*qy2 + qx2).root();
            }
        };
        Self {
            boundary: Boundary::Periodic,
            shape,
            convolution: Convolution::new(shape),
            compliance: Box::new(compliance),
            stiffness: Some(Box::new(stiffness)),
        }
    }

    /// `stiffness` makes the `B w` of [`Compliance::invert`]: the part on the map of `C^-1 w`, w continued by zeros, with `C`
    /// the periodic operator on the padded grid, of which this half space is a part. Among all fields there that equal `w`
    /// on the map the one with the least `C^-1` norm has that of `K^-1`, and `w` continued by zeros is one of them. None if
    /// `C` is not positive definite.
    fn free(grid: Grid, e_star: f64) -> Self {
        let (padded, coefficients) = love_coefficients(grid, e_star);
        let rows = padded[0] / 2 + 1;
        let is_definite = coefficients.iter().all(|c| *c > 0.0);
        let table: Arc<[T]> = coefficients.into_iter().map(T::of).collect();
        let table_of_stiffness = table.clone();
        let stiffness = move |kx: usize, column: &mut [T]| {
            for (s, c) in column.iter_mut().zip(&table_of_stiffness[kx * rows..]) {
                *s = T::one() / *c;
            }
        };
        let compliance = move |kx: usize, column: &mut [T]| {
            column.copy_from_slice(&table[kx * rows..][..rows]);
        };
        Self {
            boundary: Boundary::Free,
            shape: grid.shape(),
            convolution: Convolution::padded(grid.shape(), padded),
            compliance: Box::new(compliance),
            stiffness: if is_definite { Some(Box::new(stiffness)) } else { None },
        }
    }

    /// Replaces a pressure field by the surface displacement it causes.
    ///
    /// A periodic half-space answers each wave of pressure with the same wave of displacement, scaled by its compliance:
    ///
    /// ```math
    /// \tilde u(\mathbf q) = \frac{2}{E^* |\mathbf q|}\, \tilde p(\mathbf q),
    /// \qquad \tilde u(\mathbf 0) = 0
    /// ```
    ///
    /// The mean displacement of a half-space under a net load is unbounded, so it is set to zero: $u$ is measured from
    /// the mean plane of the deformed surface. With a free boundary each pixel is loaded uniformly, and $u$ is that of
    /// the centres of the pixels, zero far away.
    ///
    /// - `field`: in, pressure $p$ in Pa (compression positive); out, displacement $u$ in m
    ///   (positive into the body). Row-major, `ny * nx`.
    ///
    /// # Panics
    /// If `field` does not have `ny * nx` pixels.
    ///
    /// # Source
    /// Stanley & Kato (1997), doi:10.1115/1.2833523; Johnson (1985) *Contact Mechanics*, §13.2. Free: Love (1929),
    /// *Phil. Trans. R. Soc. A* 228, 377.
    pub fn displace(&mut self, field: &mut [T]) {
        self.convolution.apply_in_place(field, &self.compliance);
    }
}

impl<T: Real> Compliance<T> for HalfSpace<T> {
    fn apply(&mut self, pressure: &[T], displacement: &mut [T]) {
        self.convolution.apply(pressure, &self.compliance, displacement);
    }
    fn apply_around(
        &mut self,
        pressure: &mut [T],
        displacement: &mut [T],
        gap: &mut [f32],
        work: RowWork<'_, T>,
        partial: &mut [Partial],
    ) -> Option<Partial> {
        let [ny, nx] = self.shape;
        let partial = &mut partial[..ny.div_ceil(BLOCK_ROWS)];
        let RowWork { prepare, factor, finish, .. } = work;
        self.convolution.apply_around(
            pressure,
            |row, p| prepare(row * nx, p),
            |sums| factor(sums).map(T::of),
            &self.compliance,
            displacement,
            gap,
            |row, factor, p, u, gap| finish(row * nx, factor, [p, u], gap),
            partial,
        )?;
        Some(total(partial))
    }
    fn invert(&mut self, field: &mut [T]) -> bool {
        if let Some(stiffness) = &self.stiffness {
            self.convolution.apply_in_place(field, stiffness);
        }
        self.stiffness.is_some()
    }
    fn boundary(&self) -> Boundary {
        self.boundary
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
            let mut half_space = HalfSpace::new(grid, modulus, Boundary::Periodic);
            half_space.displace(&mut field);
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
