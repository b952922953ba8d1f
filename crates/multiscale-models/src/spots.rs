//! Contact spots of all sizes below a largest one, in power-law numbers.
//!
//! The fractal theories share one structure:
//!
//! ```math
//! n(a) = s\,a_l^{s}\,a^{-s-1}, \qquad F(a) = c\,a^{t}, \quad t = \tfrac32 - s, \qquad
//! \int_0^{a_l} n\,a\,da = \frac{s}{1-s}\,a_l, \qquad
//! \int_{a_c}^{a_l} n\,F\,da = s\,F(a_l)\,\frac{1 - (a_c/a_l)^{\varepsilon}}{\varepsilon},
//! \qquad \varepsilon = t - s
//! ```

use crate::answer::{beyond, underflow};
use crate::wide::Wide;
use contact_types::{ContactState, ModelError, require};

/// Which spots of a fractal surface are plastic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlasticSpots {
    /// None: every spot is elastic.
    None,
    /// Those below a critical area (m²). They count in the area and carry nothing.
    Below(f64),
    /// Those that yield at a hardness (Pa) of the softer body, which they carry.
    OfHardness(f64),
}

/// The spots of a fractal surface on a nominal area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FractalContact {
    /// The model in errors.
    model: &'static str,
    /// Dimension D.
    dimension: f64,
    /// Exponent of the size distribution, 0 < s < 1.
    pub(crate) size_exponent: f64,
    /// `c` of the elastic load of a spot.
    pub(crate) coefficient: Wide,
    /// \[m²\].
    nominal_area: f64,
    /// `None` if every spot is elastic.
    pub(crate) critical: Option<Critical>,
}

/// Below `area` a spot is plastic; `hardness` (Pa) is what it then carries, 0 to leave it out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Critical {
    pub(crate) area: Wide,
    pub(crate) hardness: Wide,
}

impl FractalContact {
    /// Of `what`, a profile or a surface, of this dimension, `1 + excess` to `2 + excess`, and roughness (m) on a nominal
    /// area (m²); `coefficient` is then that of the elastic load of a spot.
    pub(crate) fn new(
        model: &'static str,
        (what, excess): (&'static str, f64),
        [dimension, roughness, nominal_area]: [f64; 3],
        coefficient: impl Fn(Wide) -> Wide,
    ) -> Result<Self, ModelError> {
        let [low, high] = [1.0 + excess, 2.0 + excess];
        if !(dimension > low && dimension < high) {
            let reason =
                format!("the dimension of a fractal {what} lies strictly between {low} and {high}");
            return Err(require::outside(model, "D", dimension, low..=high, reason));
        }
        let roughness = Wide::from(require::positive(model, "fractal roughness", roughness)?);
        require::positive(model, "nominal area", nominal_area)?;
        let (size_exponent, coefficient) = ((dimension - excess) / 2.0, coefficient(roughness));
        Ok(Self { model, dimension, size_exponent, coefficient, nominal_area, critical: None })
    }

    /// `t - s`, exact for every double near 0.
    fn epsilon(&self) -> f64 {
        1.5 - 2.0 * self.size_exponent
    }

    /// The same with these plastic spots. A hardness has a critical area; `reason` says when no double holds it.
    pub(crate) fn with(
        self,
        plastic: PlasticSpots,
        critical_area: impl Fn(f64) -> Wide,
        reason: &'static str,
    ) -> Result<Self, ModelError> {
        let critical = match plastic {
            PlasticSpots::None => return Ok(self),
            PlasticSpots::Below(area) => {
                let area = Wide::from(require::positive(self.model, "critical area", area)?);
                Critical { area, hardness: Wide::from(0.0) }
            }
            PlasticSpots::OfHardness(hardness) => {
                require::positive(self.model, "hardness", hardness)?;
                let area = critical_area(hardness).value();
                if !(area > 0.0 && area.is_finite()) {
                    let (area, domain) = (area.min(f64::MAX), f64::MIN_POSITIVE..=f64::MAX);
                    let what = "critical area";
                    return Err(require::outside(self.model, what, area, domain, reason));
                }
                Critical { area: Wide::from(area), hardness: Wide::from(hardness) }
            }
        };
        Ok(Self { critical: Some(critical), ..self })
    }

    /// The answer at a nominal pressure \[Pa\], from the real area that belongs to a largest spot.
    pub(crate) fn at_pressure(
        &self,
        mean_pressure: f64,
        real_area: impl Fn(Wide) -> Wide,
    ) -> Result<ContactState, ModelError> {
        require::pressure(self.model, mean_pressure)?;
        self.check_convergence()?;
        let load = Wide::from(mean_pressure) * self.nominal_area;
        let is_zero = load.is_zero();
        let largest = if is_zero { load } else { self.largest(load) };
        let area = if is_zero { load } else { real_area(largest) };
        let area_fraction = (area / self.nominal_area).value();
        require::answer(self.model, area_fraction, "mean pressure", mean_pressure)?;
        let largest_fraction = (largest / self.nominal_area).value().min(f64::MAX);
        let caveat = underflow(mean_pressure, area_fraction).or_else(|| {
            if area_fraction > 1.0 {
                let reason = "the spots cover more than the nominal area";
                return Some(beyond("area fraction", area_fraction, 1.0, reason));
            }
            let reason = "one spot is larger than the nominal area";
            let is_larger = largest_fraction > 1.0;
            is_larger.then(|| beyond("largest spot", largest_fraction, 1.0, reason))
        });
        Ok(ContactState { mean_pressure, area_fraction, separation: None, mean_gap: None, caveat })
    }

    /// Refuses a load integral that has no value.
    fn check_convergence(&self) -> Result<(), ModelError> {
        if self.critical.is_some() || self.epsilon() > 0.0 {
            return Ok(());
        }
        let divergence = self.dimension + self.epsilon(); // 3/2 or 5/2, exactly
        let domain = divergence - 0.5..=divergence;
        let reason = format!(
            "the load of ever smaller elastic spots diverges for D >= {divergence}; give a critical \
             area, below which spots are plastic"
        );
        Err(require::outside(self.model, "D", self.dimension, domain, reason))
    }

    /// Area of all spots over that of the largest, `s/(1 - s)`.
    pub(crate) fn area_share(&self) -> f64 {
        self.size_exponent / (1.0 - self.size_exponent)
    }

    /// Load of all spots with a critical area, and its `d ln F / d ln a_l`.
    fn load_and_slope(&self, critical: Critical, largest: Wide) -> (Wide, f64) {
        let (s, epsilon) = (self.size_exponent, self.epsilon());
        let ratio = largest / critical.area;
        let log_ratio = ratio.ln();
        let share = self.area_share();
        if log_ratio <= 0.0 {
            // Every spot is plastic; without a hardness those carry nothing here.
            return (critical.hardness * share * largest, 1.0);
        }
        // (1 - e^{-|eps| L}) / |eps|, L = ln(a_l/a_c); -> L as epsilon -> 0
        let decay = epsilon.abs() * log_ratio;
        let bracket = if decay > 1e-300 { -(-decay).exp_m1() / epsilon.abs() } else { log_ratio };
        let growth = if epsilon < 0.0 { ratio.powf(-epsilon) } else { Wide::from(1.0) };
        let of_largest = self.coefficient * largest.powf(1.5 - s);
        let elastic = of_largest * growth * (s * bracket);
        let plastic = critical.hardness * share * critical.area * ratio.powf(s);
        let elastic_slope = s + 1.0 / bracket + epsilon.min(0.0);
        let elastic_weight = 1.0 / (1.0 + (plastic / elastic).value());
        (elastic + plastic, s + elastic_weight * (elastic_slope - s))
    }

    /// Largest spot that carries `load`. With a critical area: Newton for `ln F` in
    /// `v = ln ln(a_l/a_c)`, kept inside a bracket.
    fn largest(&self, load: Wide) -> Wide {
        let Some(critical) = self.critical else {
            let (s, t) = (self.size_exponent, 1.5 - self.size_exponent);
            let x = load * (self.epsilon() / s) / self.coefficient;
            // x^(1/t), whose exponent next to 1 would be rounded.
            return x * x.powf((1.0 - t) / t);
        };
        let area = critical.area;
        let (threshold, _) = self.load_and_slope(critical, area);
        if !threshold.is_zero() && (load / threshold).value() <= 1.0 {
            // All spots plastic: load is hardness times area.
            return area * (load / threshold);
        }
        // ln(a_l/a_c) from 1e-307, where the spot is critical to rounding, to 22 000: doubles reach 6500.
        let (mut lo, mut hi) = (-706.0_f64, 10.0_f64);
        let mut v = 1.0_f64;
        while hi - lo > 1e-12 {
            let log_ratio = v.exp();
            let (found, slope) = self.load_and_slope(critical, area * Wide::exp(log_ratio));
            let mismatch = if found.is_zero() { f64::NEG_INFINITY } else { (found / load).ln() };
            let step = mismatch / (slope * log_ratio);
            // Quadratic: after a step of 1e-9 the rest is rounding.
            if step.abs() <= 1e-9 * v.abs().max(1.0) {
                v -= step;
                break;
            }
            if mismatch > 0.0 {
                hi = v;
            } else {
                lo = v;
            }
            let newton = v - step;
            v = if newton > lo && newton < hi { newton } else { 0.5 * (lo + hi) };
        }
        let mut spot = area * Wide::exp(v.exp());
        // Two more steps on the spot itself, whose logarithm has lost digits.
        if v > 0.0 {
            for _ in 0..2 {
                let (found, slope) = self.load_and_slope(critical, spot);
                spot = spot * Wide::exp(-(found / load).ln() / slope);
            }
        }
        spot
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest spot carries the load it was asked for, from the smallest to the largest that doubles make.
    #[test]
    fn the_largest_spot_carries_the_load_at_the_ends_of_the_range() {
        let (tiny, huge) = (Wide::from(5e-324), Wide::from(f64::MAX));
        let mut seen = 0;
        for d in [1.0 + f64::EPSILON, 1.2, 1.5, 1.8, 2.0 - f64::EPSILON] {
            for coefficient in [tiny * tiny, Wide::from(1.0), huge * huge] {
                let new = FractalContact::new("", ("profile", 0.0), [d, 1.0, 1.0], |_| coefficient);
                let spots = new.unwrap();
                for area in [tiny, Wide::from(1.0), huge] {
                    for hardness in [Wide::from(0.0), tiny, huge] {
                        for load in [tiny * tiny, Wide::from(1.0), huge * huge] {
                            let critical = Critical { area, hardness };
                            let spots = FractalContact { critical: Some(critical), ..spots };
                            let largest = spots.largest(load);
                            // Newton works on this, at most 6500; where it is small, the area rounds it.
                            let log_ratio = (largest / area).ln();
                            if log_ratio.abs() < 1e-4 {
                                continue;
                            }
                            let miss = (spots.load_and_slope(critical, largest).0 / load).ln();
                            let place = format!("{d} {coefficient:?} {critical:?} {load:?}");
                            assert!(miss.abs() < 1e-11, "{place}: {miss:e}");
                            seen += 1;
                        }
                    }
                }
            }
        }
        assert!(seen > 200, "{seen} cases");
    }
}
