//! From a scaled state to the solution in SI units with its diagnostics.

use crate::engine::{Engine, Run};
use crate::methods::{Top, under};
use crate::problem::Problem;
use crate::{
    BOUNDARY_CORRECTION, Boundary, Diagnostics, Load, Maps, Real, Residuals, Solution, Yielded,
    certificate, fields, solution::coarse,
};
use contact_types::{ContactState, Grid};
use grid_fft::parallel::prelude::*;

impl<T: Real> Engine<T> {
    pub(crate) fn solution(&mut self, problem: &Problem<T>, run: &Run, load: Load) -> Solution {
        let mut transforms = run.outcome.transforms;
        let ceilings = self.ceilings();
        let ceiling = self.top(problem, &ceilings);
        let hardness_map = self.hardness_map.clone();
        let energy_bound = match run.exact {
            _ if !self.settings.certified => None,
            Some(_) => Some(0.0),
            None => {
                let (operator, state) = self.parts();
                let mut scratch = vec![T::zero(); state.pressure.len()];
                let (u, h, level) = (&state.displacement, &problem.heights, T::of(state.level));
                let gap = |i: usize| u[i] - h[i] - level;
                let error = under!(ceiling, top => {
                    certificate::energy_error(top, state, gap, &mut scratch, operator)
                });
                transforms += error.transforms;
                error.relative.is_finite().then_some(error.relative)
            }
        };
        let (units, settings, state) = (problem.units, self.settings, &self.state);
        let (p, u, h, level) =
            (&state.pressure, &state.displacement, &problem.heights, state.level);
        let is_full = |i: usize| p[i] >= ceiling.at(i);
        let hardness = |i: usize| hardness_map.as_ref().map_or(settings.hardness, |map| map[i]);
        // To the last digit, whatever the units of the iteration are.
        let pressure =
            |i: usize| if is_full(i) { hardness(i) } else { p[i].wide() * units.pressure };
        let gap = |i: usize| (u[i].wide() - h[i].wide() - level) * units.height;
        // Under a free boundary nothing fixes the displacement but the load: in contact, what the iteration
        // leaves may be large beside the heights, and is no gap.
        let is_free = settings.boundary == Boundary::Free;
        // At the ceiling an overlap is what was flattened: no gap.
        let closed = |i: usize| (is_free && p[i] > T::zero()) || is_full(i);
        let counted = |i: usize| if closed(i) { 0.0 } else { gap(i) };
        let (pixels, n) = (p.len(), p.len() as f64);
        let load_sum = fields::sum_of(pixels, pressure);
        let lowest = fields::least_of(pixels, |i| if is_full(i) { 0.0 } else { gap(i) });
        let contact_pixels = fields::contact_count(p);
        let [perimeter, sharp] = edges(problem.grid, p, ceiling, settings.boundary);
        let (contact_perimeter, cut) = (perimeter as f64 / n, (perimeter - sharp) as f64 / n);
        let yielded = ceiling.is_finite().then(|| {
            let full = fields::sum_of(pixels, |i| if is_full(i) { 1.0 } else { 0.0 });
            let borne = fields::sum_of(pixels, |i| if is_full(i) { hardness(i) } else { 0.0 });
            let depth = |i: usize| if is_full(i) { (-gap(i)).max(0.0) } else { 0.0 };
            Yielded {
                hardness: settings.hardness,
                area_fraction: full / n,
                load_share: if load_sum > 0.0 { borne / load_sum } else { 0.0 },
                mean_flattening: fields::sum_of(pixels, depth) / n,
            }
        });
        let area_fraction = contact_pixels as f64 / n;
        // No pressure exceeds the hardness: whatever the line, it takes this area to carry the load.
        let hardest = hardness_map
            .as_ref()
            .map_or(settings.hardness, |map| map.iter().copied().fold(0.0, f64::max));
        let least = (load_sum / n / hardest).min(area_fraction);
        let off = |i: usize| if is_full(i) { gap(i).max(0.0) } else { gap(i).abs() };
        let complementarity = fields::sum_of(pixels, |i| pressure(i) * off(i));
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
        let duality_gap = if ceiling.is_finite() {
            let room = |i: usize| hardness(i) - pressure(i);
            let term = |i: usize| pressure(i) * gap(i).max(0.0) + room(i) * (-gap(i)).max(0.0);
            fields::sum_of(pixels, term) / n
        } else {
            fields::sum_of(pixels, |i| pressure(i) * (gap(i) - lowest)) / n
        };
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
            area_fraction_corrected: (area_fraction - BOUNDARY_CORRECTION * cut).max(least),
            yielded,
            max_pressure: (fields::max(p) * units.pressure).max(0.0).min(hardest),
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
            // Near full contact what is left of the residual may outweigh the gap; bodies do not overlap.
            mean_gap: Some((fields::sum_of(pixels, counted) / n).max(0.0)),
            caveat: None,
        };
        let approach = self.state.level * units.height;
        let grid = problem.given;
        let coarse_gap = means(grid, |i| if p[i] > T::zero() { 0.0 } else { gap(i).max(0.0) });
        let (pressure, gap) = (pressure_map, gap_map);
        Solution { grid, state, approach, pressure, gap, coarse_gap, diagnostics }
    }
}

/// Means over the blocks of the [coarse grid](Solution::coarse_grid).
fn means(grid: Grid, value: impl Fn(usize) -> f64 + Sync) -> Vec<f64> {
    let ([ny, nx], [by, bx]) = (grid.shape(), coarse(grid).shape());
    let pixels = |block: usize, blocks: usize, n: usize| {
        (block * n).div_ceil(blocks)..((block + 1) * n).div_ceil(blocks)
    };
    let mut means = vec![0.0; by * bx];
    means.par_iter_mut().enumerate().for_each(|(block, mean)| {
        let (rows, columns) = (pixels(block / bx, by, ny), pixels(block % bx, bx, nx));
        let count = rows.len() * columns.len();
        let row = |iy: usize| columns.clone().map(|ix| value(iy * nx + ix)).sum::<f64>();
        *mean = rows.map(row).sum::<f64>() / count as f64;
    });
    means
}

/// Edges between a pixel in contact and a neighbour (of four) that is not. Across the edge of the
/// map the neighbour is the opposite pixel; with a free boundary there is none, and no edge: the
/// body ends there, so that the contact line cuts no pixel. And of these, the edges of pixels at the
/// ceiling: the pressure drops from there at once, whatever the pixel.
fn edges<T: Real>(
    grid: Grid,
    pressure: &[T],
    ceiling: Top<'_, T>,
    boundary: Boundary,
) -> [usize; 2] {
    let [ny, nx] = grid.shape();
    let is_full = |i: usize| pressure[i] >= ceiling.at(i);
    let edge = |a: usize, b: usize| {
        let is_edge = (pressure[a] > T::zero()) != (pressure[b] > T::zero());
        [usize::from(is_edge), usize::from(is_edge && (is_full(a) || is_full(b)))]
    };
    let wraps = boundary == Boundary::Periodic;
    let mut counts = vec![[0_usize; 2]; ny];
    counts.par_iter_mut().enumerate().for_each(|(iy, count)| {
        let first = iy * nx;
        let mut add = |[all, sharp]: [usize; 2]| *count = [count[0] + all, count[1] + sharp];
        (first + 1..first + nx).for_each(|i| add(edge(i - 1, i)));
        if wraps {
            add(edge(first, first + nx - 1));
        }
        if iy + 1 < ny || wraps {
            let below = (iy + 1) % ny * nx;
            (0..nx).for_each(|ix| add(edge(first + ix, below + ix)));
        }
    });
    counts.iter().fold([0; 2], |[a, b], [x, y]| [a + x, b + y])
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
        let none = Top::NONE;
        assert_eq!(edges(grid, &pressure, none, Boundary::Periodic), [12 - 4, 0]);
        assert_eq!(edges(grid, &pressure, none, Boundary::Free), [12 - 2 - 5, 0]);
        assert_eq!(edges(grid, &pressure, Top::Same(1.0), Boundary::Periodic), [12 - 4; 2]);
    }
}
