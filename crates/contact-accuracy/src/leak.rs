//! The leak through the gap of a solution, with its uncertainty.

use contact_types::{Axis, Clock};
use fft_bem_solver::Solution;
use gap_flow::{Flow, Gap, NotSolved};

/// Fewest open points across the bottleneck for a rate; with less there is a bound only.
const FEWEST_ACROSS: usize = 4;

/// The leak along one axis.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Leak {
    /// The flow.
    pub flow: Flow,
    /// Permeability K on the thinned maps (m³).
    pub coarser: Vec<f64>,
}

impl Leak {
    /// Whether K is more than a bound: four points and more across the bottleneck, and K at least as large as what halving the
    /// points took off it, for a method of first order takes as much again; or no channel on any grid.
    fn is_rate(&self) -> bool {
        match &self.flow.bottleneck {
            None => self.coarser.iter().all(|k| *k <= 0.0),
            Some(bottleneck) => {
                let k = self.flow.permeability;
                bottleneck.width >= FEWEST_ACROSS && self.coarser.iter().all(|c| c - k <= k)
            }
        }
    }

    /// K (m³); `None` where there is a bound only.
    pub fn permeability(&self) -> Option<f64> {
        self.is_rate().then_some(self.flow.permeability)
    }

    /// Whether a channel is `open`, too `narrow` for a rate, or none is: `sealed`.
    pub fn channel(&self) -> &'static str {
        match (&self.flow.bottleneck, self.is_rate()) {
            (None, _) => "sealed",
            (_, true) => "open",
            (_, false) => "narrow",
        }
    }

    /// Relative error of a closed form, where there is a permeability above 0.
    pub fn error_of(&self, closed: f64) -> Option<f64> {
        Some(closed / self.permeability().filter(|k| *k > 0.0)? - 1.0)
    }

    /// `[low, high]` of K (m³): K over and times the largest factor by which it differs on the thinned maps and with
    /// arithmetic faces. Low is 0 where K is a bound. `None` without thinned maps, and where they are sealed as well.
    pub fn interval(&self) -> Option<[f64; 2]> {
        if self.coarser.is_empty() {
            return None;
        }
        let (k, coarser) = (self.flow.permeability, self.coarser.iter().copied());
        if self.flow.bottleneck.is_none() {
            let most = coarser.fold(0.0, f64::max);
            return (most > 0.0).then_some([0.0, most]);
        }
        let faces = self.flow.arithmetic / k;
        let factor = coarser.clone().map(|c| (c / k).max(k / c)).fold(faces, f64::max);
        if self.is_rate() && factor.is_finite() {
            return Some([k / factor, k * factor]);
        }
        let most =
            if factor.is_finite() { factor } else { coarser.map(|c| c / k).fold(faces, f64::max) };
        Some([0.0, k * most])
    }
}

/// The leak of a solution along the axes asked for, and what closed forms make of the same gap.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Leaks {
    /// Along each axis.
    pub along: Vec<(Axis, Result<Leak, NotSolved>)>,
    /// Mean gap ⟨g⟩ (m), contact counted as 0: its cube is the permeability of plates.
    pub mean_gap: f64,
    /// Bruggeman's effective medium (m³).
    pub bruggeman: f64,
    /// Time of the flow, of the mean and of Bruggeman's formula (s).
    pub seconds: [f64; 3],
}

/// Permeability of a solution on a thinned map, that repeats along the flow or does not, along x and y.
pub(crate) fn permeability(solution: &Solution, axes: &[Axis], repeats: bool) -> [Option<f64>; 2] {
    if axes.is_empty() {
        return [None; 2];
    }
    let open = solution.open_gap();
    let gap = Gap::new(solution.grid, &open).repeating([repeats, true]);
    [Axis::X, Axis::Y]
        .map(|axis| axes.contains(&axis).then(|| gap.permeability(axis).ok()).flatten())
}

impl Leaks {
    /// Name, permeability (m³) and time (s) of what closed forms make of the gap.
    pub fn closed_forms(&self) -> [(&'static str, f64, f64); 2] {
        [
            ("mean_gap_cubed", self.mean_gap.powi(3), self.seconds[1]),
            ("bruggeman", self.bruggeman, self.seconds[2]),
        ]
    }

    /// Leaves the maps of the flux.
    pub fn drop_maps(&mut self) {
        self.along
            .iter_mut()
            .flat_map(|(_, leak)| leak)
            .for_each(|leak| leak.flow.flux = Vec::new());
    }

    /// Of a solution with its maps and K on the thinned maps along x and y; whether it repeats along the flow, and across it.
    pub(crate) fn of(
        solution: &Solution,
        axes: &[Axis],
        coarser: &[[Option<f64>; 2]],
        repeats: [bool; 2],
    ) -> Option<Self> {
        if axes.is_empty() {
            return None;
        }
        let open = solution.open_gap();
        let gap = Gap::new(solution.grid, &open).repeating(repeats);
        let clock = Clock::now();
        let leak = |axis: Axis| {
            let coarser = coarser.iter().filter_map(|k| k[axis as usize]).collect();
            gap.flow(axis).map(|flow| Leak { flow, coarser })
        };
        let along = axes.iter().map(|&axis| (axis, leak(axis))).collect();
        let flow = clock.elapsed().as_secs_f64();
        let clock = Clock::now();
        let mean_gap = gap.mean();
        let mean = clock.elapsed().as_secs_f64();
        let clock = Clock::now();
        let bruggeman = gap.bruggeman();
        let seconds = [flow, mean, clock.elapsed().as_secs_f64()];
        Some(Self { along, mean_gap, bruggeman, seconds })
    }
}
