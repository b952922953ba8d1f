//! The integral that Bush-Gibson-Thomas and Greenwood's model share.

use crate::laws::SummitLaw;
use crate::quadrature::{Correlation, Summit};
use contact_types::{
    Citation, ContactModel, ContactModulus, ContactState, ModelError, SeparationModel,
    SpectralMoments, require,
};
use gw_closed_form::inverse;
use gw_closed_form::partial_moments::{Order, times_gaussian};
use std::f64::consts::PI;

/// A random surface touched at its summits, each obeying the same [`SummitLaw`].
///
/// With h = d/√m0 from the mean plane, bandwidth α = m0 m4/m2², ρ² = 3/(2α), s² = 1 - ρ² and the
/// partial moments J_n of the Gaussian:
///
/// ```math
/// \frac{A_r}{A_n} = \sqrt{\tfrac{\alpha}{24}} \int_0^\infty 4t^3 \varphi(t)\,
///    s\,J_1\!\left(\tfrac{h-\rho t}{s}\right) W_A(t)\,dt
/// ```
/// ```math
/// \frac{p}{E^*\sqrt{m_2}} = \tfrac19 \left(\tfrac32\right)^{1/4} \alpha^{3/4} \int_0^\infty
///    4t^{7/2} \varphi(t)\, s^{3/2} J_{3/2}\!\left(\tfrac{h-\rho t}{s}\right) W_P(t)\,dt
/// ```
///
/// t is the mean curvature of a summit divided by √(2 m4/3); the kernels W hold the law.
///
/// # Accuracy
/// Relative error of the dimensionless area and pressure at h below 4e-15 for bandwidths from 1.5
/// exactly to 1e8 and -6 ≤ h ≤ 37.5; the rounding of h = d/√m0 itself adds h² units in the last
/// place. Area and pressure fall with the separation, except that separations closer to each other
/// than 1e-13 of themselves may come out in either order.
///
/// ```
/// use asperity_models::{SummitLaw, SummitModel};
/// use contact_types::{ContactModel, ContactModulus, SpectralMoments};
///
/// let moments = SpectralMoments { m0: 1e-12, m2: 1e-2, m4: 1e9 }; // bandwidth 10
/// let modulus = ContactModulus::from_pascals(110e9)?;
/// let model = SummitModel::new(SummitLaw::BushGibsonThomas, moments, modulus)?;
/// let contact = model.at_pressure(100e6)?;
/// assert!(contact.area_fraction > 0.01 && contact.area_fraction < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Validity
/// Bandwidth at least 3/2 (no isotropic Gaussian surface has less). A
/// [`Caveat::BeyondModel`](contact_types::Caveat::BeyondModel) is attached above an area fraction of
/// 0.1, where summits feel each other; the area is not clipped.
///
/// # Source
/// Bush, Gibson & Thomas (1975), doi:10.1016/0043-1648(75)90145-3, and those of each [`SummitLaw`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SummitModel {
    law: SummitLaw,
    moments: SpectralMoments,
    modulus: ContactModulus,
    bandwidth: f64,
    correlation: Correlation,
}

impl SummitModel {
    /// From profile spectral moments.
    ///
    /// A bandwidth that misses 3/2 by rounding alone (1e-14) is taken as 3/2: surfaces of one
    /// wavelength have exactly that.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless m0, m2, m4 are finite and positive,
    /// [`ModelError::OutsideDomain`] for a bandwidth below 3/2.
    pub fn new(
        law: SummitLaw,
        moments: SpectralMoments,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        let SpectralMoments { m0, m2, m4 } = moments;
        for (quantity, value) in [("m0", m0), ("m2", m2), ("m4", m4)] {
            require::positive(law.name(), quantity, value)?;
        }
        let bandwidth = moments.bandwidth();
        if !bandwidth.is_normal() {
            let requirement = "must be a normal number; scale the moments to metres";
            return Err(require::refused(law.name(), BANDWIDTH, bandwidth, requirement));
        }
        if bandwidth < 1.5 * (1.0 - 1e-14) {
            let reason = "no isotropic Gaussian surface has less; the Greenwood-Williamson model \
                          still answers above 0.8968";
            let domain = 1.5..=f64::MAX;
            return Err(require::outside(law.name(), BANDWIDTH, bandwidth, domain, reason));
        }
        let bandwidth = bandwidth.max(1.5);
        let correlation = Correlation {
            rho: (1.5 / bandwidth).sqrt(),
            s: ((bandwidth - 1.5) / bandwidth).sqrt(),
        };
        Ok(Self { law, moments, modulus, bandwidth, correlation })
    }

    /// Integrand of the load, 4 t^{7/2} W_P s^{3/2} J_3/2, and its slope -d/dh, where s^{3/2} J_3/2 becomes
    /// (3/2) s^{1/2} J_1/2.
    fn load(&self, summit: &Summit) -> [f64; 2] {
        let weight = self.law.load_weight(summit.t);
        [weight * summit.overlap(Order::ThreeHalves), weight * 1.5 * summit.overlap(Order::Half)]
    }

    /// p / (E* √m2) over the load integral: (1/9) (3/2)^{1/4} α^{3/4}.
    fn dimensionless_scale(&self) -> f64 {
        let root = self.bandwidth.sqrt();
        1.5f64.sqrt().sqrt() / 9.0 * root * root.sqrt()
    }

    /// p over the load integral [Pa].
    fn pressure_scale(&self) -> f64 {
        self.dimensionless_scale() * self.modulus.pascals() * self.moments.m2.sqrt()
    }

    /// A_r/A_n over the area integral.
    fn area_scale(&self) -> f64 {
        (self.bandwidth / 24.0).sqrt()
    }

    /// h at which ln of the dimensionless load p/(E* √m2) is `target`: Newton on the logarithm,
    /// which is concave in h, so the iteration converges from any start.
    fn solve_load(&self, target: f64) -> Result<f64, ModelError> {
        let (mut h, mut step) = (self.starting_value(target), f64::INFINITY);
        for _ in 0..MAX_STEPS {
            let [value, slope] = self.correlation.integrate(h, |summit| self.load(summit));
            // Integrals come in units of exp(-h²/2), see `gaussian`.
            let ln_unit = if h > 0.0 { -0.5 * h * h } else { 0.0 };
            let lacks = (self.dimensionless_scale() * value).ln() + ln_unit - target;
            step = lacks * value / slope;
            h += step;
            if step.abs() <= 1e-8 * h.abs().max(1.0) {
                return Ok(h);
            }
        }
        Err(ModelError::NotConverged {
            model: self.law.name().into(),
            residual: step.abs(),
            iterations: MAX_STEPS,
        })
    }

    fn starting_value(&self, target: f64) -> f64 {
        if target < -8.0 && self.bandwidth < 50.0 {
            // h -> inf: p/(E* sqrt m2) -> phi(h) / (2 sqrt(pi) h)
            let exponent = -target - 2.18; // ln(2 sqrt(2) pi)
            return (2.0 * (exponent - (2.0 * exponent).sqrt().ln())).sqrt();
        }
        // Summits as Greenwood and Williamson see them: one curvature, Gaussian heights.
        let mean = 4.0 / (PI * self.bandwidth).sqrt();
        let deviation = (1.0 - 0.8968 / self.bandwidth).sqrt();
        let full = (self.dimensionless_scale() * self.law.full_overlap()).ln();
        let alpha = inverse::from_ln(target - full - 1.5 * deviation.ln());
        mean + deviation * alpha.unwrap_or(-1e205)
    }
}

impl ContactModel for SummitModel {
    fn citation(&self) -> Citation {
        self.law.citation()
    }

    /// The contact at a mean pressure, by inversion. At 0 nothing touches and there is no finite
    /// separation.
    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(self.law.name(), mean_pressure)?;
        if mean_pressure <= 0.0 {
            return Ok(ContactState::default());
        }
        let unit = self.modulus.pascals().ln() + 0.5 * self.moments.m2.ln();
        let h = self.solve_load(mean_pressure.ln() - unit)?;
        let [load, slope, area, area_slope] = self.correlation.integrate(h, |summit| {
            let ([load, slope], weight) = (self.load(summit), self.law.area_weight(summit.t));
            let [area, area_slope] = [Order::One, Order::Zero].map(|n| weight * summit.overlap(n));
            [load, slope, area, area_slope]
        });
        // h is a rounded number, and load and area change by h² times its rounding. What the load still lacks
        // at this h is known, so the area is moved along with it.
        let found = gaussian(self.pressure_scale() * load, h);
        let missing = if found.is_normal() { mean_pressure / found - 1.0 } else { 0.0 };
        let elasticity = (area_slope / area) / (slope / load);
        let area = gaussian(self.area_scale() * area * (1.0 + missing * elasticity), h);
        // The last Newton step, on the number itself: a large logarithm has lost digits.
        let separation = (h - missing * load / slope) * self.moments.rms_height();
        let [area, separation] = [area, separation]
            .map(|answer| require::answer(self.law.name(), answer, "mean pressure", mean_pressure));
        Ok(ContactState::of_isolated_summits(mean_pressure, area?, separation?))
    }
}

impl SeparationModel for SummitModel {
    fn at_separation(&self, separation: f64) -> Result<ContactState, ModelError> {
        require::finite(self.law.name(), "separation", separation)?;
        let h = (separation / self.moments.rms_height()).clamp(-f64::MAX, f64::MAX); // d/√m0
        if h > FARTHEST {
            return Ok(ContactState::of_isolated_summits(0.0, 0.0, separation));
        }
        let [load, area] = self.correlation.integrate(h, |summit| {
            [
                self.law.load_weight(summit.t) * summit.overlap(Order::ThreeHalves),
                self.law.area_weight(summit.t) * summit.overlap(Order::One),
            ]
        });
        let [pressure, area] = [self.pressure_scale() * load, self.area_scale() * area]
            .map(|x| require::answer(self.law.name(), gaussian(x, h), "separation", separation));
        Ok(ContactState::of_isolated_summits(pressure?, area?, separation))
    }
}

/// Integrals for h > 0 come in units of exp(-h²/2).
fn gaussian(x: f64, h: f64) -> f64 {
    if h > 0.0 { times_gaussian(x, h) } else { x }
}

/// The bandwidth in errors.
const BANDWIDTH: &str = "bandwidth m0 m4 / m2^2";

/// In rms heights: (1e60)^{7/2} is still a double.
const FARTHEST: f64 = 1e60;
/// Seven were the most needed in any test.
const MAX_STEPS: usize = 60;
