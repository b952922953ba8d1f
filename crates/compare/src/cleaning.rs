//! What is done to the heights of a file before its missing points are filled.

use crate::StudyError;
use contact_types::Grid;
use serde::{Deserialize, Serialize};
use surface_stats::clean::{Form, Step};

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
    pub form: Option<Form>,
    /// Nesting index of the S-filter (m): shorter waves are taken off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s_filter: Option<f64>,
    /// Nesting index of the L-filter (m): longer waves are taken off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub l_filter: Option<f64>,
}

impl Cleaning {
    /// True if nothing is asked for.
    pub(crate) fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// The steps in the order in which they are done, on `grid`.
    ///
    /// # Errors
    /// [`StudyError::CutoffTooShort`] and [`StudyError::NothingLeft`] of filters that make no sense there.
    pub fn steps(&self, grid: Grid) -> Result<Vec<Step>, StudyError> {
        let [dy, dx] = grid.pixel();
        let pixel = dy.max(dx);
        for cutoff in self.s_filter.into_iter().chain(self.l_filter) {
            if !(cutoff.is_finite() && cutoff >= 2.0 * pixel) {
                return Err(StudyError::CutoffTooShort { cutoff, pixel });
            }
        }
        if let (Some(s_filter), Some(l_filter)) = (self.s_filter, self.l_filter)
            && s_filter >= l_filter
        {
            return Err(StudyError::NothingLeft { s_filter, l_filter });
        }
        let steps = [
            self.align_rows.then_some(Step::Rows),
            self.outliers.map(Step::Outliers),
            self.form.map(Step::Form),
            self.s_filter.map(Step::SFilter),
            self.l_filter.map(Step::LFilter),
        ];
        Ok(steps.into_iter().flatten().collect())
    }
}
