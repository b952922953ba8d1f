//! The least area of a contact that yields.

use super::no_interval::NoAreaInterval;
use fft_bem_solver::{Boundary, Solution};

/// No pressure exceeds the hardness H, so at mean pressure P the area fraction is at least P/H: on this grid, on a finer
/// one, whatever lies between the points. Where most of the contact has yielded that decides the area.
///
/// Of 1200 solutions (16 random surfaces of 2 to 8 points to the shortest wave, heights plain, of few high peaks and of plateaus;
/// E\* g/H = 2 to 50, P/H = 0.003 to 0.9) the area on four times as many points a side, between which heights were
/// waves, linear or constant, lay from 0.71 below to 0.94 above the corrected area, in units of touching points
/// less P/H (`examples/yielding_floor.rs`).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Floor {
    /// P/H (-); of a hardness for each pixel, by the highest of them.
    pub area: f64,
    /// What the touching points are above it (-).
    pub above: f64,
    /// Largest half width that is worth saying (-).
    most: f64,
}

/// Part of the area above which its distance from the floor tells too little.
const TELLING: f64 = 0.5;

impl Floor {
    /// Of a solution part of which has yielded, the load being given; `None` of others.
    pub(super) fn of(solution: &Solution) -> Option<Self> {
        let found = &solution.diagnostics;
        let yielded = found.yielded.filter(|y| y.area_fraction > 0.0)?;
        // That of an isolated contact was not studied.
        (found.boundary == Boundary::Periodic).then_some(())?;
        let area = (solution.state.mean_pressure / yielded.hardness).min(1.0);
        let above = (solution.state.area_fraction - area).max(0.0);
        Some(Self { area, above, most: TELLING * found.area_fraction_corrected })
    }

    /// A bar of the area from the grid, or its distance from the floor if that is less, or if there is no
    /// bar and it tells something.
    pub(super) fn bar(self, grid: Result<f64, NoAreaInterval>) -> Result<f64, NoAreaInterval> {
        match grid {
            Ok(half) => Ok(half.min(self.above)),
            Err(_) if self.above <= self.most => Ok(self.above),
            none => none,
        }
    }
}
