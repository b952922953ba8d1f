//! Error intervals of `solve` in words: what they were paid with, and why there is none.

use crate::loads::{rising, shown};
use crate::text;
use answers::{Point, Refined};
use compare::TwiceFiner;
use compare::budget::Budget;
use contact_accuracy::NoAreaInterval;
use fft_bem_solver::{Load, Solution};
use std::fmt::Write as _;

/// What is said below the table about intervals that are missing or were paid for.
#[derive(Default)]
pub(crate) struct Intervals {
    /// Reason, loads without an interval for it.
    missing: Vec<(String, Vec<String>)>,
    /// Seconds of those a finer grid would give one, if any.
    pub(crate) refinable: Option<f64>,
    lines: Vec<String>,
}

impl Intervals {
    /// Of all points, in the order in which they were solved.
    pub(crate) fn of(points: &[Point]) -> Self {
        let loads: Vec<Load> = points.iter().map(|point| point.load).collect();
        let mut all = Self::default();
        for index in rising(&loads) {
            let point = &points[index];
            if let (true, Some(solution), Some(budget)) =
                (point.converged, &point.solution, &point.budget)
            {
                all.take(&shown(point.load), solution, budget, point.refined.as_ref());
            }
        }
        all
    }

    /// A load that was solved, as it is `shown`.
    fn take(
        &mut self,
        shown: &str,
        solution: &Solution,
        budget: &Budget,
        refined: Option<&Refined>,
    ) {
        if let Some(&Refined { found, grid, seconds }) = refined {
            let [ny, nx] = grid.shape();
            let other = found.monotone.map_or(String::new(), |(area, ..)| {
                let area = text::percent(area);
                format!(", and one of a surface through the same points that does not ring, {area}")
            });
            self.lines.push(format!(
                "{shown}: ± from one more solution on {ny} × {nx} points, which reads {}{other} ({})",
                text::percent(found.area),
                text::seconds(seconds)
            ));
        }
        let Err(why) = budget.area.comparison_half_width() else { return };
        if TwiceFiner::helps(budget) {
            *self.refinable.get_or_insert(0.0) += solution.diagnostics.seconds;
        }
        let why = match (why, solution.state.mean_gap) {
            // The flat hangs above: by as much as it has approached less than nothing.
            (NoAreaInterval::Empty, Some(gap)) => {
                format!(
                    "{why}; first contact at a mean gap of {}",
                    text::length(gap + solution.approach)
                )
            }
            _ => why.to_string(),
        };
        match self.missing.iter_mut().find(|(known, _)| *known == why) {
            Some((_, loads)) => loads.push(shown.to_owned()),
            None => self.missing.push((why, vec![shown.to_owned()])),
        }
    }

    /// One line for each reason, and one with the way out if the user `may_refine`.
    pub(crate) fn notes(&self, may_refine: bool) -> String {
        let mut notes = String::new();
        // Writing to a String cannot fail.
        for line in &self.lines {
            let _ = writeln!(notes, "{line}");
        }
        for (why, loads) in &self.missing {
            let _ = writeln!(notes, "no ± at {}: {why}", loads.join(", "));
        }
        if let (Some(seconds), true) = (self.refinable, may_refine) {
            let time = 5.0 * seconds;
            let time = if time < 0.5 {
                "less than a second".to_owned()
            } else {
                format!("about {}", text::seconds(time))
            };
            let _ = writeln!(notes, "--refine gives one from a twice finer grid, in {time}");
        }
        notes
    }
}
