//! The numbers of one deterministic solution with their uncertainties.

use crate::coarser::Numbers;
use crate::estimate::{Estimate, NoUncertainty};
use crate::sampling::{height_scatter, sampling};
use crate::uncertainty::{Beside, Uncertain};
use contact_types::HeightMap;
use fft_bem_solver::{Boundary, End, Load, SetStiffness, Solution};

/// What a map says of the answers on it before anything is solved. Made once per surface, in two passes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Map {
    /// Whether opposite edges match.
    pub repeats: bool,
    /// Rms height (m).
    pub rms_height: f64,
    /// Relative standard error of the rms height over maps of the same surface.
    pub height_scatter: f64,
    /// How many times it shows the same cell: where contact ends, all round alike.
    pub copies: usize,
}

impl Map {
    /// Of a surface as it is solved.
    pub fn of(surface: &HeightMap) -> Self {
        let (rms_height, height_scatter) = height_scatter(surface);
        let repeats = surface_stats::repeats(surface);
        Self { repeats, rms_height, height_scatter, copies: copies(surface, 1e-6 * rms_height) }
    }
}

/// How many times a map shows the same cell, to `tolerance` (m); of ridges along the points each row or column is one.
fn copies(surface: &HeightMap, tolerance: f64) -> usize {
    let ([ny, nx], heights) = (surface.grid().shape(), surface.heights());
    let along = |n: usize, moved: &dyn Fn(usize, usize) -> usize| {
        let same = |p: usize, i: usize| (heights[i] - heights[moved(i, p)]).abs() <= tolerance;
        let is_period = |p: &usize| n % p == 0 && (0..heights.len()).all(|i| same(*p, i));
        (1..n).find(is_period).map_or(1, |period| n / period)
    };
    let rows = along(ny, &|i, p| (i + p * nx) % heights.len());
    rows * along(nx, &|i, p| i / nx * nx + (i + p) % nx)
}

/// The numbers of one solution with their uncertainties.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Budget {
    /// Whether the mean gap was prescribed, and not the load: what was prescribed has no uncertainty.
    pub gap_is_given: bool,
    /// Load over nominal area (Pa).
    pub mean_pressure: Estimate,
    /// Area fraction, with the perimeter correction (-). Where the contact yields it is at least load over
    /// hardness.
    pub area: Estimate,
    /// Mean gap (m).
    pub mean_gap: Option<Estimate>,
    /// Stiffness of the contact set (Pa/m), if it was asked for and there is one. Of elastic contact that is −dp/d(mean gap).
    pub stiffness: Option<Estimate>,
    /// Conductance over conductivity of a gas in the gap (1/m), if that was asked for.
    pub gas: Option<Estimate>,
    /// Interpolation-sensitivity indicator (-), if it was looked at.
    pub indicator: Option<f64>,
}

impl Budget {
    /// Of a solution for `given`, the set that was asked for its stiffness and a gas of this temperature jump (m), on a
    /// map of which `map` tells.
    pub(crate) fn of(
        given: Load,
        solution: &Solution,
        (set, jump): (Option<&SetStiffness>, Option<f64>),
        map: &Map,
        beside: Beside<'_>,
    ) -> Self {
        let uncertain = &Uncertain::of(solution, map, beside);
        let found = &solution.diagnostics;
        let load = solution.state.mean_pressure;
        let own = Numbers::of(solution, set, jump);
        // No pressure exceeds the hardness: on any grid the area is at least P/H.
        let least = found.yielded.map_or(0.0, |yielded| (load / yielded.hardness).min(1.0));
        let mut area = uncertain.area(own.area, least);
        if found.contact_pixels == 0 {
            area.uncertainty = Err(NoUncertainty::NoContact);
        }
        let mut mean_gap = own.mean_gap.map(|gap| uncertain.gap(gap, &area));
        let mut gas = own.gas.map(|gas| uncertain.gas(gas, mean_gap.as_ref(), &area));
        let residual = set.map_or(0.0, |set| set.residual);
        let mut stiffness = own.stiffness.map(|k| uncertain.stiffness(k, residual, &area));
        // An isolated contact is no sample of a surface that goes on; of one that yields it was not studied.
        let yields = found.yielded.is_some_and(|yielded| yielded.area_fraction > 0.0);
        let goes_on = found.boundary == Boundary::Periodic && !yields;
        if let Some([of_area, of_gap, of_stiffness]) =
            goes_on.then(|| sampling(solution, map.height_scatter)).flatten()
        {
            area.sampling = Some(of_area * area.value);
            // Where the gap is wide beside the temperature jumps the gas scatters as it does, elsewhere less.
            let others =
                [(&mut mean_gap, of_gap), (&mut gas, of_gap), (&mut stiffness, of_stiffness)];
            for (number, relative) in others {
                if let Some(number) = number {
                    number.sampling = Some(relative * number.value);
                }
            }
        }
        let mean_pressure = Estimate::exact(load);
        let (gap_is_given, indicator) = (false, None);
        Self { gap_is_given, mean_pressure, area, mean_gap, stiffness, gas, indicator }
            .under(given, solution, uncertain)
    }

    /// The same where `load` prescribed a gap: the gap is exact, the pressure is not.
    fn under(mut self, load: Load, solution: &Solution, uncertain: &Uncertain<'_>) -> Self {
        let (Load::MeanGap(_), Some(gap)) = (load, self.mean_gap) else { return self };
        let mut pressure = uncertain.pressure(self.mean_pressure.value, &self.area);
        // By one sampling variability of the gap the load moves by as much as the gap falls per e-fold load: at
        // least by the elastic energy over the load, while most is out of contact.
        let fall = solution.diagnostics.elastic_energy / self.mean_pressure.value;
        pressure.sampling = gap
            .sampling
            .filter(|_| fall > 0.0)
            .map(|half| pressure.value * (half / fall).min(5.0).exp_m1());
        self.area.sampling = match (self.area.sampling, pressure.sampling) {
            (Some(half), Some(load)) if pressure.value > 0.0 => {
                Some(half.hypot(self.area.value * load / pressure.value))
            }
            _ => None,
        };
        self.area.least = [0.0; 2]; // it moves with the load
        self.mean_pressure = pressure;
        self.mean_gap = Some(Estimate::exact(gap.value));
        self.gap_is_given = true;
        self
    }

    /// The same where the contact modulus and the hardness are known to these relative half widths only. Elastic
    /// contact goes as 1/E\*, yielded contact as 1/H: each by its share of area and load.
    #[must_use]
    pub(crate) fn with_materials(
        mut self,
        [modulus, hardness]: [f64; 2],
        solution: &Solution,
    ) -> Self {
        let touching = solution.touching_fraction();
        let yielded = solution.diagnostics.yielded.filter(|_| touching > 0.0);
        let [load, area] =
            yielded.map_or([0.0; 2], |y| [y.load_share, (y.area_fraction / touching).min(1.0)]);
        self.area.materials = self.area.value * ((1.0 - area) * modulus).hypot(load * hardness);
        self.area.least[1] = self.area.least[0] * (-hardness).exp();
        self
    }

    /// Of an iterate that missed its tolerance: the numbers, and why they have no uncertainty.
    pub fn of_iterate(solution: &Solution, map: &Map) -> Self {
        let at_rounding = solution.diagnostics.end == End::Rounding;
        let why = NoUncertainty::NotConverged { at_rounding };
        let beside = Beside { coarser: Err(why), finer: None };
        let load = Load::MeanPressure(solution.state.mean_pressure);
        Self::of(load, solution, (None, None), map, beside)
    }

    /// Mean real pressure, load over area (Pa): its intervals are those of the area, inverted. `None` if nothing touches.
    pub fn real_pressure(&self) -> Option<RealPressure> {
        let load = self.mean_pressure.value;
        let inverted = |[low, high]: [f64; 2]| [high, low].map(|area| load / area);
        (self.area.value > 0.0).then(|| RealPressure {
            value: load / self.area.value,
            interval: self.area.interval().ok().map(inverted),
            prediction: self.area.prediction().map(inverted),
        })
    }
}

/// Mean real pressure, load over area (Pa).
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct RealPressure {
    /// The number.
    pub value: f64,
    /// `[low, high]` as the number of this map, if it has an uncertainty; infinite if the area may be 0.
    pub interval: Option<[f64; 2]>,
    /// `[low, high]` as a number of the surface, if the map can tell.
    pub prediction: Option<[f64; 2]>,
}
