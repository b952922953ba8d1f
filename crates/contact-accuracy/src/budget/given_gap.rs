//! Errors where the mean gap was given and the load was looked for.
//!
//! The gap at a load is known to a half width `d`. Turned round, the load at a gap is known to
//! `d p'`, with `p'` the slope of the load curve; and the area, which follows the load with at most
//! the first power, is that much less certain than it is at a given load. The slope needs no further
//! solution: the energy `W` per nominal area grows with what the load does on the way, `dW = -p
//! d(gap)`, and as long as `W` is in proportion to `p` the gap falls by `W/p` when the load grows
//! e-fold. Near full contact it falls by less, and the area hardly follows the load any more.

use super::estimate::{Budget, Estimate, Given};
use fft_bem_solver::Solution;

/// Fall of the gap per e-fold load over `W/p`, while most of the surface is out of contact.
const FALL: f64 = 1.06;
/// Near full contact it goes as `sqrt(1 - exp(-this gap/fall))`.
const LEVELLING: f64 = 1.2;
/// By how much smaller than this it may be; the load is uncertain by that much more.
const CAUTION: f64 = 1.5;

/// The least by which the mean gap falls when the load grows e-fold (m), from a solution with a
/// mean gap; 0 if nothing touches.
pub fn least_fall(solution: &Solution) -> f64 {
    let (state, energy) = (&solution.state, solution.diagnostics.elastic_energy);
    let (Some(gap), true) = (state.mean_gap, state.mean_pressure > 0.0) else { return 0.0 };
    let fall = FALL * energy / state.mean_pressure;
    if fall <= 0.0 {
        return 0.0;
    }
    fall * (1.0 - (-LEVELLING * gap.max(0.0) / fall).exp()).sqrt() / CAUTION
}

/// Fall of the mean gap when the load grows e-fold, over the gap \[-\]; 0 without a gap.
pub(super) fn fall_over_gap(solution: &Solution) -> f64 {
    let gap = solution.state.mean_gap.filter(|gap| *gap > 0.0);
    gap.map_or(0.0, |gap| CAUTION * least_fall(solution) / gap)
}

/// Relative change of the area over that of the load, at most: 1 at light load, 0 at full contact.
/// Persson's (2001, doi:10.1063/1.1388626) area, `erf(c p)`, has 0.3 % to half of it less than this.
pub fn area_per_load(area: f64) -> f64 {
    (1.0 - area * area).max(0.0).sqrt()
}

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
            most: f64::INFINITY,
        };
        self.area.grid = self.area.grid.and_then(|half| Ok(half + area * grid?));
        self.area.iteration = self.area.iteration.and_then(|half| Ok(half + area * iteration?));
        self.area.sample = match (self.area.sample, sample) {
            (Some(half), Some(relative)) => Some(half.hypot(area * relative)),
            _ => None,
        };
        self
    }
}
