//! What is asked for, and what follows for the iteration.

use crate::uncertainty::iteration_of_area as area_error;
use fft_bem_solver::Precision;

/// Part of the request that the iteration may use up.
const ITERATION_SHARE: f64 = 0.2;
/// Below this tolerance single precision may end before the iteration does.
const SINGLE: f64 = 1e-4;
/// No tolerance below: an area never needs it.
const TIGHTEST: f64 = 1e-8;

/// Half width of the interval around the area that is asked for, relative to the area.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AccuracyRequest(f64);

/// A request that is none.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BadRequest {
    /// Not a percentage.
    #[error("'{0}' is no accuracy; write a percentage of the area, for example 2%")]
    Syntax(String),
    /// Not between 0 and 50 %.
    #[error(
        "an accuracy of {} % cannot be asked for: it must be greater than 0 and at most 50 %",
        100.0 * .0
    )]
    Range(f64),
}

impl AccuracyRequest {
    /// From a relative half width, as 0.02.
    ///
    /// # Errors
    /// [`BadRequest::Range`] unless it is greater than 0 and at most 0.5.
    pub fn new(relative: f64) -> Result<Self, BadRequest> {
        if relative > 0.0 && relative <= 0.5 {
            Ok(Self(relative))
        } else {
            Err(BadRequest::Range(relative))
        }
    }

    /// From a percentage as typed, `2%` or `0.5 %`.
    ///
    /// # Errors
    /// [`BadRequest`].
    pub fn parse(text: &str) -> Result<Self, BadRequest> {
        let number = text.trim().strip_suffix('%').and_then(|n| n.trim().parse::<f64>().ok());
        Self::new(number.ok_or_else(|| BadRequest::Syntax(text.to_owned()))? / 100.0)
    }

    /// The relative half width.
    pub fn relative(self) -> f64 {
        self.0
    }

    /// Relative rms pressure error at which the solver may stop: the area error it leaves is at
    /// most a fifth of the request. Rounded down to one digit.
    pub(crate) fn tolerance(self) -> f64 {
        let exact = (ITERATION_SHARE * self.0 / area_error(1.0)).max(TIGHTEST);
        let decade = exact.log10().floor() as i32;
        // A quotient just below a whole digit is that digit.
        let digit = (exact / 10f64.powi(decade) + 1e-9).floor().max(1.0);
        format!("{digit}e{decade}").parse().unwrap_or(exact)
    }

    /// Half the bytes wherever single precision reaches the tolerance.
    pub(crate) fn precision(self) -> Precision {
        if cfg!(feature = "single") && self.tolerance() >= SINGLE {
            Precision::Single
        } else {
            Precision::Double
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_request_is_a_percentage() {
        assert_eq!(AccuracyRequest::parse("2%"), AccuracyRequest::new(0.02));
        assert_eq!(AccuracyRequest::parse(" 0.5 % "), AccuracyRequest::new(0.005));
        for bad in ["2", "0.02", "%", "two%", ""] {
            assert!(matches!(AccuracyRequest::parse(bad), Err(BadRequest::Syntax(_))), "{bad}");
        }
        for bad in ["0%", "-1%", "60%", "nan%", "inf%"] {
            assert!(matches!(AccuracyRequest::parse(bad), Err(BadRequest::Range(_))), "{bad}");
        }
    }

    #[test]
    fn the_iteration_takes_at_most_a_fifth() {
        for percent in [50.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.1, 0.01] {
            let request = AccuracyRequest::new(percent / 100.0).unwrap();
            let share = area_error(request.tolerance()) / request.relative();
            assert!(share <= 0.2 + 1e-9 && share > 0.1, "{percent}: {share}");
        }
        assert_eq!(AccuracyRequest::new(0.02).unwrap().precision(), Precision::Single);
        assert_eq!(AccuracyRequest::new(0.001).unwrap().precision(), Precision::Double);
    }
}
