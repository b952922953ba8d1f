//! Error intervals of `solve`: where they come from, and why there is none.

use crate::text;
use compare::budget::grid::Finer;
use compare::budget::{Budget, Map};
use compare::{NotRefined, TwiceFiner};
use contact_accuracy::NoAreaInterval;
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Solution, SolverBuilder};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::time::Instant;

/// What the errors of all loads are found from.
pub(crate) struct Errors {
    pub(crate) known: Map,
    /// The map that is solved: the given one, or with its mirror images.
    pub(crate) whole: HeightMap,
    /// The given map, if it is not the whole.
    pub(crate) part: Option<HeightMap>,
    pub(crate) finer: Finest,
}

/// The twice finer grid, made for the first load that needs it.
pub(crate) struct Finest {
    pub(crate) builder: SolverBuilder,
    pub(crate) boundary: Boundary,
    pub(crate) modulus: ContactModulus,
    pub(crate) made: Option<TwiceFiner>,
}

impl Finest {
    /// A load on the finer grid.
    pub(crate) fn solve(
        &mut self,
        load: Load,
        map: &HeightMap,
        known: &Map,
        budget: &Budget,
    ) -> Result<Refined, NotRefined> {
        let start = Instant::now();
        let finer = match &mut self.made {
            Some(finer) => finer,
            none => {
                let builder = self.builder.clone();
                none.insert(TwiceFiner::of(map, known, self.boundary, builder, self.modulus)?)
            }
        };
        let found = finer.solve(load, budget)?;
        Ok(Refined { found, grid: finer.grid(), seconds: start.elapsed().as_secs_f64() })
    }
}

/// A load on the twice finer grid.
#[derive(Clone, Copy)]
pub(crate) struct Refined {
    pub(crate) found: Finer,
    grid: Grid,
    seconds: f64,
}

impl Refined {
    /// What a script sees of it.
    pub(crate) fn json(&self) -> Value {
        json!({
            "shape": self.grid.shape(),
            "area_fraction_corrected": self.found.area,
            "mean_pressure": self.found.pressure,
            "mean_gap": self.found.gap,
            "monotone_area_fraction_corrected": self.found.monotone.map(|(area, ..)| area),
            "seconds": self.seconds,
        })
    }
}

/// The budget of a load by what was prescribed.
pub(crate) fn under(load: Load, budget: &Budget, solution: &Solution) -> Budget {
    match load {
        Load::MeanGap(_) => budget.at_given_gap(solution),
        _ => *budget,
    }
}

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
    /// A load that was solved, as it is `shown`.
    pub(crate) fn take(
        &mut self,
        shown: &str,
        solution: &Solution,
        budget: &Budget,
        refined: Option<Refined>,
    ) {
        if let Some(Refined { found, grid, seconds }) = refined {
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
