//! The numbers of one solution, each with its errors by source.

use super::area::iteration_half_width;
use super::bend::Bend;
use super::between::Between;
use super::fall::fall_over_gap;
use super::floor::Floor;
use super::map::Map;
use super::no_interval::NoAreaInterval;
use super::{grid, iteration, sample};
use fft_bem_solver::{Boundary, Solution};

/// What was prescribed, so that it has no error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Given {
    /// The mean pressure.
    Load,
    /// The mean gap.
    Gap,
}

/// A number with what is known about its error: half widths in its own unit, by source.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Left by the grid, or why that is not known.
    pub grid: Result<f64, NoAreaInterval>,
    /// Left by stopping the iteration, or why that is not known.
    pub iteration: Result<f64, NoAreaInterval>,
    /// Scatter over maps of the same surface, 95 %; `None` if this map cannot tell.
    pub sample: Option<f64>,
    /// Smallest value that it can have: 0, or what the load asks for at least.
    pub(super) least: f64,
    /// Largest value that has a meaning.
    pub(super) most: f64,
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
    pub(super) fn exact(value: f64) -> Self {
        let none = Ok(0.0);
        Self {
            value,
            grid: none,
            iteration: none,
            sample: Some(0.0),
            least: 0.0,
            most: f64::INFINITY,
        }
    }

    fn around(&self, half: f64) -> [f64; 2] {
        // Rounding may leave a number just below the least, where no end may follow.
        let low = (self.value - half).max(self.least).min(self.most);
        [low, (self.value + half).min(self.most).max(low)]
    }
}

/// The numbers of one deterministic solution with their errors.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
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
    /// What the solution says of other maps of the surface, where it can tell.
    pub sampled: Option<sample::Sampled>,
    /// Whether part of the contact has yielded: its bars from the grid are wider ([`grid::YIELDING`]), and
    /// nothing is known of other maps of the surface.
    pub yields: bool,
    /// Half width of the area that ways to interpolate leave, where that is known and small.
    pub between: f64,
    /// Whether what lies between the points decides the answer, whatever else leaves it without a bar of its own.
    pub doubted: bool,
    /// How sharply the heights bend where something touches, where that is known.
    pub bend: Option<Bend>,
    /// Half width of the area that slits in creased valleys leave, which a finer grid does not show either.
    pub slits: f64,
    /// What the load asks for at least, where the contact yields.
    pub floor: Option<Floor>,
    /// Why the grid of this solution has no bar of its own, if it has none; one from a finer grid
    /// may stand with the numbers all the same.
    pub own: Result<(), NoAreaInterval>,
}

impl Budget {
    /// The budget of a solution on the grid of `map`. Without a stiffness, which takes two more
    /// solutions: [`with_stiffness`](Self::with_stiffness).
    pub fn of(solution: &Solution, map: &Map) -> Self {
        let found = &solution.diagnostics;
        let area = found.area_fraction_corrected;
        let iteration = iteration_half_width(found);
        let goes_on = found.boundary == Boundary::Periodic;
        let yields = found.yielded.is_some_and(|y| y.area_fraction > 0.0);
        let [wide, wide_gap, _] = if yields { grid::YIELDING } else { [1.0; 3] };
        let line = grid::Line::of(solution);
        let gate = if found.contact_pixels == 0 {
            Err(NoAreaInterval::Empty)
        } else if yields && !goes_on {
            Err(NoAreaInterval::NotStudied("an isolated contact that has yielded"))
        } else if yields && map.is_regular() {
            Err(NoAreaInterval::NotStudied("a pattern of like cells that has yielded"))
        } else {
            let seam = if goes_on { grid::area_of_seam(map, line) } else { 0.0 };
            map.accuracy.grid_half_width(solution).map(|half| wide * half.hypot(seam))
        };
        let floor = Floor::of(solution);
        // An isolated contact is no sample of a surface that goes on; how those of one that yields scatter
        // was not studied.
        let blocks = (goes_on && !yields)
            .then(|| sample::blocks(&solution.pressure, map.accuracy.grid(), sample::PARTS))
            .flatten();
        let sampled = blocks.map(|blocks| sample::Sampled {
            blocks,
            area,
            fall: fall_over_gap(solution),
            height: map.height_scatter,
            gradient: map.gradient_scatter,
            gap: sample::gap_scatter(solution),
            highest: solution
                .state
                .mean_gap
                .map_or(0.0, |gap| if gap > 0.0 { map.highest / gap } else { 0.0 }),
            repeats: map.repeats,
        });
        let [few, _] = few_spots(sampled.as_ref());
        let relative = sampled.map(|s| s.area_half_width());
        let gap = |gap: f64| Estimate {
            value: gap.max(0.0), // rounding may leave it just below at full contact
            grid: if goes_on {
                gate.map(|_| {
                    let open = grid::gap_of_open_places(map, line, gap);
                    let seam = grid::gap_of_seam(map, line);
                    wide_gap * (few * grid::gap_half_width(map, line)).max(open).max(seam)
                })
            } else {
                Err(NoAreaInterval::NotStudied("the gap of an isolated contact"))
            },
            iteration: iteration.map(|_| iteration::gap_half_width(map, found)),
            sample: sampled.map(|s| gap.max(0.0) * s.gap_half_width()),
            least: 0.0,
            most: f64::INFINITY,
        };
        Self {
            given: Given::Load,
            mean_pressure: Estimate::exact(solution.state.mean_pressure),
            area: Estimate {
                value: area,
                grid: floor.map_or(gate, |floor| floor.bar(gate)),
                iteration,
                sample: relative.map(|r| r * area),
                least: floor.map_or(0.0, |floor| floor.area),
                most: 1.0,
            },
            mean_gap: solution.state.mean_gap.map(gap),
            stiffness: None,
            yields,
            sampled,
            between: 0.0,
            doubted: false,
            bend: None,
            slits: 0.0,
            floor,
            own: gate.map(|_| ()),
        }
    }

    /// The same where it is known how much the interpolants of the map differ at the contact: no bar
    /// of the grid where that is too much.
    #[must_use]
    pub fn between(mut self, found: &Between) -> Self {
        self.bend = Some(found.bend);
        self.slits = grid::area_of_slits(found);
        if found.is_small() {
            let [few, _] = self.few_spots();
            if let Some(gap) = &mut self.mean_gap {
                let between = grid::gap_between(found).max(few * grid::gap_of_peaks(&found.bend));
                gap.grid = gap.grid.map(|half| half.max(between));
            }
            self.between = grid::area_between(found, self.area.value);
            self.area.grid = self.area.grid.map(|half| half.hypot(self.between));
            self.area.grid = self.floor.map_or(self.area.grid, |floor| floor.bar(self.area.grid));
            return self;
        }
        self.doubted = true;
        let none = NoAreaInterval::BetweenPoints { doubt: found.doubt() };
        self.own = self.own.and(Err(none));
        let of = |estimate: &mut Estimate| estimate.grid = estimate.grid.and(Err(none));
        of(&mut self.area);
        self.area.grid = self.floor.map_or(self.area.grid, |floor| floor.bar(self.area.grid));
        self.mean_gap.iter_mut().for_each(of);
        self.stiffness.iter_mut().for_each(of);
        self
    }

    /// The same with another half width of the area from the grid, or the reason why there is
    /// none, in units of the area fraction: for a solution on a grid whose bar is not that of
    /// [`AreaAccuracy`](super::AreaAccuracy). `more` is by how much the part of the gap from the grid grows (m).
    #[must_use]
    pub fn with_grid(mut self, area: Result<f64, NoAreaInterval>, more: f64) -> Self {
        self.area.grid = area;
        self.floor = None;
        self.own = area.map(|_| ());
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
        // A bar of its own, on a map of like cells, stays if it is wider.
        let wider = |own: &mut Result<f64, NoAreaInterval>, half: Option<f64>| {
            if let Some(half) = half {
                *own = Ok(own.map_or(half, |own| own.max(half)));
            }
        };
        let half = finer.area_half_width(self.area.value).hypot(self.slits);
        wider(&mut self.area.grid, Some(half));
        if let Some(stiffness) = &mut self.stiffness {
            let slits = self.slits / (1.0 - self.area.value).max(f64::MIN_POSITIVE);
            let half = finer.stiffness_half_width(stiffness.value);
            wider(&mut stiffness.grid, half.map(|half| half.hypot(slits * stiffness.value)));
        }
        match self.given {
            Given::Load => {
                if let Some(gap) = &mut self.mean_gap {
                    wider(&mut gap.grid, finer.gap_half_width(gap.value));
                }
            }
            Given::Gap => {
                let load = &mut self.mean_pressure;
                wider(&mut load.grid, Some(finer.pressure_half_width(load.value)));
            }
        }
        self
    }

    /// By how much the bars of gap and stiffness widen where few spots carry the load.
    pub(crate) fn few_spots(&self) -> [f64; 2] {
        few_spots(self.sampled.as_ref())
    }

    /// The least area, where it is its distance that makes the bar from the grid.
    pub fn held_by_floor(&self) -> Option<Floor> {
        self.floor.filter(|floor| self.area.grid == Ok(floor.above))
    }

    /// Mean real pressure, load over area, and its intervals; `None` if nothing touches.
    pub fn real_pressure(&self) -> Option<RealPressure<'_>> {
        (self.area.value > 0.0).then_some(RealPressure { budget: self })
    }
}

fn few_spots(sampled: Option<&sample::Sampled>) -> [f64; 2] {
    sampled.map_or([1.0; 2], |s| grid::of_few_spots(s.blocks.carrying))
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
