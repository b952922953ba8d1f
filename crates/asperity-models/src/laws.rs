//! The laws of one summit, and the models that they make.

use crate::kernel_tables::{ELLIPTIC_AREA, ELLIPTIC_LOAD, GEOMETRIC_AREA, GEOMETRIC_LOAD};
use crate::nayak::mean_kernel;
use crate::{SummitLaw, SummitModel};
use contact_types::Citation;
use std::borrow::Cow::Borrowed;
use std::f64::consts::PI;

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
        authors: Borrowed("Bush, Gibson & Thomas"),
        year: 1975,
        title: Borrowed("The elastic contact of a rough surface"),
        journal: Borrowed("Wear 35, 87-111"),
        doi: Borrowed("10.1016/0043-1648(75)90145-3"),
    };
    const FULL_OVERLAP: f64 = 0.85;

    fn area_kernel(t: f64) -> f64 {
        ELLIPTIC_AREA.at(t)
    }

    fn load_kernel(t: f64) -> f64 {
        ELLIPTIC_LOAD.at(t)
    }
}

/// Greenwood's simplification of Bush, Gibson and Thomas: each summit is replaced by a sphere of
/// curvature √(κ₁κ₂). Area within 2 % and load within 3 % of the full model.
///
/// # Source
/// Greenwood (2006), doi:10.1016/j.wear.2005.09.031.
pub type GreenwoodElliptical = SummitModel<GeometricMeanSphere>;

/// A sphere of curvature √(κ₁κ₂): area `πδ/κ`, load `(4/3) E* δ^{3/2}/√κ`.
///
/// Its kernels are closed forms, with D Dawson's integral:
///
/// ```math
/// W_A = \tfrac13\, {}_1F_1(1; \tfrac52; -t^2) = \frac{1 - D(t)/t}{2t^2}, \qquad
/// W_P = \tfrac{4}{7\pi}\, {}_1F_1(1; \tfrac{11}{4}; -t^2)
/// ```
#[derive(Debug, Clone, Copy)]
pub struct GeometricMeanSphere;

impl SummitLaw for GeometricMeanSphere {
    const NAME: &'static str = "Greenwood simplified elliptical";
    const CITATION: Citation = Citation {
        authors: Borrowed("Greenwood"),
        year: 2006,
        title: Borrowed("A simplified elliptic model of rough surface contact"),
        journal: Borrowed("Wear 261, 191-200"),
        doi: Borrowed("10.1016/j.wear.2005.09.031"),
    };
    const FULL_OVERLAP: f64 = 0.83;

    fn area_kernel(t: f64) -> f64 {
        GEOMETRIC_AREA.at(t)
    }

    fn load_kernel(t: f64) -> f64 {
        GEOMETRIC_LOAD.at(t)
    }
}

/// Each summit is replaced by a sphere of curvature (κ₁+κ₂)/2. Cheapest to reason about and the
/// least accurate of the three: area 11 % below the full model at moderate loads.
///
/// # Source
/// The random-process model with spherical summits of Nayak (1971), doi:10.1115/1.3451608, in
/// the form that Bush, Gibson & Thomas (1975), doi:10.1016/0043-1648(75)90145-3, generalise.
pub type MeanCurvature = SummitModel<ArithmeticMeanSphere>;

/// A sphere of curvature (κ₁+κ₂)/2: `W_A = W_N = (t² - 1 + e^{-t²})/(2t⁴)`, `W_P = (2/π) W_N`.
#[derive(Debug, Clone, Copy)]
pub struct ArithmeticMeanSphere;

impl SummitLaw for ArithmeticMeanSphere {
    const NAME: &'static str = "mean curvature";
    const CITATION: Citation = Citation {
        authors: Borrowed("Nayak"),
        year: 1971,
        title: Borrowed("Random process model of rough surfaces"),
        journal: Borrowed("Journal of Lubrication Technology 93, 398-407"),
        doi: Borrowed("10.1115/1.3451608"),
    };
    const FULL_OVERLAP: f64 = 0.75;

    fn area_kernel(t: f64) -> f64 {
        mean_kernel(t)
    }

    fn load_kernel(t: f64) -> f64 {
        2.0 / PI * mean_kernel(t)
    }
}
