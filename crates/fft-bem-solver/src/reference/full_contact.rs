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
