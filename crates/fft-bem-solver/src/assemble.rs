//! From a scaled state to the solution in SI units with its diagnostics.

use crate::engine::{Engine, Run};
use crate::problem::Problem;
use crate::{
    BOUNDARY_CORRECTION, Boundary, Diagnostics, Load, Maps, Real, Residuals, Solution, certificate,
    fields,
};
use contact_types::{ContactState, Grid};
use grid_fft::parallel::prelude::*;

impl<T: Real> Engine<T> {
    pub(crate) fn solution(&mut self, problem: &Problem<T>, run: &Run, load: Load) -> Solution {
        let mut transforms = run.outcome.transforms;
        let energy_bound = match run.exact {
            _ if !self.settings.certified => None,
            Some(_) => Some(0.0),
            None => {
                let (operator, state) = self.parts();
                let mut scratch = vec![T::zero(); state.pressure.len()];
                let (u, h, level) = (&state.displacement, &problem.heights, T::of(state.level));
                let gap = |i: usize| u[i] - h[i] - level;
                let error = certificate::energy_error(state, gap, &mut scratch, operator);
                transforms += error.transforms;
                error.relative.is_finite().then_some(error.relative)
            }
        };
        let (units, settings, state) = (problem.units, self.settings, &self.state);
        let (p, u, h, level) =
            (&state.pressure, &state.displacement, &problem.heights, state.level);
        let pressure = |i: usize| p[i].wide() * units.pressure;
        let gap = |i: usize| (u[i].wide() - h[i].wide() - level) * units.height;
        // Under a free boundary nothing fixes the displacement but the load: in contact, what the iteration
        // leaves may be large beside the heights, and is no gap.
        let is_free = settings.boundary == Boundary::Free;
        let counted = |i: usize| if is_free && p[i] > T::zero() { 0.0 } else { gap(i) };
        let (pixels, n) = (p.len(), p.len() as f64);
        let load_sum = fields::sum_of(pixels, pressure);
        let lowest = fields::least_of(pixels, gap);
        let contact_pixels = fields::contact_count(p);
        let contact_perimeter = edges(problem.grid, p, settings.boundary) as f64 / n;
        let area_fraction = contact_pixels as f64 / n;
        let complementarity = fields::sum_of(pixels, |i| pressure(i) * gap(i).abs());
        let work = fields::dot(p, u) / n;
        let highest = fields::largest_of(pixels, |i| u[i].wide().abs());
        let gap_rounding = problem.rounding + T::EPSILON * (highest + 1.0) * units.height;
        let residuals = Residuals {
            preconditioned: run.outcome.residual,
            complementarity: if load_sum > 0.0 {
                complementarity / load_sum / units.height
            } else {
                0.0
            },
            penetration: (-lowest / units.height).max(0.0),
        };
        let duality_gap = fields::sum_of(pixels, |i| pressure(i) * (gap(i) - lowest)) / n;
        let diagnostics = Diagnostics {
            method: settings.method,
            boundary: settings.boundary,
            precision: settings.precision,
            exact: run.exact,
            end: run.outcome.end,
            iterations: run.outcome.iterations,
            transforms,
            fallbacks: run.outcome.fallbacks,
            residuals,
            duality_gap,
            energy_bound,
            height_rounding: problem.rounding,
            gap_rounding,
            seconds: run.clock.elapsed().as_secs_f64(),
            contact_pixels,
            contact_perimeter,
            area_fraction_corrected: (area_fraction - BOUNDARY_CORRECTION * contact_perimeter)
                .max(0.0),
            max_pressure: (fields::max(p) * units.pressure).max(0.0),
            elastic_energy: 0.5 * work * units.pressure * units.height,
        };
        let mean_pressure = match load {
            Load::MeanPressure(p) => p,
            _ => load_sum / n,
        };
        let map = |value: &(dyn Fn(usize) -> f64 + Sync)| fields::filled(pixels, value);
        let (pressure_map, gap_map) = match settings.maps {
            Maps::None => (Vec::new(), Vec::new()),
            Maps::Pressure => (map(&pressure), Vec::new()),
            Maps::PressureAndGap => (map(&pressure), map(&gap)),
        };
        let state = ContactState {
            mean_pressure,
            area_fraction,
            separation: Some(-(problem.mean_height + state.level) * units.height),
            mean_gap: Some(fields::sum_of(pixels, counted) / n),
            caveat: None,
        };
        let approach = self.state.level * units.height;
        let grid = problem.given;
        Solution { grid, state, approach, pressure: pressure_map, gap: gap_map, diagnostics }
    }
}

/// Edges between a pixel in contact and a neighbour (of four) that is not. Across the edge of the
/// map the neighbour is the opposite pixel; with a free boundary there is none, and no edge: the
/// body ends there, so that the contact line cuts no pixel.
fn edges<T: Real>(grid: Grid, pressure: &[T], boundary: Boundary) -> usize {
    let [ny, nx] = grid.shape();
    let on = |p: T| p > T::zero();
    let wraps = boundary == Boundary::Periodic;
    let row = |iy: usize| &pressure[iy * nx..(iy + 1) * nx];
    let mut counts = vec![0_usize; ny];
    counts.par_iter_mut().enumerate().for_each(|(iy, count)| {
        let here = row(iy);
        let inner = here.windows(2).filter(|w| on(w[0]) != on(w[1])).count();
        let across = usize::from(wraps && on(here[0]) != on(here[nx - 1]));
        let below = if iy + 1 < ny || wraps {
            let pairs = here.iter().zip(row((iy + 1) % ny));
            pairs.filter(|(a, b)| on(**a) != on(**b)).count()
        } else {
            0
        };
        *count = inner + across + below;
    });
    counts.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four edges per pixel in contact, less two for every pair of neighbours, and with a free
    /// boundary less those on the edge of the map: counted by hand.
    #[test]
    fn edges_across_the_border_count_as_the_boundary_says() {
        let grid = Grid::new([3, 4], [1.0, 1.0]).unwrap();
        let pressure = [
            1.0, 1.0, 0.0, 0.0, //
            0.0, 0.0, 0.0, 0.0, //
            1.0, 0.0, 0.0, 0.0,
        ];
        assert_eq!(edges(grid, &pressure, Boundary::Periodic), 12 - 4);
        assert_eq!(edges(grid, &pressure, Boundary::Free), 12 - 2 - 5);
    }
}
