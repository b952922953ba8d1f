//! Errors where the mean gap was given and the load was looked for.
//!
//! The gap at a load is known to a half width `d`. Turned round, the load at a gap is known to
//! `d p'`, with `p'` the slope of the load curve; and the area, which follows the load with at most
//! the first power, is that much less certain than it is at a given load. The slope needs no further
//! solution: the energy `W` per nominal area grows with what the load does on the way, `dW = -p
//! d(gap)`, and as long as `W` is in proportion to `p` the gap falls by `W/p` when the load grows
//! e-fold. Near full contact it falls by less, and the area hardly follows the load any more.

use super::estimate::{Budget, Estimate, Given};
use super::fall::{CAUTION, area_per_load, least_fall};
use fft_bem_solver::Solution;

impl Budget {
    /// The same for a solution whose mean gap was prescribed: the gap is exact, the load is not,
    /// and the area follows the load.
    #[must_use]
    pub fn at_given_gap(mut self, solution: &Solution) -> Self {
        let Some(gap) = self.mean_gap else { return self };
        let fall = least_fall(solution);
        // Without contact, or with full contact, there is nothing to turn round.
        let e_folds = |half: f64| if half > 0.0 { half / fall } else { 0.0 };
        let (load, area) = (self.mean_pressure.value, self.area.value);
        let grid = gap.grid.map(e_folds);
        let iteration = gap.iteration.map(e_folds);
        // The scatter is no small part of the gap, which is the exponential of a number, and the load
        // that of another. It is found with a caution of its own.
        let even =
            |half: f64| if gap.value > 0.0 { gap.value * (half / gap.value).ln_1p() } else { 0.0 };
        let sample = gap.sample.map(|half| (e_folds(even(half)) / CAUTION).exp_m1());
        let area = area * area_per_load(area);
        self.given = Given::Gap;
        self.mean_gap = Some(Estimate::exact(gap.value));
        self.mean_pressure = Estimate {
            value: load,
            grid: grid.map(|r| load * r),
            iteration: iteration.map(|r| load * r),
            sample: sample.map(|r| load * r),
            least: 0.0,
            most: f64::INFINITY,
        };
        // The least area moves with the load.
        self.floor = None;
        self.area.least = 0.0;
        self.area.grid = self.area.grid.and_then(|half| Ok(half + area * grid?));
        self.area.iteration = self.area.iteration.and_then(|half| Ok(half + area * iteration?));
        self.area.sample = match (self.area.sample, sample) {
            (Some(half), Some(relative)) => Some(half.hypot(area * relative)),
            _ => None,
        };
        self
    }
}
