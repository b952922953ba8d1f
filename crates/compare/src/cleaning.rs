//! What is done to the heights of a file before its missing points are filled.

use contact_types::Grid;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use surface_stats::clean::{Form, OutlierRule, Step};
use surface_stats::polynomial::MAX_DEGREE;

/// Cleaning asked for. The order is fixed and is that of the fields: rows first, whose
/// jumps hide spikes and form, then spikes, because they
/// pull every fit and every mean; form before the filters, whose end effects grow with the slope
/// at the edges.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cleaning {
    /// Rows that stand at heights of their own put in line.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub align_rows: bool,
    /// Robust standard deviations beyond which a point is a spike and becomes a missing point.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outliers: Option<f64>,
    /// Form taken off by least squares.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub form: Option<FormName>,
    /// Nesting index of the S-filter (m): shorter waves are taken off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s_filter: Option<f64>,
    /// Nesting index of the L-filter (m): longer waves are taken off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub l_filter: Option<f64>,
}

/// Cleaning that cannot be done.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CleaningError {
    /// A cut-off that the points cannot show.
    #[error(
        "a filter with a cut-off of {cutoff:e} m sees nothing between points {pixel:e} m apart; \
         give at least two points, {:e} m, or leave it out", 2.0 * pixel
    )]
    CutoffTooShort {
        /// The cut-off (m).
        cutoff: f64,
        /// The larger pixel side (m).
        pixel: f64,
    },
    /// Filters that leave nothing between them.
    #[error(
        "an S-filter at {s_filter:e} m and an L-filter at {l_filter:e} m leave no wave; the \
         S-filter takes short waves off, so give it the shorter cut-off"
    )]
    NothingLeft {
        /// Nesting index of the S-filter (m).
        s_filter: f64,
        /// Nesting index of the L-filter (m).
        l_filter: f64,
    },
}

impl Cleaning {
    /// True if nothing is asked for.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// The steps in the order in which they are done.
    pub fn steps(&self) -> Vec<Step> {
        let rule = |threshold| OutlierRule::beyond(threshold);
        [
            self.align_rows.then_some(Step::Rows),
            self.outliers.map(|threshold| Step::Outliers(rule(threshold))),
            self.form.map(|FormName(form)| Step::Form(form)),
            self.s_filter.map(Step::SFilter),
            self.l_filter.map(Step::LFilter),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// Whether the filters make sense on `grid`.
    ///
    /// # Errors
    /// [`CleaningError`].
    pub fn check(&self, grid: Grid) -> Result<(), CleaningError> {
        let [dy, dx] = grid.pixel();
        let pixel = dy.max(dx);
        for cutoff in self.s_filter.into_iter().chain(self.l_filter) {
            if !(cutoff.is_finite() && cutoff >= 2.0 * pixel) {
                return Err(CleaningError::CutoffTooShort { cutoff, pixel });
            }
        }
        match (self.s_filter, self.l_filter) {
            (Some(s_filter), Some(l_filter)) if s_filter >= l_filter => {
                Err(CleaningError::NothingLeft { s_filter, l_filter })
            }
            _ => Ok(()),
        }
    }
}

/// A form as it is typed: `plane`, `quadratic`, `polynomial:N`, `sphere` or `cylinder`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct FormName(pub Form);

impl FromStr for FormName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = match text.trim() {
            "plane" => Form::Polynomial(1),
            "quadratic" => Form::Polynomial(2),
            "sphere" => Form::Sphere,
            "cylinder" => Form::Cylinder,
            other => match other.strip_prefix("polynomial:").map(str::parse) {
                Some(Ok(degree)) if degree <= MAX_DEGREE => Form::Polynomial(degree),
                Some(_) => {
                    return Err(format!(
                        "'{other}' has no degree from 0 to {MAX_DEGREE}; write for example \
                         polynomial:4"
                    ));
                }
                None => {
                    return Err(format!(
                        "'{other}' is no form; write plane, quadratic, polynomial:N with N from 0 \
                         to {MAX_DEGREE}, sphere or cylinder"
                    ));
                }
            },
        };
        Ok(Self(form))
    }
}

impl fmt::Display for FormName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Form::Polynomial(1) => f.write_str("plane"),
            Form::Polynomial(2) => f.write_str("quadratic"),
            Form::Polynomial(degree) => write!(f, "polynomial:{degree}"),
            Form::Sphere => f.write_str("sphere"),
            Form::Cylinder => f.write_str("cylinder"),
        }
    }
}

impl TryFrom<String> for FormName {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl From<FormName> for String {
    fn from(form: FormName) -> Self {
        form.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_read_back_as_they_are_written() {
        for text in ["plane", "quadratic", "polynomial:0", "polynomial:12", "sphere", "cylinder"] {
            assert_eq!(text.parse::<FormName>().unwrap().to_string(), text);
        }
        assert_eq!("polynomial:1".parse::<FormName>(), "plane".parse());
        for text in ["polynomial:13", "polynomial:", "polynomial:-1", "polynomial:2.5", "ball", ""]
        {
            assert!(text.parse::<FormName>().is_err(), "{text}");
        }
    }

    #[test]
    fn filters_that_leave_nothing_are_refused() {
        let grid = Grid::new([10, 10], [1e-6, 2e-6]).unwrap();
        let of = |s_filter, l_filter| Cleaning { s_filter, l_filter, ..Cleaning::default() };
        assert!(of(Some(4e-6), Some(5e-6)).check(grid).is_ok());
        assert!(of(None, None).check(grid).is_ok() && of(None, None).is_empty());
        assert!(matches!(
            of(Some(3.9e-6), None).check(grid),
            Err(CleaningError::CutoffTooShort { .. })
        ));
        assert!(matches!(
            of(Some(5e-6), Some(5e-6)).check(grid),
            Err(CleaningError::NothingLeft { .. })
        ));
    }
}
