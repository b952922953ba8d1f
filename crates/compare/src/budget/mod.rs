//! The error budget of a deterministic answer: how far each number may be from the truth, by
//! source, and two intervals that must not be confused.
//!
//! - *Comparison*: grid and iteration. For holding a model against the solution of the same map.
//! - *Prediction*: the finite sample on top. For saying what the surface does, of which the map is
//!   one sample.
//!
//! Sources are in [`grid`], [`iteration`] and [`sample`], one file each, with their constants. The
//! constants come from a study of many surfaces (`cargo xtask budget`, page "Error budget" of the
//! book); where it found no bar that holds, the answer is a reason instead.
//!
//! ```no_run
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let (surface, modulus): (contact_types::HeightMap, contact_types::ContactModulus) = todo!();
//! use compare::budget::{Budget, Map};
//! use fft_bem_solver::{Load, Solver};
//!
//! let map = Map::of(&surface)?; // once per surface: one transform, one sort
//! let mut solver = Solver::builder().build(surface.grid(), modulus)?;
//! let solution = solver.solve(&surface, Load::MeanPressure(1e6))?;
//! let budget = Budget::of(&solution, &map);
//! println!("{:?} {:?}", budget.area.comparison(), budget.area.prediction());
//! # Ok(())
//! # }
//! ```
//!
//! # On another grid
//! [`Budget::of`] holds for the grid the map is given on. Of a solution on a *refined* map take
//! [`grid::Finer`] and hand it to [`Budget::refined`] of the budget on the given grid, which gives
//! the bar that holds outside the gate. Of a solution on a *coarsened* map, whose
//! bar comes from elsewhere, replace the part of the grid with [`Budget::with_grid`]; the parts of
//! iteration and sample stay.
//!
//! # At a given gap
//! [`Budget::of`] takes the load as given. Where the gap was, [`Budget::at_given_gap`] moves what is
//! not known of the gap over to the load, and to the area that follows it.

mod given_gap;
pub mod grid;
pub mod iteration;
pub mod sample;
mod stiffness;

pub use given_gap::{Given, area_per_load, least_fall};
pub use stiffness::Stiffness;

use contact_types::{Grid, HeightMap};
use fft_bem_solver::{AreaAccuracy, Boundary, NoAreaInterval, Solution};
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::{StatsError, height_step};

/// What a map says about the accuracy of answers on it, whatever the load. Made once per surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Map {
    /// The gate, and the bar of the area inside it.
    pub accuracy: AreaAccuracy,
    /// Whether its edges match; if not, answers know less about its gap.
    pub repeats: bool,
    /// Rms height (m).
    pub rms_height: f64,
    /// Relative standard error of the rms height over maps of the same surface.
    pub height_scatter: f64,
    grid: Grid,
}

impl Map {
    /// Looks at edges, gradients, steps and spectrum of `surface`. If the edges do not match, the
    /// spectrum is taken under a Hann window.
    ///
    /// # Errors
    /// [`StatsError::OutOfRange`].
    pub fn of(surface: &HeightMap) -> Result<Self, StatsError> {
        Self::with_step(surface, height_step(surface.heights()))
    }

    /// The same of a map whose heights came in steps of `step` (m), if in any, before it was
    /// levelled or cleaned: afterwards the heights do not show them.
    ///
    /// # Errors
    /// [`StatsError::OutOfRange`].
    pub fn with_step(surface: &HeightMap, step: Option<f64>) -> Result<Self, StatsError> {
        let repeats = crate::plan::repeats(surface);
        let window = if repeats { Window::None } else { Window::Hann };
        let power = PowerSpectrum::of(surface, window)?;
        Ok(Self::known(surface, &power, step.unwrap_or(0.0), repeats))
    }

    /// The same map on another grid: its accuracy there comes from elsewhere.
    #[must_use]
    pub fn on(self, grid: Grid) -> Self {
        Self { grid, ..self }
    }

    /// The same from a spectrum (under a window unless the map `repeats`) and a height step (m, 0
    /// for none) that are known already.
    pub fn known(surface: &HeightMap, power: &PowerSpectrum, step: f64, repeats: bool) -> Self {
        let grid = surface.grid();
        let (moments, [x, y]) = power.moments();
        let [dy, dx] = grid.pixel();
        let relief = moments.rms_gradient() * dy.min(dx);
        let step_ratio = if relief > 0.0 { step / relief } else { 0.0 };
        let resolution = power.resolved_gradient().unwrap_or(1.0);
        let height_scatter = sample::height_scatter(surface, power);
        Self {
            accuracy: AreaAccuracy::known(grid, resolution, step_ratio)
                .with_slopes([y, x])
                .with_waves(grid::waves(power)),
            repeats,
            rms_height: moments.rms_height(),
            height_scatter,
            grid,
        }
    }
}

/// A number with what is known about its error: half widths in its own unit, by source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Left by the grid, or why that is not known.
    pub grid: Result<f64, NoAreaInterval>,
    /// Left by stopping the iteration, or why that is not known.
    pub iteration: Result<f64, NoAreaInterval>,
    /// Scatter over maps of the same surface, 95 %; `None` if this map cannot tell.
    pub sample: Option<f64>,
    /// Largest value that has a meaning; the smallest is 0.
    most: f64,
}

impl Estimate {
    /// Half width from grid and iteration.
    ///
    /// # Errors
    /// Why there is none.
    pub fn comparison_half_width(&self) -> Result<f64, NoAreaInterval> {
        Ok(self.grid? + self.iteration?)
    }

    /// Half width from grid, iteration and finite sample. The sample is independent of the others,
    /// whose share is a bias: they add as squares.
    pub fn prediction_half_width(&self) -> Option<f64> {
        Some(self.comparison_half_width().ok()?.hypot(self.sample?))
    }

    /// `[low, high]` from grid and iteration.
    ///
    /// # Errors
    /// Why there is none.
    pub fn comparison(&self) -> Result<[f64; 2], NoAreaInterval> {
        Ok(self.around(self.comparison_half_width()?))
    }

    /// `[low, high]` from grid, iteration and finite sample.
    pub fn prediction(&self) -> Option<[f64; 2]> {
        Some(self.around(self.prediction_half_width()?))
    }

    /// A number that was prescribed.
    pub(crate) fn exact(value: f64) -> Self {
        let none = Ok(0.0);
        Self { value, grid: none, iteration: none, sample: Some(0.0), most: f64::INFINITY }
    }

    fn around(&self, half: f64) -> [f64; 2] {
        [(self.value - half).max(0.0), (self.value + half).min(self.most)]
    }
}

/// The numbers of one deterministic solution with their errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Whether the load or the gap was prescribed; what was has no error.
    pub given: Given,
    /// Load over nominal area (Pa); exact if it was given.
    pub mean_pressure: Estimate,
    /// Area fraction, corrected for the contact line (-).
    pub area: Estimate,
    /// Mean gap (m); exact if it was given.
    pub mean_gap: Option<Estimate>,
    /// Contact stiffness, -dp/d(mean gap) (Pa/m), if it was computed.
    pub stiffness: Option<Estimate>,
    /// Relative standard error of the area by blocks, where they can tell.
    pub area_scatter: Option<f64>,
}

impl Budget {
    /// The budget of a solution on the grid of `map`. Without a stiffness, which takes two more
    /// solutions: [`with_stiffness`](Self::with_stiffness).
    pub fn of(solution: &Solution, map: &Map) -> Self {
        let found = &solution.diagnostics;
        let area = found.area_fraction_corrected;
        let iteration = fft_bem_solver::iteration_half_width(found);
        let gate = if found.contact_pixels == 0 {
            Err(NoAreaInterval::Empty)
        } else {
            map.accuracy.grid_half_width(solution)
        };
        let line = grid::line_share(solution);
        // An isolated contact is no sample of a surface that goes on.
        let goes_on = found.boundary == Boundary::Periodic;
        let scatter = goes_on
            .then(|| sample::area_scatter(&solution.pressure, map.grid, sample::PARTS))
            .flatten();
        let relative = scatter.map(|s| sample::area_half_width(s, map.height_scatter));
        let gap = |gap: f64| Estimate {
            value: gap,
            grid: if goes_on {
                gate.map(|_| grid::gap_half_width(map, line))
            } else {
                Err(NoAreaInterval::NotStudied("the gap of an isolated contact"))
            },
            iteration: iteration.map(|_| iteration::gap_half_width(map, found)),
            sample: goes_on.then(|| gap * sample::gap_half_width(map.height_scatter)),
            most: f64::INFINITY,
        };
        Self {
            given: Given::Load,
            mean_pressure: Estimate::exact(solution.state.mean_pressure),
            area: Estimate {
                value: area,
                grid: gate,
                iteration,
                sample: relative.map(|r| r * area),
                most: 1.0,
            },
            mean_gap: solution.state.mean_gap.map(gap),
            stiffness: None,
            area_scatter: scatter,
        }
    }

    /// The same with another half width of the area from the grid, or the reason why there is
    /// none, in units of the area fraction: for a solution on a grid whose bar is not that of
    /// [`AreaAccuracy`]. `more` is by how much the part of the gap from the grid grows (m).
    #[must_use]
    pub fn with_grid(mut self, area: Result<f64, NoAreaInterval>, more: f64) -> Self {
        self.area.grid = area;
        if let Some(gap) = &mut self.mean_gap {
            gap.grid = area.and(gap.grid.map(|half| half + more));
        }
        if let Some(stiffness) = &mut self.stiffness {
            stiffness.grid = area.and(stiffness.grid);
        }
        self
    }

    /// The same with the bar that holds outside the gate as well, from one more solution on a twice
    /// finer Fourier interpolation; the numbers stay those of the given grid.
    #[must_use]
    pub fn refined(mut self, finer: &grid::Finer) -> Self {
        self.area.grid = Ok(finer.area_half_width(self.area.value));
        match self.given {
            Given::Load => {
                if let Some(gap) = &mut self.mean_gap {
                    gap.grid = finer.gap_half_width(gap.value).map_or(gap.grid, Ok);
                }
            }
            Given::Gap => {
                let load = &mut self.mean_pressure;
                load.grid = Ok(finer.pressure_half_width(load.value));
            }
        }
        self
    }

    /// Mean real pressure, load over area, and its intervals; `None` if nothing touches.
    pub fn real_pressure(&self) -> Option<RealPressure<'_>> {
        (self.area.value > 0.0).then_some(RealPressure { budget: self })
    }
}

/// Mean real pressure, load over area: its error is that of the area, turned round.
#[derive(Debug, Clone, Copy)]
pub struct RealPressure<'a> {
    budget: &'a Budget,
}

impl RealPressure<'_> {
    /// The number (Pa).
    pub fn value(self) -> f64 {
        self.budget.mean_pressure.value / self.budget.area.value
    }

    /// `[low, high]` from grid and iteration (Pa); infinite if the area may be 0.
    ///
    /// # Errors
    /// Why there is none.
    pub fn comparison(self) -> Result<[f64; 2], NoAreaInterval> {
        self.budget.area.comparison().map(|area| self.turned(area))
    }

    /// `[low, high]` from grid, iteration and finite sample (Pa).
    pub fn prediction(self) -> Option<[f64; 2]> {
        self.budget.area.prediction().map(|area| self.turned(area))
    }

    fn turned(self, [low, high]: [f64; 2]) -> [f64; 2] {
        [high, low].map(|area| self.budget.mean_pressure.value / area)
    }
}
