//! Contact conductance by the correlations that users compare with, and what they are fits of.
//!
//! Gaussian heights cut at a level λσ leave circular spots; each carries heat as one in a tube of its own. For
//! bodies that yield at once the cut area is p/H, for elastic ones half of what is cut is in contact:
//!
//! ```math
//! \text{plastic: } \frac pH = Q(\lambda),\quad
//! h=\frac{k_s m_a}{\sigma}\,\frac{e^{-\lambda^2/2}}{2\sqrt{2\pi}\,(1-\sqrt{p/H})^{3/2}},\qquad
//! \text{elastic: } \frac{\sqrt2\,p}{E^*m_a}=\tfrac12 Q(\lambda)=A,\quad
//! h=\frac{k_s m_a}{\sigma}\,\frac{e^{-\lambda^2/2}}{4\sqrt\pi\,(1-\sqrt A)^{3/2}}
//! ```
//!
//! with the Gaussian tail Q, `σ² = σ₁² + σ₂²` and `m_a² = m₁² + m₂²`. The well-known powers of the load are fits
//! of these to 1.5 % (A from 1e-6 to 0.02) and 4 % (to 0.1). m_a is the *mean absolute* profile slope, 0.798 of the rms one: public codes mix
//! them. For a current put `2/(ρ₁ + ρ₂)` in the place of k_s.
//!
//! # Source
//! Cooper, Mikic & Yovanovich (1969), doi:10.1016/0017-9310(69)90011-8; Mikic (1974), doi:10.1016/0017-9310(74)90082-9;
//! from memory. That of 1969 had 1.45 and 0.985 in the place of 1.25 and 0.95, which fit the expression above.

use crate::gauss_legendre::GAUSS_32;
use contact_types::{Citation, ContactModel, ContactModulus, ContactState, ModelError, require};
use gw_closed_form::partial_moments::{self, Order};
use std::f64::consts::{E, PI, SQRT_2};

const MODEL: &str = "conductance correlation";

/// A correlation of contact conductance, [`plastic`](Self::plastic) or [`elastic`](Self::elastic).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConductanceCorrelation {
    /// m_a (-).
    slope: f64,
    /// σ \[m\].
    height: f64,
    /// H of bodies that yield, E* m_a of elastic ones \[Pa\].
    pressure_scale: f64,
    is_elastic: bool,
}

impl ConductanceCorrelation {
    /// Cooper, Mikic & Yovanovich: bodies that yield at once, `h = 1.25 k_s m_a/σ (p/H)^0.95`. From the mean absolute
    /// profile slope m_a (-) and the rms height σ (m) of both surfaces together and the hardness of the softer body (Pa).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless all are finite and positive.
    pub fn plastic(mean_slope: f64, rms_height: f64, hardness: f64) -> Result<Self, ModelError> {
        require::positive(MODEL, "hardness", hardness)?;
        Self::new(mean_slope, rms_height, hardness, false)
    }

    /// Mikic: elastic bodies, `h = 1.55 k_s m_a/σ (√2 p/(E* m_a))^0.94`. From the mean absolute profile slope m_a (-) and
    /// the rms height σ (m) of both surfaces together.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless both are finite and positive.
    pub fn elastic(
        mean_slope: f64,
        rms_height: f64,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        Self::new(mean_slope, rms_height, modulus.pascals() * mean_slope, true)
    }

    fn new(
        slope: f64,
        height: f64,
        pressure_scale: f64,
        is_elastic: bool,
    ) -> Result<Self, ModelError> {
        require::positive(MODEL, "mean absolute slope", slope)?;
        require::positive(MODEL, "rms height", height)?;
        Ok(Self { slope, height, pressure_scale, is_elastic })
    }

    /// The fraction of the heights that is cut at λσ, and the area fraction A of what touches, p/H or that of the module
    /// documentation.
    fn areas(&self, pressure: f64) -> Result<[f64; 2], ModelError> {
        require::pressure(MODEL, pressure)?;
        let (cut_per_area, factor, quantity, reason) = if self.is_elastic {
            (2.0, SQRT_2, "area fraction", "half of the surface would be cut and more")
        } else {
            let reason = "the mean pressure is all that the hardness bears: everything touches";
            (1.0, 1.0, "mean pressure over hardness", reason)
        };
        let (area, most) = (factor * pressure / self.pressure_scale, 1.0 / cut_per_area);
        if area < most {
            return Ok([cut_per_area * area, area]);
        }
        Err(require::outside(MODEL, quantity, area, 0.0..=most, reason))
    }
}

impl ContactModel for ConductanceCorrelation {
    fn citation(&self) -> Citation {
        if self.is_elastic {
            let title = "Thermal contact conductance; theoretical considerations";
            let journal = "Int. J. Heat Mass Transfer 17, 205";
            Citation::new("Mikic", 1974, title, journal, "10.1016/0017-9310(74)90082-9")
        } else {
            let (authors, title) = ("Cooper, Mikic & Yovanovich", "Thermal contact conductance");
            let journal = "Int. J. Heat Mass Transfer 12, 279";
            Citation::new(authors, 1969, title, journal, "10.1016/0017-9310(69)90011-8")
        }
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let [tail, area_fraction] = self.areas(mean_pressure)?;
        if tail <= 0.0 {
            return Ok(ContactState::default());
        }
        let cut = cut(tail);
        let separation = Some(cut * self.height);
        // Mean of (λ - z) where it is positive.
        let gap = (cut + partial_moments::value(Order::One, cut)) * self.height;
        let limit = area_fraction.clamp(1e-6, if self.is_elastic { 0.1 } else { 0.02 });
        let caveat =
            ((area_fraction - limit).abs() > 0.0).then(|| contact_types::Caveat::BeyondModel {
                quantity: "area fraction".into(),
                value: area_fraction,
                limit,
                reason: "the power of the load is fitted to lighter or heavier contact".into(),
            });
        let mean_gap = Some(gap);
        Ok(ContactState { mean_pressure, area_fraction, separation, mean_gap, caveat })
    }

    /// By the fit `coefficient m_a/σ A^power`, and by what it is a fit of.
    fn conductance(&self, mean_pressure: f64) -> Result<Option<[f64; 2]>, ModelError> {
        let [tail, area] = self.areas(mean_pressure)?;
        let (coefficient, power, divisor) = if self.is_elastic {
            (1.55, 0.94, 4.0 * PI.sqrt())
        } else {
            (1.25, 0.95, 2.0 * (2.0 * PI).sqrt())
        };
        let factor = self.slope / self.height;
        let exact = at_cut(tail) / divisor / (1.0 - area.sqrt()).powf(1.5);
        Ok(Some([coefficient * factor * area.powf(power), factor * exact]))
    }

    fn formula(&self) -> Option<String> {
        let fit = if self.is_elastic {
            "1.55 k_s m_a/σ (√2 p/(E* m_a))^0.94"
        } else {
            "1.25 k_s m_a/σ (p/H)^0.95"
        };
        Some(format!("h = {fit} with k_s = 2 k₁ k₂/(k₁ + k₂)"))
    }
}

/// Conductance over conductivity of the gas between Gaussian heights of this rms value (m) and a flat at a separation (m)
/// of their mean plane (1/m); heights above it touch:
///
/// ```math
/// \frac{h_g}{k_g} = \frac1{\sigma\sqrt{2\pi}} \int_0^\infty \frac{e^{-(Y/\sigma-t)^2/2}}{t+M/\sigma}\,dt
/// ```
///
/// Parallel plates locally, with the temperature jumps of both walls as a length M (m). With CMY's separation, `Y/σ =
/// √2 erfc⁻¹(2p/H)`, it is the form in use since Yovanovich (1982; from memory).
///
/// # Errors
/// [`ModelError::InvalidInput`] unless all are finite, and rms height and jump positive.
pub fn gas_between(separation: f64, rms_height: f64, jump: f64) -> Result<f64, ModelError> {
    const GAS: &str = "gas in a Gaussian gap";
    /// Standard deviations beyond which nothing is counted: exp(-72).
    const REACH: f64 = 12.0;
    require::positive(GAS, "rms height", rms_height)?;
    require::positive(GAS, "length of the temperature jumps M", jump)?;
    require::finite(GAS, "separation", separation)?;
    let (cut, jump) = (separation / rms_height, jump / rms_height);
    // Panels of two standard deviations in u = t + M/σ, and near its pole of one in ln u, where there is none.
    let (mut low, end) = (jump + (cut - REACH).max(0.0), jump + cut.max(0.0) + REACH);
    let mut sum = 0.0;
    while low < end {
        let high = (E * low).min(low + 2.0).min(end);
        let is_near = high > 1.5 * low;
        let of = |u: f64| if is_near { u.ln() } else { u };
        let (middle, half) = (0.5 * (of(high) + of(low)), 0.5 * (of(high) - of(low)));
        for [x, weight] in GAUSS_32.iter().flat_map(|&[x, w]| [[x, w], [-x, w]]) {
            let at = middle + half * x;
            let (u, per_node) = if is_near { (at.exp(), 1.0) } else { (at, 1.0 / at) };
            let z = cut + jump - u;
            sum += weight * half * per_node * (-0.5 * z * z).exp();
        }
        low = high;
    }
    Ok(sum / (2.0 * PI).sqrt() / rms_height)
}

/// Length of the temperature jumps of a gas at two walls (m), from its free path (m), Prandtl number, ratio of specific
/// heats and the accommodation coefficients of the walls:
///
/// ```math
/// M = \left(\frac{2-a_1}{a_1}+\frac{2-a_2}{a_2}\right) \frac{2\gamma}{\mathrm{Pr}(\gamma+1)}\, \Lambda
/// ```
///
/// # Errors
/// [`ModelError::InvalidInput`] of a number that is not positive, or an accommodation above 1.
pub fn temperature_jump(
    free_path: f64,
    prandtl: f64,
    heat_ratio: f64,
    accommodation: [f64; 2],
) -> Result<f64, ModelError> {
    const GAS: &str = "gas in the gap";
    require::positive(GAS, "mean free path", free_path)?;
    require::positive(GAS, "Prandtl number", prandtl)?;
    require::positive(GAS, "ratio of specific heats", heat_ratio)?;
    if let Some(value) = accommodation.into_iter().find(|a| !(*a > 0.0 && *a <= 1.0)) {
        let requirement = "must be above 0 and at most 1";
        return Err(require::refused(GAS, "accommodation coefficient", value, requirement));
    }
    let walls: f64 = accommodation.into_iter().map(|a| (2.0 - a) / a).sum();
    Ok(walls * 2.0 * heat_ratio / (prandtl * (heat_ratio + 1.0)) * free_path)
}

/// `exp(-λ²/2)` at the cut λ above which a fraction `tail` of Gaussian heights lies; 0 where none does.
fn at_cut(tail: f64) -> f64 {
    if tail <= 0.0 {
        return 0.0;
    }
    // The Gaussian there, with what the rounding of λ took from it given back.
    let cut = cut(tail);
    partial_moments::times_gaussian(1.0, cut) * (-cut * step(tail, cut)).exp()
}

/// λ above which a fraction `tail` of Gaussian heights lies.
fn cut(tail: f64) -> f64 {
    // Newton's method for ln Q, which is concave in λ: it passes the root at most once.
    let mut cut = 0.0;
    for _ in 0..100 {
        let change = step(tail, cut);
        cut += change;
        if change.abs() <= 1e-15 * (1.0 + cut.abs()) {
            break;
        }
    }
    cut
}

/// What Newton's method adds to λ.
fn step(tail: f64, cut: f64) -> f64 {
    let lacks = partial_moments::ln(Order::Zero, cut) - tail.ln();
    lacks / -partial_moments::ln_derivative(Order::Zero, cut)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against 32 digits (mpmath).
    #[test]
    fn correlations_against_the_table() {
        let table = include_str!("../../../fixtures/reference/contact_conductance.csv");
        let (mut worst, mut count) = ([0.0_f64; 4], 0);
        for line in table.lines().filter(|line| !line.starts_with(['#', 'k'])) {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            let [k1, k2, slope, height, hardness, modulus, p, exact @ ..] = &cells[..] else {
                panic!("{line}")
            };
            let modulus = ContactModulus::from_pascals(*modulus).unwrap();
            let plastic = ConductanceCorrelation::plastic(*slope, *height, *hardness).unwrap();
            let elastic = ConductanceCorrelation::elastic(*slope, *height, modulus).unwrap();
            let mean = 2.0 * k1 * k2 / (k1 + k2);
            let [cmy, cut_plastic] = plastic.conductance(*p).unwrap().unwrap();
            let [mikic, cut_elastic] = elastic.conductance(*p).unwrap().unwrap();
            let found = [cmy, mikic, cut_plastic, cut_elastic].map(|h| h * mean);
            for (worst, (found, exact)) in worst.iter_mut().zip(found.iter().zip(exact)) {
                *worst = worst.max((found / exact - 1.0).abs());
            }
            count += 1;
        }
        assert!(count == 12 && worst.iter().all(|w| *w < 1e-13), "{count}: {worst:?}");
    }

    /// P/H = 1e-3 cuts at 3.09023230616781 σ, and the gap is the mean of what lies below.
    #[test]
    fn a_flat_at_the_cut() {
        let state = ConductanceCorrelation::plastic(0.1, 0.6e-6, 1.2e9)
            .unwrap()
            .at_pressure(1.2e6)
            .unwrap();
        let cut = 3.090_232_306_167_81;
        assert!((state.separation.unwrap() / 0.6e-6 - cut).abs() < 1e-13);
        assert!((state.area_fraction - 1e-3).abs() < 1e-15 && state.caveat.is_none());
        let density = |z: f64| (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
        let n = 200_000;
        let width = (cut + 12.0) / f64::from(n);
        let z = |i: i32| -12.0 + width * (f64::from(i) + 0.5);
        let mean: f64 = (0..n).map(|i| (cut - z(i)) * density(z(i)) * width).sum();
        assert!((state.mean_gap.unwrap() / 0.6e-6 - mean).abs() < 1e-9);
    }

    /// 12 digits (mpmath) by p/H and M/σ.
    #[test]
    fn gas_between_gaussian_heights_against_the_table() {
        let jumps = [0.01, 0.1, 0.28, 1.0, 10.0];
        let table = "
            1e-5 0.249997691986 0.243904445215 0.232826369481 0.19770543883  0.0704508743387
            1e-4 0.295784314464 0.286123897790 0.270179922837 0.223023433274 0.0732749002868
            1e-3 0.385095496522 0.361991032773 0.333529222833 0.261745288668 0.0767437745363
            1e-2 0.625436400691 0.531781349869 0.459817023410 0.326188659614 0.0806356700824
            1e-1 1.38368222947  0.930630301127 0.701180460333 0.411586265056 0.0788359237548";
        let sigma = 0.4e-6;
        for row in table.trim().lines() {
            let cells: Vec<f64> =
                row.split_whitespace().map(|cell| cell.parse().unwrap()).collect();
            let model = ConductanceCorrelation::plastic(0.1, sigma, 1e9).unwrap();
            let separation = model.at_pressure(cells[0] * 1e9).unwrap().separation.unwrap();
            for (jump, exact) in jumps.into_iter().zip(&cells[1..]) {
                let found = gas_between(separation, sigma, jump * sigma).unwrap() * sigma;
                assert!((found / exact - 1.0).abs() < 3e-12, "{row}, {jump}: {found}");
            }
        }
        // Far apart it is a plate; M of no accommodation is no end of it.
        let far = gas_between(1e-3, 1e-9, 1e-6).unwrap();
        assert!((far * (1e-3 + 1e-6) - 1.0).abs() < 1e-11, "{far}");
        assert!(gas_between(1e-6, 1e-6, 0.0).is_err() && gas_between(1e-6, -1e-6, 1e-7).is_err());
        let air = temperature_jump(64e-9, 0.7, 1.4, [0.9, 0.9]).unwrap();
        assert!((air - 2.0 * (1.1 / 0.9) * 2.8 / (0.7 * 2.4) * 64e-9).abs() < 1e-20);
        for wrong in [0.0, -0.1, 1.01, f64::NAN] {
            assert!(temperature_jump(64e-9, 0.7, 1.4, [0.9, wrong]).is_err());
        }
    }

    #[test]
    fn nonsense_is_refused() {
        let plastic = ConductanceCorrelation::plastic(0.1, 1e-6, 1e9).unwrap();
        assert!(plastic.at_pressure(-1.0).is_err() && plastic.conductance(f64::NAN).is_err());
        let full = plastic.conductance(1e9).unwrap_err().to_string();
        assert!(full.contains("everything touches"), "{full}");
        assert_eq!(plastic.conductance(0.0), Ok(Some([0.0, 0.0])));
        assert!(plastic.at_pressure(0.0).unwrap().area_fraction <= 0.0);
        let modulus = ContactModulus::from_pascals(1e10).unwrap();
        let elastic = ConductanceCorrelation::elastic(0.1, 1e-6, modulus).unwrap();
        let has_caveat = |m: ConductanceCorrelation, p| m.at_pressure(p).unwrap().caveat.is_some();
        assert!(has_caveat(plastic, 5e7) && has_caveat(plastic, 9e2) && !has_caveat(elastic, 5e7));
        assert!(elastic.at_pressure(1e10).is_err() && elastic.conductance(1e10).is_err());
        assert!(ConductanceCorrelation::plastic(0.0, 1e-6, 1e9).is_err());
    }
}
