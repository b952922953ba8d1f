//! What can be wrong with a surface or with the input of a model.

use std::borrow::Cow;
use std::ops::RangeInclusive;

/// A grid, a height map or a material that cannot be what it claims to be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// A grid of `[ny, nx]` pixels needs at least one along each axis.
    #[error("a grid of {} x {} pixels is empty; both sides need at least 1 pixel", .0[0], .0[1])]
    EmptyGrid([usize; 2]),
    /// The grid of `[ny, nx]` pixels has more than can be addressed.
    #[error("a grid of {} x {} pixels has more pixels than this machine can address", .0[0], .0[1])]
    GridTooLarge([usize; 2]),
    /// A pixel side must be a positive, finite, normal length.
    #[error(
        "pixel size d{axis} = {value:e} m must be finite and {}",
        shown(&(f64::MIN_POSITIVE..=f64::MAX), *value)
    )]
    BadPixel {
        /// `'x'` or `'y'`.
        axis: char,
        /// The value found \[m\].
        value: f64,
    },
    /// The number of heights differs from the number of pixels.
    #[error("the grid has {expected} pixels but {found} heights were given")]
    Shape {
        /// Pixels of the grid.
        expected: usize,
        /// Heights found.
        found: usize,
    },
    /// A height is NaN or infinite.
    #[error(
        "height at row {iy}, column {ix} is {value}; a height map must be complete and finite \
         ({count} such points): fill the missing points first"
    )]
    NotFinite {
        /// Row of the first offending pixel.
        iy: usize,
        /// Column of the first offending pixel.
        ix: usize,
        /// Its value.
        value: f64,
        /// How many pixels are not finite.
        count: usize,
    },
    /// A material constant is outside its physical range.
    #[error("{quantity} = {value:e} {unit} is outside its domain, {}", shown(domain, *value))]
    Material {
        /// Which constant.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// The range it must lie in.
        domain: RangeInclusive<f64>,
    },
    /// A spectrum is unusable.
    #[error("spectrum entry {index}: {what} = {value:e}, {limit}")]
    Spectrum {
        /// Position in the list given.
        index: usize,
        /// The quantity at fault.
        what: &'static str,
        /// Its value.
        value: f64,
        /// The rule it breaks.
        limit: &'static str,
    },
}

/// Why a model gives no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(tag = "kind", rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum ModelError {
    /// The number itself is unusable: NaN, infinite, or of the wrong sign.
    #[error("{model}: {quantity} = {value:e} is not usable: {requirement}")]
    InvalidInput {
        /// The model asked.
        model: Cow<'static, str>,
        /// Which input.
        quantity: Cow<'static, str>,
        /// Its value.
        #[cfg_attr(feature = "serde", serde(serialize_with = "crate::any_number::serialize"))]
        value: f64,
        /// What it must be, for example "must be finite and greater than 0".
        requirement: Cow<'static, str>,
    },
    /// The number is sound but the theory has no meaning there.
    #[error(
        "{model}: {quantity} = {} is outside its domain, {}: {reason}",
        number(*value),
        shown(domain, *value)
    )]
    OutsideDomain {
        /// The model asked.
        model: Cow<'static, str>,
        /// Which input.
        quantity: Cow<'static, str>,
        /// Its value.
        #[cfg_attr(feature = "serde", serde(serialize_with = "crate::any_number::serialize"))]
        value: f64,
        /// Where the theory holds.
        domain: RangeInclusive<f64>,
        /// Why it does not hold here.
        reason: Cow<'static, str>,
    },
    /// An iteration inside the model did not reach its tolerance.
    #[error("{model}: not converged after {iterations} iterations (residual {residual:e})")]
    NotConverged {
        /// The model asked.
        model: Cow<'static, str>,
        /// Relative residual reached.
        #[cfg_attr(feature = "serde", serde(serialize_with = "crate::any_number::serialize"))]
        residual: f64,
        /// Iterations spent.
        iterations: usize,
    },
}

/// A range as people write it, for a value outside it; the largest and the smallest double stand for no bound.
fn shown(domain: &RangeInclusive<f64>, value: f64) -> String {
    let (low, high) = (*domain.start(), *domain.end());
    match (low <= f64::MIN, high >= f64::MAX) {
        (true, true) => "any finite number".to_owned(),
        (true, false) => format!("at most {}", number(high)),
        (false, true) if low <= f64::MIN_POSITIVE && value <= 0.0 => "greater than 0".to_owned(),
        (false, true) => format!("at least {}", number(low)),
        (false, false) => format!("{} to {}", number(low), number(high)),
    }
}

/// A number as people write it: with a power of ten where plain digits would be a row of zeros.
pub(crate) fn number(value: f64) -> String {
    let plain = value.abs() < 1e6 && (value.abs() >= 1e-4 || value.abs() <= 0.0);
    if plain { value.to_string() } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_that_are_none_are_not_printed() {
        for (domain, text) in [
            (1.5..=f64::MAX, "at least 1.5"),
            (f64::MIN_POSITIVE..=f64::MAX, "greater than 0"),
            (f64::MIN..=2.0, "at most 2"),
            (1.0..=1.5, "1 to 1.5"),
            (0.0..=1e18, "0 to 1e18"),
        ] {
            assert_eq!(shown(&domain, 0.0), text);
        }
        let domain = f64::MIN_POSITIVE..=f64::MAX;
        assert!(shown(&domain, 1e-310).contains("e-308"), "a subnormal is above 0");
    }
}
