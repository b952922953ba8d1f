//! The laws of one summit.

use crate::kernel_tables::{ELLIPTIC_AREA, ELLIPTIC_LOAD, GEOMETRIC_AREA, GEOMETRIC_LOAD};
use contact_types::Citation;

/// How a single summit carries load: the only thing in which the models differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SummitLaw {
    /// The full model of Bush, Gibson and Thomas: all summits, all heights, all pairs of principal
    /// curvatures, each an elliptic Hertz contact.
    ///
    /// ```math
    /// \pi a b = \frac{2\pi\delta}{\kappa_1+\kappa_2} F_A, \quad F_A = \frac{E}{kK}, \qquad
    /// F = \frac{2\sqrt2\,\pi}{3} \frac{E^*\delta^{3/2}}{\sqrt{\kappa_1+\kappa_2}} F_P, \quad
    /// F_P = \frac{\sqrt E}{kK^{3/2}}
    /// ```
    ///
    /// K and E are complete elliptic integrals of parameter 1 - k², k = b/a. The kernels average F_A
    /// and F_P over the ellipses that occur at one mean curvature.
    ///
    /// At light load the area is proportional to the load, `A_r/A_n = √(2π) p / (E* h'_rms)`, a limit
    /// that is only reached at unphysically large separations when the bandwidth is large; the full
    /// integral is evaluated, never the limit.
    ///
    /// Bush, Gibson & Thomas (1975), doi:10.1016/0043-1648(75)90145-3; Nayak (1971),
    /// doi:10.1115/1.3451608, for the joint density of height and curvature; Johnson (1985),
    /// *Contact Mechanics*, §4.2, for the ellipse.
    BushGibsonThomas,
    /// Greenwood's simplification: each summit is a sphere of curvature κ = √(κ₁κ₂), with area `πδ/κ` and
    /// load `(4/3) E* δ^{3/2}/√κ`. Area within 2 % and load within 3 % of the full model. With Dawson's
    /// integral D:
    ///
    /// ```math
    /// W_A = \tfrac13\, {}_1F_1(1; \tfrac52; -t^2) = \frac{1 - D(t)/t}{2t^2}, \qquad
    /// W_P = \tfrac{4}{7\pi}\, {}_1F_1(1; \tfrac{11}{4}; -t^2)
    /// ```
    ///
    /// Greenwood (2006), doi:10.1016/j.wear.2005.09.031.
    GreenwoodElliptical,
}

impl SummitLaw {
    /// Name in messages.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::BushGibsonThomas => "Bush-Gibson-Thomas",
            Self::GreenwoodElliptical => "Greenwood simplified elliptical",
        }
    }

    pub(crate) fn citation(self) -> Citation {
        match self {
            Self::BushGibsonThomas => Citation::new(
                "Bush, Gibson & Thomas",
                1975,
                "The elastic contact of a rough surface",
                "Wear 35, 87-111",
                "10.1016/0043-1648(75)90145-3",
            ),
            Self::GreenwoodElliptical => Citation::new(
                "Greenwood",
                2006,
                "A simplified elliptic model of rough surface contact",
                "Wear 261, 191-200",
                "10.1016/j.wear.2005.09.031",
            ),
        }
    }

    /// ∫ 4 t^{7/2} φ W_P dt to four digits: load at full overlap, for starting values.
    pub(crate) fn full_overlap(self) -> f64 {
        match self {
            Self::BushGibsonThomas => 0.85,
            Self::GreenwoodElliptical => 0.83,
        }
    }

    /// 4 t³ W_A(t): area, averaged over the curvature ellipse.
    pub(crate) fn area_weight(self, t: f64) -> f64 {
        let kernel = match self {
            Self::BushGibsonThomas => ELLIPTIC_AREA.at(t),
            Self::GreenwoodElliptical => GEOMETRIC_AREA.at(t),
        };
        4.0 * t * t * t * kernel
    }

    /// 4 t^{7/2} W_P(t): load, averaged over the curvature ellipse.
    pub(crate) fn load_weight(self, t: f64) -> f64 {
        let kernel = match self {
            Self::BushGibsonThomas => ELLIPTIC_LOAD.at(t),
            Self::GreenwoodElliptical => GEOMETRIC_LOAD.at(t),
        };
        4.0 * t * t * t * t.sqrt() * kernel
    }
}
