//! Summits of Greenwood and Williamson that yield: the model of Chang, Etsion and Bogy.

use crate::gauss_legendre::GAUSS_32;
use crate::quadrature::FRAC_1_SQRT_2PI;
use contact_types::{
    AsperityStatistics, Caveat, Citation, ContactModel, ContactModulus, ContactState, ModelError,
    SeparationModel, require,
};
use gw_closed_form::partial_moments::{self, Order};
use std::f64::consts::PI;

const MODEL: &str = "Chang-Etsion-Bogy";

/// Where the integral over elastic summits is cut into panels: what its Gaussian makes of the overlap
/// changes over 1 and over 1/α.
const BREAKS: [f64; 7] = [0.05, 0.5, 2.0, 5.0, 10.0, 20.0, 40.0];
/// The same about the peak of the Gaussian, if the flat is below the mean summit.
const AROUND_PEAK: [f64; 12] = [-9.0, -6.0, -4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0, 6.0, 9.0, 12.0];
/// Farthest mean summit plane that is looked for, in height deviations: its pressure underflows.
const FARTHEST: f64 = 38.0;

/// Spherical summits of one radius and Gaussian heights; deeper than the critical interference ω_c a summit
/// keeps its volume and carries K H times its area.
///
/// With `w = ω_c/σ_s` and the partial moments J_n of the Gaussian:
///
/// ```math
/// \frac pE^* = \tfrac43\,\eta\sqrt R\,\sigma_s^{3/2}\Big\{\int_0^w s^{3/2}\phi(\alpha+s)\,ds
/// + \tfrac32\sqrt w\,[2J_1(\alpha+w)+wJ_0(\alpha+w)]\Big\},\qquad
/// \frac{A_r}{A_n}=\pi\eta R\sigma_s\,[J_1(\alpha)+J_1(\alpha+w)]
/// ```
///
/// The area is that of Greenwood and Williamson at α plus theirs at α + w: no integral is left. Right to
/// 1e-13 in both.
///
/// `ω_c = (π K H / 2E*)² R`, `K = 0.454 + 0.41 ν` with Poisson's ratio ν of the softer body.
///
/// # Validity
/// As Greenwood and Williamson. The load of one summit jumps by half at ω_c, from 2/3 K H to K H times its
/// area, which no body does.
///
/// # Source
/// Chang, Etsion & Bogy (1987), *Journal of Tribology* 109, 257–263; the heights are those of Greenwood & Williamson
/// (1966), doi:10.1098/rspa.1966.0242.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChangEtsionBogy {
    asperities: AsperityStatistics,
    modulus: ContactModulus,
    /// Critical interference over height deviation.
    w: f64,
}

impl ChangEtsionBogy {
    /// From asperity statistics, the hardness of the softer body (Pa) and its Poisson's ratio.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless density, radius, height deviation and hardness are finite and
    /// positive, the mean offset is finite, and Poisson's ratio lies between -1 and 1/2.
    pub fn new(
        asperities: AsperityStatistics,
        modulus: ContactModulus,
        hardness: f64,
        poisson: f64,
    ) -> Result<Self, ModelError> {
        for (quantity, value) in [
            ("asperity density", asperities.density),
            ("asperity radius", asperities.radius),
            ("asperity height deviation", asperities.height_std),
            ("hardness", hardness),
        ] {
            require::positive(MODEL, quantity, value)?;
        }
        require::finite(MODEL, "mean offset", asperities.mean_offset)?;
        if !(poisson > -1.0 && poisson <= 0.5) {
            let requirement = "must lie between -1 and 1/2";
            return Err(require::refused(MODEL, "Poisson's ratio", poisson, requirement));
        }
        let factor = 0.454 + 0.41 * poisson; // K
        let strain = 0.5 * PI * factor * hardness / modulus.pascals();
        let w = strain * strain * asperities.radius / asperities.height_std;
        if !w.is_finite() {
            let requirement = "must be far below the largest double";
            return Err(require::refused(MODEL, "hardness", hardness, requirement));
        }
        Ok(Self { asperities, modulus, w })
    }

    /// Mean pressure (Pa) and area fraction at α.
    fn at_alpha(&self, alpha: f64) -> [f64; 2] {
        let AsperityStatistics { density, radius, height_std: s, .. } = self.asperities;
        let hertz = 4.0 / 3.0;
        let pressure = hertz * self.modulus.pascals() * density * radius.sqrt() * s * s.sqrt();
        [pressure * load(alpha, self.w), PI * density * radius * s * area(alpha, self.w)]
    }
}

/// I_p: the braces of the pressure.
fn load(alpha: f64, w: f64) -> f64 {
    let [j0, j1] = [Order::Zero, Order::One].map(|order| partial_moments::value(order, alpha + w));
    elastic_load(alpha, w) + 1.5 * w.sqrt() * (2.0 * j1 + w * j0)
}

/// I_a: the brackets of the area.
fn area(alpha: f64, w: f64) -> f64 {
    let j1 = |alpha: f64| partial_moments::value(Order::One, alpha);
    j1(alpha) + j1(alpha + w)
}

/// `L = \int_0^w s^{3/2} φ(α+s) ds`, by Gauss-Legendre panels in `y = sqrt(s)`, in which the integrand is
/// smooth.
fn elastic_load(alpha: f64, w: f64) -> f64 {
    // Above the mean summit what is common to all summits is taken out: exp(-α²/2) loses digits.
    let is_above = alpha >= 0.0;
    let height = |s: f64| {
        if is_above {
            (-s * (alpha + 0.5 * s)).exp()
        } else {
            partial_moments::times_gaussian(FRAC_1_SQRT_2PI, alpha + s)
        }
    };
    let mut ends: Vec<f64> = BREAKS.iter().map(|b| b / alpha.max(1.0)).collect();
    if !is_above {
        ends.extend(AROUND_PEAK.iter().map(|b| b - alpha));
    }
    ends.retain(|s| *s > 0.0 && *s < w);
    ends.sort_by(f64::total_cmp);
    let last = if is_above { BREAKS[6] / alpha.max(1.0) } else { AROUND_PEAK[11] - alpha };
    ends.push(w.min(last.max(ends.last().copied().unwrap_or(0.0))));
    let (mut sum, mut from) = (0.0, 0.0);
    for to in ends {
        let [a, b] = [from, to].map(f64::sqrt);
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        for [node, weight] in GAUSS_32 {
            for y in [middle - half * node, middle + half * node] {
                sum += half * weight * 2.0 * y.powi(4) * height(y * y);
            }
        }
        from = to;
    }
    if is_above { partial_moments::times_gaussian(FRAC_1_SQRT_2PI * sum, alpha) } else { sum }
}

impl SeparationModel for ChangEtsionBogy {
    fn at_separation(&self, separation: f64) -> Result<ContactState, ModelError> {
        require::finite(MODEL, "separation", separation)?;
        let AsperityStatistics { mean_offset, height_std, .. } = self.asperities;
        let [pressure, area] = self.at_alpha((separation - mean_offset) / height_std);
        Ok(ContactState::of_isolated_summits(pressure, area, separation))
    }
}

impl ContactModel for ChangEtsionBogy {
    fn citation(&self) -> Citation {
        let title = "An elastic-plastic model for the contact of rough surfaces";
        let journal = "Journal of Tribology 109, 257-263";
        Citation::new("Chang, Etsion & Bogy", 1987, title, journal, "10.1115/1.3261348")
    }

    /// The contact at a mean pressure, by bisection of α. At 0 nothing touches and there is no finite
    /// separation.
    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        let pressure = |alpha: f64| self.at_alpha(alpha)[0];
        if mean_pressure <= 0.0 {
            return Ok(ContactState::default());
        }
        if pressure(FARTHEST) >= mean_pressure {
            let caveat = Some(Caveat::Underflow { quantity: "area fraction".into() });
            return Ok(ContactState { mean_pressure, caveat, ..ContactState::default() });
        }
        let (mut low, mut high) = (-1.0, FARTHEST); // pressures above and below
        while pressure(low) < mean_pressure {
            low *= 2.0;
            if low < -1e9 {
                let requirement = "must be one a contact can carry";
                return Err(require::refused(MODEL, "mean pressure", mean_pressure, requirement));
            }
        }
        while high - low > 4.0 * f64::EPSILON * high.abs().max(low.abs()).max(1e-3) {
            let middle = 0.5 * (low + high);
            *(if pressure(middle) < mean_pressure { &mut high } else { &mut low }) = middle;
        }
        let alpha = 0.5 * (low + high);
        let separation = self.asperities.mean_offset + alpha * self.asperities.height_std;
        Ok(ContactState::of_isolated_summits(mean_pressure, self.at_alpha(alpha)[1], separation))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// To 33 digits (mpmath), by another evaluation of the published integrals.
    #[test]
    fn integrals_against_the_table() {
        let table = include_str!("../../../fixtures/reference/chang_etsion_bogy.csv");
        let (mut worst, mut count): ([f64; 2], _) = ([0.0; 2], 0);
        for line in table.lines().filter(|line| !line.starts_with(['#', 'a'])) {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            let [alpha, w, p, a] = cells[..] else { panic!("{line}") };
            worst[0] = worst[0].max((load(alpha, w) / p - 1.0).abs());
            worst[1] = worst[1].max((area(alpha, w) / a - 1.0).abs());
            count += 1;
        }
        assert!(count >= 18 && worst.iter().all(|w| *w < 1e-13), "{count}: {worst:?}");
    }

    /// Hard bodies are those of Greenwood and Williamson, soft ones carry K H times their area.
    #[test]
    fn limits_and_inverse() {
        for alpha in [-2.0, 0.0, 0.7, 4.0, 20.0] {
            let hertz = partial_moments::value(Order::ThreeHalves, alpha);
            assert!((load(alpha, 60.0) / hertz - 1.0).abs() < 1e-13);
            assert!(
                (area(alpha, 60.0) / partial_moments::value(Order::One, alpha) - 1.0).abs() < 1e-15
            );
            let w = 1e-9_f64;
            assert!((load(alpha, w) / (1.5 * w.sqrt() * area(alpha, w)) - 1.0).abs() < 1e-6);
        }
        let (density, radius, height_std, mean_offset) = (3e10, 8e-6, 0.3e-6, 0.2e-6);
        let asperities = AsperityStatistics { density, radius, height_std, mean_offset };
        let modulus = ContactModulus::from_pascals(110e9).unwrap();
        let model = ChangEtsionBogy::new(asperities, modulus, 2e9, 0.3).unwrap();
        for separation in [-3e-7, 0.0, 4e-7, 1.5e-6] {
            let there = model.at_separation(separation).unwrap();
            let back = model.at_pressure(there.mean_pressure).unwrap();
            assert!((back.separation.unwrap() - separation).abs() < 1e-12 * 1e-6);
            assert!((back.area_fraction / there.area_fraction - 1.0).abs() < 1e-12);
        }
        // At no load nothing touches; below the smallest double an area is not 0, and that is said.
        assert_eq!(model.at_pressure(0.0).unwrap(), ContactState::default());
        let faint = model.at_pressure(1e-310).unwrap();
        assert!(faint.area_fraction == 0.0 && faint.caveat.is_some(), "{faint:?}");
        for (hardness, poisson) in [(0.0, 0.3), (f64::NAN, 0.3), (-1.0, 0.3), (1e9, 0.6)] {
            assert!(ChangEtsionBogy::new(asperities, modulus, hardness, poisson).is_err());
        }
    }
}
