//! The law for a map: how steep the part that touches is decides.

use super::constants::{BANDWIDTH_USED, MAP, MAP_SPREAD, MAP_TERMS};
use super::numbers::{MODEL, caveat, citation};
use super::{MapCurves, interval};
use crate::special::{erf, erf_inv};
use contact_types::{
    Citation, ContactModel, ContactModulus, ContactState, ModelError, SpectralMoments, require,
};
use std::f64::consts::LN_2;

/// Knots of the law in `ln u`, u the argument of the error function.
const KNOTS: usize = 65;
/// First knot and distance: u from 1.2e-4 to 3.5.
const FIRST: f64 = -9.0;
const STEP: f64 = 0.16;
/// Argument beyond which the area is 1 to the last digit.
const FULL: f64 = 6.0;
/// Most that w may rise per unit of `ln u`: the load stays strictly increasing in the area.
const STEEPEST: f64 = 0.9;

/// The law for a map: as [`Equation`](super::Equation), with what a map can tell.
///
/// ```math
/// A=\operatorname{erf} u,\qquad \frac{p}{E^*g}=\frac{u}{\sqrt2}\,e^{-w(A)},
/// ```
///
/// where w is a sum of [`map_terms`] of the area itself: how steep the highest part of the map is, where it is pressed as
/// well, and how evenly; how round its summits are and how evenly; how well the points resolve it; under which pressure as
/// much would lie flat if all were pressed flat; and the bandwidth. w is taken at 65 values of u once
/// per map and is linear in `ln u` between them, nowhere steeper than 0.9; so area and pressure follow from each other
/// without iteration, and both rise strictly.
///
/// ```
/// use contact_types::{ContactCurves, ContactModel, ContactModulus, SpectralMoments};
/// use multiscale_models::{MapCurves, MapEquation};
/// let moments = SpectralMoments { m0: 1e-12, m2: 0.02, m4: 4e9 };
/// let modulus = ContactModulus::from_pascals(110e9)?;
/// // Worn: the highest parts have a third of the slope of all.
/// let mut slope = [0.33; 23];
/// slope[..3].copy_from_slice(&[1.0, 0.7, 0.45]);
/// let worn = ContactCurves {
///     slope,
///     evenness: [0.886; 23],
///     resolved: [1.0; 23],
///     pressure: [0.2; 23],
///     pressure_evenness: [0.5; 23],
///     pressed: [0.6; 23],
///     pressed_slope: slope,
///     curvature_evenness: [0.5; 23],
///     curvature_difference: [0.8; 23],
///     curvature_product: [0.05; 23],
///     level: [0.0; 23],
///     // The same quantiles as a Gaussian surface, (k + 1/2)/20 of the map below each.
///     flattened: std::array::from_fn(|k| {
///         multiscale_models::special::erf_inv((k as f64 + 0.5) / 20.0) / 2f64.sqrt()
///     }),
/// };
/// let worn = MapEquation::new(moments, &MapCurves::new(&worn)?, modulus)?;
/// let plain = MapEquation::new(moments, &MapCurves::gaussian([0.5, 0.4]), modulus)?;
/// let area = |law: &MapEquation| law.at_pressure(50e6).map(|s| s.area_fraction);
/// assert!(area(&worn)? > 1.5 * area(&plain)?);
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
    /// The least that reaches the area of a knot or a larger one, and the most that may be needed for it or a smaller one.
    least: Vec<f64>,
    most: Vec<f64>,
}

/// What the constants of the law for a map multiply, at the area `a` of the answer.
pub fn map_terms(a: f64, curves: &MapCurves, log_bandwidth: f64) -> [f64; MAP_TERMS] {
    let (light, lighter, middle) = ((1.0 - a).powi(4), (1.0 - a).powi(16), a * (1.0 - a));
    let [twice, four_times] = [2.0, 4.0].map(|times: f64| (times * a).min(1.0));
    let even = curves.log_evenness(twice);
    let round = curves.curvature_evenness(twice);
    let pressed = curves.log_slope(a) * curves.pressed(twice);
    let pressure = curves.pressure_evenness(twice);
    let resolved = curves.log_resolved(twice);
    [
        1.0,
        a * a,
        a * log_bandwidth,
        curves.log_slope(twice),
        middle * curves.log_slope(0.5 * a),
        a * curves.log_slope(a) * round,
        even * curves.curvature_difference(twice),
        even * round,
        a * even * even,
        a * round,
        curves.curvature_product(0.5 * a),
        curves.curvature_product(four_times),
        a * curves.log_pressed_slope(0.5 * a),
        lighter * curves.log_pressed_slope(a),
        lighter * curves.log_pressed_slope(twice) * pressure,
        curves.log_pressed_slope(four_times),
        pressed,
        a * pressed,
        pressure * curves.curvature_evenness(four_times),
        a * curves.log_flattened(a),
        even * curves.curvature_product(twice),
        even * resolved,
        light * round * resolved,
        pressure * resolved,
    ]
}

/// What the half width of the interval is made of, in the logarithm of the load at area `a`: a floor, the chance of
/// few contacts, how unlike a Gaussian surface's the pressure of the highest parts is, the sizes of what is flattened and of how
/// well the highest part is resolved, nearly full contact, uneven slopes, and points without slope.
pub fn map_spread_terms(a: f64, curves: &MapCurves) -> [f64; super::INTERVAL_TERMS] {
    let twice = (2.0 * a).min(1.0);
    [
        1.0,
        interval::few(a),
        curves.unlike(),
        (a * curves.log_flattened(a)).abs(),
        curves.log_resolved(twice).abs(),
        a.powi(4),
        (-curves.log_evenness(twice)).min(2.0).exp_m1().max(0.0),
        curves.level(twice),
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
        let mut loads = Vec::with_capacity(KNOTS);
        let (mut least, mut most) = (Vec::with_capacity(KNOTS), Vec::with_capacity(KNOTS));
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
            let load = log_u - 0.5 * LN_2 - w;
            let terms = map_spread_terms(a, curves);
            let half = curves.wider() * terms.iter().zip(spread).map(|(f, c)| f * c).sum::<f64>();
            loads.push(load);
            least.push(load - half);
            most.push(load + half);
        }
        for k in 1..KNOTS {
            most[k] = f64::max(most[k], most[k - 1]);
            least[KNOTS - 1 - k] = f64::min(least[KNOTS - 1 - k], least[KNOTS - k]);
        }
        Ok(Self { unit, gradient, bandwidth, loads, least, most })
    }

    /// Real area fraction at nominal pressure `p` (Pa).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the pressure is negative or not finite.
    pub fn area_fraction(&self, pressure: f64) -> Result<f64, ModelError> {
        let x = require::pressure(MODEL, pressure)? / self.unit;
        Ok(if x > 0.0 { erf(argument(&self.loads, x)) } else { 0.0 })
    }

    /// The nominal pressure (Pa) at which the area fraction is `area`, below 1.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] outside 0 to 1; [`ModelError::OutsideDomain`] at 1.
    pub fn pressure_at_area(&self, area: f64) -> Result<f64, ModelError> {
        let u = erf_inv(require::fraction(MODEL, "area fraction", area)?);
        let u = require::representable(MODEL, "pressure of full contact", u)?;
        Ok(if u > 0.0 { self.load(u) * self.unit } else { 0.0 })
    }

    /// p/(E\* g) at an argument u above 0.
    fn load(&self, u: f64) -> f64 {
        let place = (u.ln() - FIRST) / STEP;
        let k = (place.max(0.0) as usize).min(KNOTS - 2);
        let last = KNOTS - 1;
        if place < 0.0 {
            (self.loads[0] - FIRST).exp() * u
        } else if place > last as f64 {
            (self.loads[last] - (FIRST + STEP * last as f64)).exp() * u
        } else {
            (self.loads[k] + (place - k as f64) * (self.loads[k + 1] - self.loads[k])).exp()
        }
    }

    /// Area fractions between which 95 of 100 maps lie where the law answers `area`: those for which the load is within its
    /// half width. Where a little more load is much more area, they are far apart.
    pub fn interval(&self, area: f64) -> [f64; 2] {
        let u = erf_inv(area.clamp(f64::MIN_POSITIVE, 1.0)).min(FULL);
        let x = self.load(u);
        [&self.most, &self.least].map(|loads| erf(argument(loads, x)))
    }
}

/// u at a load x above 0: `ln u` linear in `ln x` between the knots, in proportion beyond them, without the
/// logarithm, which would cost digits where it is large.
fn argument(loads: &[f64], x: f64) -> f64 {
    let last = KNOTS - 1;
    let at = |k: usize| FIRST + STEP * k as f64;
    let load = x.ln();
    let end = if load <= loads[0] {
        0
    } else if load >= loads[last] {
        last
    } else {
        let k = loads.partition_point(|l| *l <= load) - 1;
        let share = (load - loads[k]) / (loads[k + 1] - loads[k]);
        return (at(k) + STEP * share).exp();
    };
    (at(end) - loads[end]).exp() * x
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
