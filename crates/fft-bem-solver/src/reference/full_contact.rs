//! Every gap closed: the pressure is known for any surface.

use crate::{HalfSpace, SolverError};
use contact_types::{ContactModulus, HeightMap};

/// Pressure (Pa) that makes a periodic half space take the shape of `surface` everywhere, with
/// the least mean for which it is nowhere negative; and that mean. The heights are taken as the
/// band-limited field their samples define.
///
/// ```math
/// \tilde p(\mathbf q)=\tfrac12E^*|\mathbf q|\,\tilde h(\mathbf q)
/// ```
///
/// # Errors
/// None in practice: the grid of the surface is the grid of the half space.
///
/// # Source
/// Johnson (1985), *Contact Mechanics*, §13.2; variance (E*²/4) h'_rms²: Persson (2001),
/// *J. Chem. Phys.* 115, 3840, doi:10.1063/1.1388626.
pub fn pressure(
    surface: &HeightMap,
    modulus: ContactModulus,
) -> Result<(Vec<f64>, f64), SolverError> {
    let mut field = surface.heights().to_vec();
    HalfSpace::new(surface.grid(), modulus).press(&mut field)?;
    let lowest = field.iter().fold(f64::INFINITY, |m, p| m.min(*p));
    for p in &mut field {
        *p -= lowest;
    }
    Ok((field, -lowest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::BiSinusoid;
    use approx::assert_abs_diff_eq;
    use contact_types::Grid;

    #[test]
    fn egg_box_closes_at_its_closing_pressure() {
        let modulus = ContactModulus::from_pascals(2.0).unwrap();
        let egg_box = BiSinusoid::new(0.1, 1.0, modulus).unwrap();
        let grid = Grid::new([16, 12], [1.0 / 16.0, 1.0 / 12.0]).unwrap();
        let map = HeightMap::from_fn(grid, |y, x| egg_box.height(y, x)).unwrap();
        let (pressure, mean) = pressure(&map, modulus).unwrap();
        let p_star = egg_box.closing_pressure();
        assert_abs_diff_eq!(mean, p_star, epsilon = 1e-13);
        for (p, h) in pressure.iter().zip(map.heights()) {
            assert_abs_diff_eq!(*p, p_star * (1.0 + h / 0.1), epsilon = 1e-12);
        }
    }
}
