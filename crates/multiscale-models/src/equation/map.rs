//! The law for a map: how steep the part that touches is decides.

use super::constants::{BANDWIDTH_USED, MAP, MAP_SPREAD, MAP_TERMS};
use super::numbers::{MODEL, caveat, citation};
use super::{MapCurves, interval};
use crate::special::{erf, erf_inv};
use contact_types::{
    Citation, ContactModel, ContactModulus, ContactState, ModelError, SpectralMoments, require,
};
use std::f64::consts::{FRAC_2_SQRT_PI, LN_2, SQRT_2};

/// Knots of the law in `ln u`, u the argument of the error function.
const KNOTS: usize = 65;
/// First knot and distance: u from 1.2e-4 to 3.5.
const FIRST: f64 = -9.0;
const STEP: f64 = 0.16;
/// Most that w may rise per unit of `ln u`: the load stays strictly increasing in the area.
const STEEPEST: f64 = 0.9;

/// The law for a map: as [`Equation`](super::Equation), with what a map can tell.
///
/// ```math
/// A=\operatorname{erf} u,\qquad \frac{p}{E^*g}=\frac{u}{\sqrt2}\,e^{-w(A)},
/// ```
///
/// where w is a sum of [`map_terms`] of the area itself: how steep the highest part of the map is, how evenly, and
/// how that changes with depth, twice as much as touches under light load; under which pressure as much would lie
/// flat if all were pressed flat; the bandwidth, and the ratio of slopes across and along the lay. w is taken at 65 values of u once
/// per map and is linear in `ln u` between them, nowhere steeper than 0.9; so area and pressure follow from each other
/// without iteration, and both rise strictly.
///
/// ```
/// use contact_types::{ContactModel, ContactModulus, SpectralMoments};
/// use multiscale_models::{MapCurves, MapEquation};
/// let moments = SpectralMoments { m0: 1e-12, m2: 0.02, m4: 4e9 };
/// let modulus = ContactModulus::from_pascals(110e9)?;
/// // Worn: the highest parts have a third of the slope of all.
/// let mut slope = [0.33; 23];
/// slope[..3].copy_from_slice(&[1.0, 0.7, 0.45]);
/// let gaussian = [0.886; 23];
/// // The same quantiles as a Gaussian surface, (k + 1/2)/20 of the map below each.
/// let flat: [f64; 20] = std::array::from_fn(|k| {
///     multiscale_models::special::erf_inv((k as f64 + 0.5) / 20.0) / 2f64.sqrt()
/// });
/// let worn = MapCurves::new(slope, gaussian, [1.0; 23], [0.2; 23], flat, 1.0)?;
/// let worn = MapEquation::new(moments, &worn, modulus)?;
/// let plain = MapEquation::new(moments, &MapCurves::gaussian(0.5), modulus)?;
/// let area = |law: &MapEquation| law.at_pressure(50e6).map(|s| s.area_fraction);
/// assert!(area(&worn)? > 2.0 * area(&plain)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Fitted by the authors of this program to its own solutions (the book, "The equation"); the form is
/// Persson's law, doi:10.1063/1.1388626, with a corrected argument.
#[derive(Debug, Clone, PartialEq)]
pub struct MapEquation {
    /// E* g \[Pa\].
    unit: f64,
    gradient: f64,
    bandwidth: f64,
    /// `ln(p/(E* g))` at each knot.
    loads: Vec<f64>,
    /// Half width of the interval in `ln A` at each knot.
    halves: Vec<f64>,
}

/// What the constants of the law for a map multiply, at the area `a` of the answer.
pub fn map_terms(a: f64, curves: &MapCurves, log_bandwidth: f64) -> [f64; MAP_TERMS] {
    let light = (1.0 - a).powi(16);
    let part = touching(a);
    // Not its logarithm, which has no end where all of the slope is in a few cliffs.
    let (slope, even) = (curves.log_slope(part), curves.log_evenness(part).exp_m1());
    let pressure = curves.pressure(part);
    let below = steeper_below(a, curves);
    let above = curves.log_slope(0.5 * part) - slope;
    [
        1.0,
        a * a,
        log_bandwidth,
        slope,
        a * slope,
        curves.log_slope(a),
        below,
        below * below,
        above,
        even,
        a * even,
        a * curves.log_flattened(a),
        pressure,
        a * pressure,
        light * pressure * slope,
        light * pressure * curves.log_ratio(),
    ]
}

/// The part whose slope counts at area `a`: twice that area under light load, the area itself where much touches.
fn touching(a: f64) -> f64 {
    (a * (1.0 + (1.0 - a).powi(16))).min(1.0)
}

/// How much steeper the highest part twice as large is, in the logarithm.
fn steeper_below(a: f64, curves: &MapCurves) -> f64 {
    let part = touching(a);
    curves.log_slope((2.0 * part).min(1.0)) - curves.log_slope(part)
}

/// What the half width of the interval is made of, in the logarithm of the load at area `a`: a floor, the chance of
/// few contacts, how unlike a Gaussian surface's the pressure of the highest parts is, and the sizes of evenness,
/// flattened part, resolution and change of slope with depth.
fn spread_terms(a: f64, curves: &MapCurves) -> [f64; super::INTERVAL_TERMS] {
    let part = touching(a);
    [
        1.0,
        interval::few(a),
        curves.unlike(),
        curves.log_evenness(part).abs(),
        (a * curves.log_flattened(a)).abs(),
        curves.log_resolved(part).abs(),
        steeper_below(a, curves).abs(),
    ]
}

impl MapEquation {
    /// From the moments of a map and its curves.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if a moment is negative or not finite, or `m2` is 0.
    pub fn new(
        moments: SpectralMoments,
        curves: &MapCurves,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        Self::with_constants(moments, curves, modulus, (&MAP, &MAP_SPREAD))
    }

    /// With other constants, of the law and of its interval: for those who fit.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn with_constants(
        moments: SpectralMoments,
        curves: &MapCurves,
        modulus: ContactModulus,
        (law, spread): (&[f64; MAP_TERMS], &[f64; super::INTERVAL_TERMS]),
    ) -> Result<Self, ModelError> {
        require::positive(MODEL, "m2", moments.m2)?;
        let bandwidth = require::positive(MODEL, "bandwidth m0 m4/m2²", moments.bandwidth())?;
        let gradient = moments.rms_gradient();
        let unit = require::positive(MODEL, "E* times rms gradient", modulus.pascals() * gradient)?;
        let log = bandwidth.clamp(BANDWIDTH_USED[0], BANDWIDTH_USED[1]).ln();
        let (mut loads, mut halves) = (Vec::with_capacity(KNOTS), Vec::with_capacity(KNOTS));
        let mut before = None;
        for k in 0..KNOTS {
            let log_u = FIRST + STEP * k as f64;
            let a = erf(log_u.exp());
            let terms = map_terms(a, curves, log);
            let mut w: f64 = terms.iter().zip(law).map(|(f, c)| f * c).sum();
            if let Some(last) = before {
                w = w.min(last + STEEPEST * STEP);
            }
            before = Some(w);
            loads.push(log_u - 0.5 * LN_2 - w);
            let half: f64 = spread_terms(a, curves).iter().zip(spread).map(|(f, c)| f * c).sum();
            halves.push(half * curves.wider());
        }
        // From the load to the area: the law's own slope, d ln A/d ln p.
        for (k, half) in halves.iter_mut().enumerate() {
            let (low, high) = (k.saturating_sub(1), (k + 1).min(KNOTS - 1));
            let u = (FIRST + STEP * k as f64).exp();
            let of_argument = FRAC_2_SQRT_PI * (-u * u).exp() * u / erf(u);
            *half *= of_argument * STEP * (high - low) as f64 / (loads[high] - loads[low]);
        }
        Ok(Self { unit, gradient, bandwidth, loads, halves })
    }

    /// u at a load x above 0: `ln u` linear in `ln x` between the knots, in proportion beyond them, without the
    /// logarithm, which would cost digits where it is large.
    fn argument(&self, x: f64) -> f64 {
        let last = KNOTS - 1;
        let at = |k: usize| FIRST + STEP * k as f64;
        let load = x.ln();
        let end = if load <= self.loads[0] {
            0
        } else if load >= self.loads[last] {
            last
        } else {
            let k = self.loads.partition_point(|l| *l <= load) - 1;
            let share = (load - self.loads[k]) / (self.loads[k + 1] - self.loads[k]);
            return (at(k) + STEP * share).exp();
        };
        (at(end) - self.loads[end]).exp() * x
    }

    /// Real area fraction at nominal pressure `p` (Pa).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the pressure is negative or not finite.
    pub fn area_fraction(&self, pressure: f64) -> Result<f64, ModelError> {
        let x = require::pressure(MODEL, pressure)? / self.unit;
        Ok(if x > 0.0 { erf(self.argument(x)) } else { 0.0 })
    }

    /// The nominal pressure (Pa) at which the area fraction is `area`, below 1.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] outside 0 to 1; [`ModelError::OutsideDomain`] at 1.
    pub fn pressure_at_area(&self, area: f64) -> Result<f64, ModelError> {
        let u = erf_inv(require::fraction(MODEL, "area fraction", area)?);
        let u = require::representable(MODEL, "pressure of full contact", u)?;
        if u <= 0.0 {
            return Ok(0.0);
        }
        let place = (u.ln() - FIRST) / STEP;
        let k = (place.max(0.0) as usize).min(KNOTS - 2);
        let last = KNOTS - 1;
        let x = if place < 0.0 {
            (self.loads[0] - FIRST).exp() * u
        } else if place > last as f64 {
            (self.loads[last] - (FIRST + STEP * last as f64)).exp() * u
        } else {
            (self.loads[k] + (place - k as f64) * (self.loads[k + 1] - self.loads[k])).exp()
        };
        Ok(x * self.unit)
    }

    /// Area fractions between which 95 of 100 maps lie where the law answers `area`.
    pub fn interval(&self, area: f64) -> [f64; 2] {
        let u = erf_inv(area.clamp(1e-300, 1.0)).min(SQRT_2 * 10.0);
        let place = ((u.ln() - FIRST) / STEP).clamp(0.0, (KNOTS - 1) as f64);
        let k = (place as usize).min(KNOTS - 2);
        let t = place - k as f64;
        interval::around(area, self.halves[k] * (1.0 - t) + self.halves[k + 1] * t)
    }
}

impl ContactModel for MapEquation {
    fn citation(&self) -> Citation {
        citation()
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let area_fraction = self.area_fraction(mean_pressure)?;
        let caveat = caveat(area_fraction, self.gradient, self.bandwidth, mean_pressure);
        Ok(ContactState { mean_pressure, area_fraction, separation: None, mean_gap: None, caveat })
    }

    fn area_interval(&self, area_fraction: f64) -> Option<[f64; 2]> {
        Some(self.interval(area_fraction))
    }
}
