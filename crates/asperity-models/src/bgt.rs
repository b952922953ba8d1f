//! Bush, Gibson & Thomas: every summit an elliptic Hertz contact.

use crate::kernel_tables::{ELLIPTIC_AREA, ELLIPTIC_LOAD};
use crate::kernels::Kernel;
use crate::{SummitLaw, SummitModel};
use contact_types::Citation;
use std::borrow::Cow;

/// The full model of Bush, Gibson and Thomas: all summits, all heights, all pairs of principal
/// curvatures, each an elliptic Hertz contact.
///
/// At light load the area is proportional to the load,
/// `A_r/A_n = √(2π) p / (E* h'_rms)`, a limit that is only reached at unphysically large
/// separations when the bandwidth is large; the full integral is evaluated, never the limit.
///
/// ```
/// use asperity_models::BushGibsonThomas;
/// use contact_types::{ContactModel, ContactModulus, SpectralMoments};
///
/// let moments = SpectralMoments { m0: 1e-12, m2: 1e-2, m4: 1e9 }; // bandwidth 10
/// let model = BushGibsonThomas::new(moments, ContactModulus::from_pascals(110e9)?)?;
/// let contact = model.at_pressure(100e6)?;
/// assert!(contact.area_fraction > 0.01 && contact.area_fraction < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Bush, Gibson & Thomas (1975), doi:10.1016/0043-1648(75)90145-3; Nayak (1971),
/// doi:10.1115/1.3451608, for the joint density of height and curvature; Johnson (1985),
/// *Contact Mechanics*, §4.2, for the ellipse.
pub type BushGibsonThomas = SummitModel<EllipticHertz>;

/// A summit with two curvatures: elliptic Hertz contact.
///
/// ```math
/// \pi a b = \frac{2\pi\delta}{\kappa_1+\kappa_2} F_A, \quad F_A = \frac{E}{kK}, \qquad
/// F = \frac{2\sqrt2\,\pi}{3} \frac{E^*\delta^{3/2}}{\sqrt{\kappa_1+\kappa_2}} F_P, \quad
/// F_P = \frac{\sqrt E}{kK^{3/2}}
/// ```
///
/// K and E are complete elliptic integrals of parameter 1 - k², k = b/a. The kernels average F_A
/// and F_P over the ellipses that occur at one mean curvature.
#[derive(Debug, Clone, Copy)]
pub struct EllipticHertz;

impl SummitLaw for EllipticHertz {
    const NAME: &'static str = "Bush-Gibson-Thomas";
    const CITATION: Citation = Citation {
        authors: Cow::Borrowed("Bush, Gibson & Thomas"),
        year: 1975,
        title: Cow::Borrowed("The elastic contact of a rough surface"),
        journal: Cow::Borrowed("Wear 35, 87-111"),
        doi: Cow::Borrowed("10.1016/0043-1648(75)90145-3"),
    };
    const AREA: &'static Kernel = &ELLIPTIC_AREA;
    const LOAD: &'static Kernel = &ELLIPTIC_LOAD;
    const FULL_OVERLAP: f64 = 0.85;
}
