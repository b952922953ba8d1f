//! The theory of one surface: what it is made from, and its answer at a pressure.

use super::scales::Scales;
use super::self_affine::SelfAffineSpectrum;
use super::span::MODEL;
use crate::answer::{saturated, steep, underflow};
use crate::special::{erf, half_e1_of_square, squared_erf_tail};
use crate::wide::Wide;
use contact_types::{
    Citation, ContactModel, ContactModulus, ContactState, ModelError, RoughnessSpectrum,
    SpectralMoments, require,
};
use std::borrow::Borrow;
use std::f64::consts::{FRAC_2_SQRT_PI, SQRT_2};
use std::sync::Arc;

/// Below this load `x = p / (E* sqrt(m2))` the limits of light load are exact to rounding.
const LIGHT: f64 = 1e-290;

/// Above this `x` the integrals of the gap are below the smallest double.
const FULL: f64 = 27.5;

/// Persson's theory of elastic contact between a rough surface and a flat.
///
/// ```math
/// \frac{A}{A_0} = \operatorname{erf}\frac{p}{\sqrt{2V}}
///   = \operatorname{erf}\frac{\sqrt2\,p}{E^* g_\mathrm{rms}}
///   = \operatorname{erf}\frac{p}{E^*\sqrt{m_2}},
/// \qquad V = \tfrac14 E^{*2} g_\mathrm{rms}^2
/// ```
///
/// - `p`: nominal pressure \[Pa\]; `E*`: contact modulus \[Pa\];
/// - `g_rms`: rms gradient of the surface, `g_rms^2 = 2 m2` \[-\];
/// - `V`: variance of the pressure in full contact \[Pa²\].
///
/// Made from moments it knows the area only; made from a spectrum also the mean gap.
///
/// ```
/// use contact_types::{ContactModel, ContactModulus, SpectralMoments};
/// use multiscale_models::Persson;
/// let moments = SpectralMoments { m0: 1e-12, m2: 0.02, m4: 1e9 };
/// let model = Persson::from_moments(moments, ContactModulus::from_pascals(110e9)?)?;
/// let state = model.at_pressure(50e6)?;
/// assert!((state.area_fraction - 0.0036267).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Persson (2001), doi:10.1063/1.1388626 (area); Persson (2007),
/// doi:10.1103/PhysRevLett.99.125502 (mean gap); Yang & Persson (2008),
/// doi:10.1088/0953-8984/20/21/215214 (gamma).
#[derive(Debug, Clone)]
pub struct Persson {
    modulus: ContactModulus,
    /// `sqrt(m2)` \[-\].
    slope: Wide,
    /// The spectrum, in units of `sqrt(m2)`; `None` if only the moments are known.
    scales: Option<Arc<Scales>>,
    gamma: f64,
}

impl Persson {
    /// gamma of Yang & Persson (2008), the default: a test of the crate `compare` holds it against solutions.
    pub const GAMMA: f64 = 0.45;

    /// From the mean square slope `m2` alone: no mean gap.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if `m2` is negative or not finite. `m2 = 0`, a flat surface,
    /// is accepted.
    pub fn from_moments(
        moments: SpectralMoments,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        let m2 = require::not_negative(MODEL, "m2", moments.m2)?;
        Ok(Self::with_scales(modulus, Wide::from(m2.sqrt()), None))
    }

    /// The theory of a surface with a measured spectrum (two-dimensional, in shells of equal
    /// wavenumber), given or lent.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] if the shells that carry roughness span more than 18 decades
    /// of wavenumber.
    pub fn from_spectrum(
        spectrum: impl Borrow<RoughnessSpectrum>,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        let (slope, scales) = Scales::from_shells(spectrum.borrow().shells())?;
        Ok(Self::with_scales(modulus, slope, Some(scales)))
    }

    /// The theory of a continuous self-affine spectrum.
    pub fn from_self_affine(spectrum: SelfAffineSpectrum, modulus: ContactModulus) -> Self {
        Self::with_scales(modulus, spectrum.slope(), Some(Scales::SelfAffine(spectrum)))
    }

    fn with_scales(modulus: ContactModulus, slope: Wide, scales: Option<Scales>) -> Self {
        Self { modulus, slope, scales: scales.map(Arc::new), gamma: Self::GAMMA }
    }

    /// Sets the factor gamma of the elastic energy in partial contact,
    /// `U ~ P [gamma + (1 - gamma) P^2]`: 1 is Persson 2007, 0.45 ([`GAMMA`](Self::GAMMA), the default) Yang &
    /// Persson 2008; 0.42 is also in use.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `0.01 <= gamma <= 1`.
    pub fn with_gamma(mut self, gamma: f64) -> Result<Self, ModelError> {
        let domain = 0.01..=1.0;
        if !domain.contains(&gamma) {
            let reason = "gamma weighs the energy of partial contact; published values are 0.42 \
                          to 1";
            return Err(require::outside(MODEL, "gamma", gamma, domain, reason));
        }
        self.gamma = gamma;
        Ok(self)
    }

    /// Mean gap between the deformed surfaces \[m\] at nominal pressure `p` \[Pa\]:
    ///
    /// ```math
    /// \bar u(p) = \sqrt\pi\int dq\, q^2 C(q)\, w\, I\!\left(\frac{w p}{E^*}\right), \qquad
    /// I(x) = \int_x^\infty [\gamma + 3(1-\gamma)\operatorname{erf}^2 y]\, \frac{e^{-y^2}}{y}\,dy
    /// ```
    ///
    /// with `w = (pi int_{q0}^{q} q'^3 C dq')^(-1/2)`, evaluated as
    /// `(2/sqrt(pi)) sqrt(m2) int_0^1 I(x/rho)/q(rho) d rho`. It grows like `ln(1/p)` at light
    /// load: a Gaussian surface has no highest point. 0 where it is below the smallest double.
    ///
    /// # Source
    /// Persson (2007), doi:10.1103/PhysRevLett.99.125502, eq. (17); Yang & Persson (2008),
    /// doi:10.1088/0953-8984/20/21/215214.
    fn mean_gap(&self, scales: &Scales, pressure: f64, load: Wide) -> Result<f64, ModelError> {
        let x = load.value();
        if x > FULL {
            return Ok(0.0);
        }
        let gamma = self.gamma;
        let x_used = x.max(LIGHT);
        let mut integral = scales.integrate(x_used, |rho| separation(x_used / rho, gamma));
        if x < LIGHT {
            // u = u0 ln(... / p): continue the logarithm exactly.
            let share = scales.integrate(x_used, |_| 1.0);
            integral += gamma * share * (LIGHT.ln() - load.ln());
        }
        let length = self.slope / scales.smallest_wavenumber();
        let gap = (length * FRAC_2_SQRT_PI * integral).value();
        require::answer(MODEL, gap, "mean pressure", pressure)
    }
}

impl ContactModel for Persson {
    fn citation(&self) -> Citation {
        let title = "Theory of rubber friction and contact mechanics";
        Citation::new("Persson", 2001, title, "J. Chem. Phys. 115, 3840", "10.1063/1.1388626")
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        // x = p / (E* sqrt(m2)); none on a flat surface
        let stiffness = self.slope * self.modulus.pascals();
        let load = (!stiffness.is_zero()).then(|| Wide::from(mean_pressure) / stiffness);
        let is_flat = load.is_none() && mean_pressure > 0.0; // all or nothing
        let area_fraction = load.map_or(if is_flat { 1.0 } else { 0.0 }, |x| erf(x.value()));
        let mean_gap = match (self.scales.as_deref(), load) {
            (Some(scales), Some(load)) if mean_pressure > 0.0 => {
                Some(self.mean_gap(scales, mean_pressure, load)?)
            }
            (Some(_), None) if is_flat => Some(0.0),
            _ => None,
        };
        let gradient = (self.slope * SQRT_2).value();
        let caveat = underflow(mean_pressure, area_fraction)
            .or_else(|| if is_flat { Some(saturated()) } else { steep(gradient) });
        Ok(ContactState { mean_pressure, area_fraction, separation: None, mean_gap, caveat })
    }
}

/// `I(x) = (gamma/2) E1(x^2) + 3 (1 - gamma) K(x)`.
fn separation(x: f64, gamma: f64) -> f64 {
    let persson = gamma * half_e1_of_square(x);
    if gamma < 1.0 { persson + 3.0 * (1.0 - gamma) * squared_erf_tail(x) } else { persson }
}
