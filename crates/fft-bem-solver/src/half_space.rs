//! Pressure to displacement on an elastic half space.

use crate::half_space_free::FreeHalfSpace;
use crate::half_space_periodic::PeriodicHalfSpace;
use crate::methods::Compliance;
use crate::{Boundary, Real};
use contact_types::{ContactModulus, Grid};

/// The surface of an elastic half space under a map. With the feature `parallel` on the threads of the pool of rayon
/// that it is called in.
pub struct HalfSpace<T: Real> {
    pub(crate) operator: Box<dyn Compliance<T>>,
}

impl<T: Real> std::fmt::Debug for HalfSpace<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("HalfSpace").finish_non_exhaustive()
    }
}

impl<T: Real> HalfSpace<T> {
    /// Plans the transforms for `grid`.
    pub fn new(grid: Grid, modulus: ContactModulus, boundary: Boundary) -> Self {
        let operator: Box<dyn Compliance<T>> = match boundary {
            Boundary::Periodic => Box::new(PeriodicHalfSpace::new(grid, modulus)),
            Boundary::Free => Box::new(FreeHalfSpace::new(grid, modulus)),
        };
        Self { operator }
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
        self.operator.apply_in_place(field);
    }
}
