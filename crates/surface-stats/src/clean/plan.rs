//! Several cleaning steps in a row, with a record of what each did.

use super::form::take_form_off;
use super::rows::offsets;
use super::{
    Form, FormParameters, Outliers, find_outliers, gaussian_filter, row_jumps, short_waves,
};
use crate::StatsError;
use crate::numbers::{METRES, plain, quantity};
use contact_types::Grid;
use std::fmt;

/// One step, as asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// Rows that stand at heights of their own are put in line.
    Rows,
    /// Spikes, beyond this number of robust standard deviations, become missing points.
    Outliers(f64),
    /// The fitted form is taken off.
    Form(Form),
    /// Waves shorter than this are taken off (m).
    SFilter(f64),
    /// Waves longer than this are taken off (m).
    LFilter(f64),
}

/// One step, as done. [`fmt::Display`] writes one line for a report.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "step", rename_all = "snake_case")
)]
pub enum Record {
    /// Rows put in line.
    Rows {
        /// Rms jump from row to row before (m).
        jump: f64,
        /// Largest offset taken off a row (m).
        largest: f64,
    },
    /// Spikes found and made missing.
    Outliers {
        /// Robust standard deviations beyond which a point is a spike.
        threshold: f64,
        /// Spikes.
        count: usize,
        /// Distance from the local median beyond which a point was a spike (m).
        limit: f64,
        /// Largest distance of a spike (m).
        largest: f64,
    },
    /// Form taken off.
    Form {
        /// What was found.
        #[cfg_attr(feature = "serde", serde(flatten))]
        parameters: FormParameters,
        /// Valid points fitted.
        points: usize,
    },
    /// Short waves taken off.
    SFilter {
        /// Nesting index (m).
        nesting_index: f64,
    },
    /// Long waves taken off.
    LFilter {
        /// Nesting index (m).
        nesting_index: f64,
    },
}

/// Does `steps` in the order given on `heights` (m, row-major, NaN = missing) and says what each
/// did. Nothing else is done; without steps nothing is.
///
/// # Errors
/// Those of the steps. Heights are then as the steps before left them.
pub fn apply(
    grid: Grid,
    heights: &mut Vec<f64>,
    steps: &[Step],
) -> Result<Vec<Record>, StatsError> {
    let mut records = Vec::with_capacity(steps.len());
    for &step in steps {
        records.push(match step {
            Step::Rows => {
                let (jumps, jump, _) = row_jumps(grid, heights)?;
                let offsets = offsets(&jumps)?;
                for (row, offset) in heights.chunks_exact_mut(grid.shape()[1]).zip(&offsets) {
                    for h in row {
                        *h -= offset;
                    }
                }
                let largest = offsets.iter().fold(0.0f64, |m, o| m.max(o.abs()));
                Record::Rows { jump, largest }
            }
            Step::Outliers(threshold) => {
                let Outliers { indices, limit, largest } = find_outliers(grid, heights, threshold)?;
                for &i in &indices {
                    heights[i] = f64::NAN;
                }
                Record::Outliers { threshold, count: indices.len(), limit, largest }
            }
            Step::Form(form) => {
                let (parameters, points) = take_form_off(grid, heights, form)?;
                Record::Form { parameters, points }
            }
            Step::SFilter(nesting_index) => {
                *heights = gaussian_filter(grid, heights, nesting_index)?;
                Record::SFilter { nesting_index }
            }
            Step::LFilter(nesting_index) => {
                *heights = short_waves(grid, heights, nesting_index)?;
                Record::LFilter { nesting_index }
            }
        });
    }
    Ok(records)
}

/// A length with four digits, in the unit that suits it.
fn shown(length: f64) -> String {
    if length < 1e7 { plain(&quantity(length, METRES, 4)) } else { format!("{length:.3e} m") }
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Rows { jump, largest } => write!(
                f,
                "rows put in line by the median of their differences: they jumped by {} rms, \
                 the largest offset was {}",
                shown(jump),
                shown(largest)
            ),
            Self::Outliers { threshold, count, limit, largest } => {
                let (limit, largest) = (shown(limit), shown(largest));
                let rule = format!("({threshold} robust standard deviations, 5 × 5 pixels)");
                if count == 0 {
                    let text = "no spikes: no point is more than";
                    return write!(f, "{text} {limit} off its neighbours {rule}");
                }
                let ending = if count == 1 { "" } else { "s" };
                write!(
                    f,
                    "{count} spike{ending} removed: more than {limit} off the neighbours \
                     {rule}, the farthest by {largest}"
                )
            }
            Self::Form { parameters, points } => {
                match parameters {
                    FormParameters::Polynomial { degree: 1 } => f.write_str("plane")?,
                    FormParameters::Polynomial { degree } => {
                        write!(f, "polynomial of degree {degree}")?;
                    }
                    FormParameters::Sphere { radius, .. } => {
                        write!(f, "sphere of radius {} ({})", shown(radius.abs()), way(radius))?;
                    }
                    FormParameters::Cylinder { radius, direction, .. } => write!(
                        f,
                        "cylinder of radius {} ({}), axis {:.2}° from x",
                        shown(radius.abs()),
                        way(radius),
                        direction.to_degrees()
                    )?,
                }
                write!(f, " fitted to {points} points and taken off")
            }
            Self::SFilter { nesting_index } => filter(f, "S-filter: waves shorter", nesting_index),
            Self::LFilter { nesting_index } => filter(f, "L-filter: waves longer", nesting_index),
        }
    }
}

fn filter(f: &mut fmt::Formatter<'_>, what: &str, nesting_index: f64) -> fmt::Result {
    let length = shown(nesting_index);
    write!(f, "{what} than {length} taken off (Gaussian, ISO 16610-61)")
}

fn way(radius: f64) -> &'static str {
    if radius > 0.0 { "convex" } else { "concave" }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::rough;

    #[test]
    fn a_radius_has_four_digits() {
        let shown = [0.322_694_106, 2e-3, 2.3e3, 3e7, f64::INFINITY].map(shown);
        assert_eq!(shown, ["322.7 mm", "2.000 mm", "2.300 km", "3.000e7 m", "inf m"]);
    }

    /// With a spike and a hole; the rough flat is filtered alike.
    #[test]
    fn a_rough_ball_comes_out_as_the_rough_flat() {
        let grid = Grid::new([120, 100], [1e-6, 1e-6]).unwrap();
        let rough = rough(grid, 0.8, [20e-6, 5e-6], 20e-9, 8).into_heights();
        let ball = |i: usize| {
            let (y, x) = ((i / 100) as f64 * 1e-6 - 55e-6, (i % 100) as f64 * 1e-6 - 40e-6);
            ((2e-3f64).powi(2) - y * y - x * x).sqrt()
        };
        let mut heights: Vec<f64> = rough.iter().enumerate().map(|(i, h)| h + ball(i)).collect();
        heights[4040] += 3e-6;
        heights[500..520].fill(f64::NAN);
        let steps = [Step::Outliers(8.0), Step::Form(Form::Sphere), Step::SFilter(6e-6)];
        let records = apply(grid, &mut heights, &steps).unwrap();
        assert!(matches!(records[0], Record::Outliers { count: 1, .. }));
        let Record::Form { parameters: FormParameters::Sphere { radius, .. }, points } = records[1]
        else {
            panic!("no sphere")
        };
        assert_eq!(points, 120 * 100 - 21);
        assert!((radius / 2e-3 - 1.0).abs() < 0.01, "{radius}");
        let filtered = gaussian_filter(grid, &rough, 6e-6).unwrap();
        for (i, (h, r)) in heights.iter().zip(&filtered).enumerate() {
            let missing = i == 4040 || (500..520).contains(&i);
            assert_eq!(h.is_nan(), missing);
            assert!(missing || (h - r).abs() < 15e-9, "{i}: {h:e} {r:e}"); // the fit takes 4 waves
        }
        let text: Vec<String> = records.iter().map(ToString::to_string).collect();
        assert!(text[0].starts_with("1 spike removed: more than "), "{text:?}");
        assert!(text[1].contains("(convex) fitted to 11979 points"), "{text:?}");
    }
}
