//! Several cleaning steps in a row, with a record of what each did.

use super::form::take_form_off;
use super::{
    Form, FormParameters, OutlierRule, find_outliers, gaussian_filter, row_offsets, short_waves,
};
use crate::{Edges, StatsError};
use contact_types::Grid;
use std::fmt;

/// One step, as asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Step {
    /// Rows that stand at heights of their own are put in line.
    Rows,
    /// Spikes become missing points.
    Outliers(OutlierRule),
    /// The fitted form is taken off.
    Form(Form),
    /// Waves shorter than this are taken off (m).
    SFilter(f64),
    /// Waves longer than this are taken off (m).
    LFilter(f64),
}

/// One step, as done. [`fmt::Display`] writes one line for a report.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
        /// The rule.
        rule: OutlierRule,
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
    edges: Edges,
) -> Result<Vec<Record>, StatsError> {
    let mut records = Vec::with_capacity(steps.len());
    for &step in steps {
        records.push(match step {
            Step::Rows => {
                let found = row_offsets(grid, heights)?;
                found.remove_from(heights);
                let largest = found.offsets.iter().fold(0.0f64, |m, o| m.max(o.abs()));
                Record::Rows { jump: found.jump, largest }
            }
            Step::Outliers(rule) => {
                let found = find_outliers(grid, heights, rule)?;
                found.remove_from(heights);
                let (count, limit, largest) = (found.indices.len(), found.limit, found.largest);
                Record::Outliers { rule, count, limit, largest }
            }
            Step::Form(form) => {
                let (parameters, points) = take_form_off(grid, heights, form)?;
                Record::Form { parameters, points }
            }
            Step::SFilter(nesting_index) => {
                *heights = gaussian_filter(grid, heights, nesting_index, edges)?;
                Record::SFilter { nesting_index }
            }
            Step::LFilter(nesting_index) => {
                *heights = short_waves(grid, heights, nesting_index, edges)?;
                Record::LFilter { nesting_index }
            }
        });
    }
    Ok(records)
}

/// A radius with four digits, in the unit that suits it.
fn shown(radius: f64) -> String {
    let units = [(1e3, "km"), (1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm")];
    let fits = |(scale, _): &(f64, &str)| radius >= 0.99995 * scale;
    let Some((scale, unit)) = units.into_iter().find(fits).filter(|_| radius < 1e7) else {
        return format!("{radius:.3e} m");
    };
    let value = radius / scale;
    let digits = (3 - value.log10().floor() as i32).max(0) as usize;
    format!("{value:.digits$} {unit}")
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Rows { jump, largest } => write!(
                f,
                "rows put in line by the median of their differences: they jumped by {:.4} µm rms, \
                 the largest offset was {:.4} µm",
                1e6 * jump,
                1e6 * largest
            ),
            Self::Outliers { rule, count, limit, largest } => {
                let (limit, largest, width) = (1e6 * limit, 1e6 * largest, 2 * rule.reach + 1);
                let rule = format!(
                    "({} robust standard deviations, {width} × {width} pixels)",
                    rule.threshold
                );
                if count == 0 {
                    let text = "no spikes: no point is more than";
                    return write!(f, "{text} {limit:.4} µm off its neighbours {rule}");
                }
                let ending = if count == 1 { "" } else { "s" };
                write!(
                    f,
                    "{count} spike{ending} removed: more than {limit:.4} µm off the neighbours \
                     {rule}, the farthest by {largest:.4} µm"
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
            Self::SFilter { nesting_index } => write!(
                f,
                "S-filter: waves shorter than {:.4} µm taken off (Gaussian, ISO 16610-61)",
                1e6 * nesting_index
            ),
            Self::LFilter { nesting_index } => write!(
                f,
                "L-filter: waves longer than {:.4} µm taken off (Gaussian, ISO 16610-61)",
                1e6 * nesting_index
            ),
        }
    }
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
        assert_eq!(shown(0.322_694_106), "322.7 mm");
        assert_eq!(shown(2e-3), "2.000 mm");
        assert_eq!(shown(2.3e3), "2.300 km");
    }

    /// A rough ball with a spike and a hole: after spike, form and S-filter the relief is that of
    /// the rough flat, filtered alike.
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
        let steps =
            [Step::Outliers(OutlierRule::default()), Step::Form(Form::Sphere), Step::SFilter(6e-6)];
        let records = apply(grid, &mut heights, &steps, Edges::Open).unwrap();
        assert!(matches!(records[0], Record::Outliers { count: 1, .. }));
        let Record::Form { parameters: FormParameters::Sphere { radius, .. }, points } = records[1]
        else {
            panic!("no sphere")
        };
        assert_eq!(points, 120 * 100 - 21);
        assert!((radius / 2e-3 - 1.0).abs() < 0.01, "{radius}");
        let filtered = gaussian_filter(grid, &rough, 6e-6, Edges::Open).unwrap();
        for (i, (h, r)) in heights.iter().zip(&filtered).enumerate() {
            let missing = i == 4040 || (500..520).contains(&i);
            assert_eq!(h.is_nan(), missing);
            assert!(missing || (h - r).abs() < 15e-9, "{i}: {h:e} {r:e}"); // the fit takes 4 waves
        }
        let text: Vec<String> = records.iter().map(ToString::to_string).collect();
        assert!(text[0].starts_with("1 spike removed: more than "), "{text:?}");
        assert!(text[1].contains("(convex) fitted to 11979 points"), "{text:?}");
    }

    /// Rows of a smooth map, each at a height of its own, stand in line afterwards.
    #[test]
    fn rows_come_into_line() {
        let grid = Grid::new([40, 50], [1e-6, 1e-6]).unwrap();
        let wave = |i: usize| 1e-8 * (0.5 * (i % 50) as f64).sin();
        let offset = |iy: usize| if iy.is_multiple_of(3) { 4e-8 } else { -2e-8 };
        let mut heights: Vec<f64> = (0..2000).map(|i| wave(i) + offset(i / 50)).collect();
        let records = apply(grid, &mut heights, &[Step::Rows], Edges::Open).unwrap();
        let Record::Rows { jump, largest } = records[0] else { panic!("{records:?}") };
        assert!(jump > 4e-8 && largest > 3.9e-8, "{jump:e} {largest:e}");
        assert!(!row_offsets(grid, &heights).unwrap().rows_jump());
        for row in heights.chunks(50).skip(1) {
            for (h, first) in row.iter().zip(&heights[..50]) {
                assert!((h - first).abs() < 1e-8, "{h:e} {first:e}"); // a tilt stays
            }
        }
    }

    #[test]
    fn nothing_asked_nothing_done() {
        let grid = Grid::new([2, 2], [1.0, 1.0]).unwrap();
        let mut heights = vec![1.0, 2.0, 3.0, 9.0];
        assert!(apply(grid, &mut heights, &[], Edges::Open).unwrap().is_empty());
        assert_eq!(heights, [1.0, 2.0, 3.0, 9.0]);
    }
}
