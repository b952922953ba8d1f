//! A closed form fitted to deterministic solutions.

use crate::answer::{beyond, steep};
use crate::special::erf;
use contact_types::{
    Caveat, Citation, ContactModel, ContactModulus, ContactState, ModelError, SpectralMoments,
    require,
};
use std::f64::consts::SQRT_2;

const MODEL: &str = "equation";

/// c₀ to c₄ of [`Equation`], by least squares (the book, "The equation").
const FITTED: [f64; 5] = [0.445, -0.357, -0.059, -0.029, 0.032];
/// Half width of the interval: floor, and scatter of few contacts at A = 0.1 %.
const SPREAD: [f64; 2] = [0.002, 0.384];
/// Bandwidths of the surfaces of the fit, with some room \[-\].
const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Areas of the solutions of the fit.
const AREA: [f64; 2] = [0.001, 0.995];

/// The real area of isotropic Gaussian surfaces: Persson's law with an argument fitted to deterministic solutions.
///
/// ```math
/// A = \operatorname{erf}\!\left(\sqrt2\,x\,e^{w}\right),\quad x=\frac{p}{E^* g},\quad
/// w = c_0 + c_1 \sqrt t + c_2 t^2 + (c_3 + c_4 t)\ln\alpha,\quad t=\operatorname{erf}(\sqrt2\,x)
/// ```
///
/// - `p`: nominal pressure \[Pa\]; `E*`: contact modulus \[Pa\]; `g`: rms gradient, `g² = 2 m2` \[-\];
/// - `α = m0 m4/m2²`: Nayak's bandwidth \[-\]; `t` is Persson's area, `w = 0` his law.
///
/// Strictly increasing in p for every bandwidth: with the constants as they are, `d ln(x e^w)/d ln x`
/// is at least 0.5. `A → 1` at heavy load and `A E* g/p → √(8/π) e^(c0 + c3 ln α)` at light load.
///
/// ```
/// use contact_types::{ContactModel, ContactModulus, SpectralMoments};
/// use multiscale_models::Equation;
/// let moments = SpectralMoments { m0: 1e-12, m2: 0.02, m4: 4e9 };
/// let law = Equation::from_moments(moments, ContactModulus::from_pascals(110e9)?)?;
/// let state = law.at_pressure(50e6)?;
/// let [low, high] = law.area_interval(state.area_fraction).expect("it knows its error");
/// assert!(low < state.area_fraction && state.area_fraction < high);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// This program: fitted to its own solutions (the book, "The equation"). The form is that of
/// Persson (2001), doi:10.1063/1.1388626, with a corrected argument.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equation {
    /// E* g \[Pa\].
    unit: f64,
    gradient: f64,
    bandwidth: f64,
}

impl Equation {
    /// From the moments of a surface.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if a moment is negative or not finite, or `m2` is 0.
    pub fn from_moments(
        moments: SpectralMoments,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        require::positive(MODEL, "m2", moments.m2)?;
        let bandwidth = require::positive(MODEL, "bandwidth m0 m4/m2²", moments.bandwidth())?;
        let gradient = moments.rms_gradient();
        let unit = require::positive(MODEL, "E* times rms gradient", modulus.pascals() * gradient)?;
        Ok(Self { unit, gradient, bandwidth })
    }

    /// The argument of the error function at `x = p/(E* g)`.
    fn argument(&self, x: f64) -> f64 {
        let t = erf(SQRT_2 * x);
        let log = self.bandwidth.clamp(BANDWIDTH_USED[0], BANDWIDTH_USED[1]).ln();
        let terms = [1.0, t.sqrt(), t * t, log, t * log];
        let w: f64 = terms.iter().zip(FITTED).map(|(f, c)| f * c).sum();
        SQRT_2 * x * w.exp()
    }

    /// What must be known of an area under a load.
    fn caveat(&self, area: f64) -> Option<Caveat> {
        if area < f64::MIN_POSITIVE {
            return Some(Caveat::Underflow { quantity: "area fraction".into() });
        }
        let outside = |quantity, value, [least, most]: [f64; 2], [larger, smaller]: [_; 2]| {
            if value < least {
                Some(beyond(quantity, value, least, larger))
            } else {
                (value > most).then(|| beyond(quantity, value, most, smaller))
            }
        };
        let bandwidths = ["fitted on larger bandwidths", "fitted on smaller bandwidths"];
        let areas = ["fitted on larger areas", "fitted on smaller areas"];
        steep(self.gradient)
            .or_else(|| outside("bandwidth", self.bandwidth, BANDWIDTH, bandwidths))
            .or_else(|| outside("area fraction", area, AREA, areas))
    }
}

impl ContactModel for Equation {
    fn citation(&self) -> Citation {
        let title = "rough-contact: real area of contact between rough surfaces";
        let journal = concat!("software, version ", env!("CARGO_PKG_VERSION"));
        Citation::new("The rough-contact authors", 2026, title, journal, "")
    }

    fn formula(&self) -> Option<String> {
        let [c0, c1, c2, c3, c4] = FITTED;
        let text = format!(
            "A = erf(√2 x e^w), x = p/(E* h′rms), t = erf(√2 x), \
             w = {c0} + {c1} √t + {c2} t² + ({c3} + {c4} t) ln α, α = m₀m₄/m₂²"
        );
        Some(text.replace("+ -", "− ").replace('-', "−"))
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        let area_fraction = erf(self.argument(mean_pressure / self.unit));
        let caveat = if mean_pressure > 0.0 { self.caveat(area_fraction) } else { None };
        Ok(ContactState { mean_pressure, area_fraction, separation: None, mean_gap: None, caveat })
    }

    /// Area fractions between which 95 of 100 isotropic Gaussian surfaces of these moments lie at a
    /// load where the law answers A, sampling variability included: `A e^(±s)`, at most 1, with
    /// `s = √(1 − A) [0.002 + 0.384 √(0.001/A)]`.
    fn area_interval(&self, area: f64) -> Option<[f64; 2]> {
        let few_contacts = (1e-3 / area.max(1e-4)).sqrt();
        let half = (1.0 - area).max(0.0).sqrt() * (SPREAD[0] + SPREAD[1] * few_contacts);
        Some([area * (-half).exp(), (area * half.exp()).min(1.0)])
    }
}
