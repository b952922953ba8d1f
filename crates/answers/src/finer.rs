//! Error intervals of a solved load: where they come from.

use compare::budget::grid::Finer;
use compare::budget::{Budget, Map};
use compare::{NotRefined, TwiceFiner};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Solution, SolverBuilder};
use serde_json::{Value, json};
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
#[derive(Clone, Copy, Debug)]
pub struct Refined {
    /// What it says.
    pub found: Finer,
    /// Its grid.
    pub grid: Grid,
    /// Time it took (s).
    pub seconds: f64,
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
