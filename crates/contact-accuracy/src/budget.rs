//! The numbers of one deterministic solution with their uncertainties.

use crate::coarser::Numbers;
use crate::estimate::{Estimate, Inverse, NoUncertainty};
use crate::sampling::{Map, sampling};
use crate::uncertainty::{Beside, Uncertain};
use fft_bem_solver::{Boundary, End, Load, SetStiffness, Solution};

/// The numbers of one solution with their uncertainties.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Budget {
    /// Load over nominal area (Pa).
    pub mean_pressure: Estimate,
    /// Area fraction, with the perimeter correction (-). Where the contact yields it is at least load over
    /// hardness.
    pub area: Estimate,
    /// Mean gap (m).
    pub mean_gap: Option<Estimate>,
    /// Stiffness of the contact set (Pa/m), if it was asked for and there is one. Of elastic contact that is dp over the approach.
    pub stiffness: Option<Estimate>,
    /// Conductance over conductivity of a gas in the gap (1/m), if that was asked for.
    pub gas: Option<Estimate>,
    /// Interpolation-sensitivity indicator (-), if it was looked at.
    pub indicator: Option<f64>,
}

/// The change of an area (-) per relative change of the load, slope or modulus, at most: by Persson's erf it is less than
/// this at every area, the area itself where little touches and nothing where all does.
fn answering(area: f64) -> f64 {
    area * (1.0 - area * area).max(0.0).sqrt()
}

/// Shares of load and touching area at the hardness.
fn at_hardness(solution: &Solution) -> [f64; 2] {
    let touching = solution.touching_fraction();
    let yielded = solution.diagnostics.yielded.filter(|_| touching > 0.0);
    yielded.map_or([0.0; 2], |y| [y.load_share, (y.area_fraction / touching).min(1.0)])
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
        // What the contact line cuts of the points in contact is open, and closed to the gas.
        let cut = jump.map_or(0.0, |jump| (solution.touching_fraction() - own.area) / jump);
        let mut gas = own.gas.map(|gas| uncertain.gas(gas, mean_gap.as_ref(), (&area, cut)));
        let residual = set.map_or(0.0, |set| set.residual);
        let mut stiffness = own.stiffness.map(|k| uncertain.stiffness(k, residual, &area));
        // An isolated contact is no sample of a surface that goes on.
        let goes_on = found.boundary == Boundary::Periodic;
        if let Some([of_area, of_gap, of_stiffness]) =
            goes_on.then(|| sampling(solution, map.height_scatter)).flatten()
        {
            // The part at the hardness is left out: most of it is its load over that on every map.
            let [_, yielded] = at_hardness(solution);
            area.sampling = Some(of_area * answering(area.value) * (1.0 - yielded));
            // Where the gap is wide beside the temperature jumps the gas scatters as it does, elsewhere less.
            let others =
                [(&mut mean_gap, of_gap), (&mut gas, of_gap), (&mut stiffness, of_stiffness)];
            for (number, relative) in others {
                if let Some(number) = number {
                    number.sampling = Some(relative * number.value);
                }
            }
        }
        let most = found.yielded.map_or(f64::INFINITY, |yielded| yielded.hardness);
        let mean_pressure = Estimate { most, ..Estimate::exact(load) };
        Self { mean_pressure, area, mean_gap, stiffness, gas, indicator: None }
            .under(given, solution, uncertain)
    }

    /// The same where `load` prescribed a gap: the gap is exact, the pressure is not.
    fn under(mut self, load: Load, solution: &Solution, uncertain: &Uncertain<'_>) -> Self {
        let (Load::MeanGap(_), Some(gap)) = (load, self.mean_gap) else { return self };
        let pressure = uncertain.pressure(self.mean_pressure.value, &self.area);
        let mut pressure = Estimate { most: self.mean_pressure.most, ..pressure };
        // By one sampling variability of the gap the load moves by as much as the gap falls per e-fold load: at
        // least by the elastic energy over the load, while most is out of contact.
        let fall = solution.diagnostics.elastic_energy / self.mean_pressure.value;
        pressure.sampling = gap
            .sampling
            .filter(|_| fall > 0.0)
            .map(|half| pressure.value * (half / fall).min(5.0).exp_m1());
        self.area.sampling = match (self.area.sampling, pressure.sampling) {
            (Some(half), Some(load)) if pressure.value > 0.0 => {
                Some(half.hypot(answering(self.area.value) * load / pressure.value))
            }
            _ => None,
        };
        self.area.least = [0.0; 2]; // it moves with the load
        self.mean_pressure = pressure;
        self.mean_gap = Some(Estimate::exact(gap.value));
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
        let [load, area] = at_hardness(solution);
        let of_modulus = (1.0 - area) * modulus * answering(self.area.value);
        self.area.materials = of_modulus.hypot(load * hardness * self.area.value);
        self.area.least[1] = self.area.least[0] * (-hardness).exp();
        self.mean_pressure.most *= hardness.exp();
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

    /// Mean real pressure, load over area (Pa), at most the hardness: how far the ends of load and area move it adds in
    /// squares. `None` if nothing touches.
    pub fn real_pressure(&self) -> Option<Inverse> {
        let Self { mean_pressure: load, area, .. } = self;
        let value = load.value / area.value;
        let within = |([low, high], [least, most]): ([f64; 2], [f64; 2])| {
            let below = (value - load.value / most).hypot((load.value - low) / area.value);
            let above = (load.value / least - value).hypot((high - load.value) / area.value);
            [(value - below).max(0.0), (value + above).min(load.most)]
        };
        (area.value > 0.0).then(|| Inverse {
            value,
            interval: load.interval().ok().zip(area.interval().ok()).map(within),
            prediction: load.prediction().zip(area.prediction()).map(within),
        })
    }
}
