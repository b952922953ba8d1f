//! From a scaled state to the solution in SI units with its diagnostics.

use crate::engine::Engine;
use crate::methods::{Outcome, under};
use crate::problem::Problem;
use crate::simd::vectorised;
use crate::tally::tally;
use crate::{
    Boundary, Diagnostics, Load, Maps, PERIMETER_CORRECTION, Real, Residuals, Solution, Yielded,
    certificate, fields,
};
use contact_types::{Clock, ContactState, Grid};
use grid_fft::parallel::prelude::*;

/// Most blocks along a side of [`Solution::coarse_gap`].
const BLOCKS: usize = 32;

impl<T: Real> Engine<T> {
    pub(crate) fn solution(
        &mut self,
        problem: &Problem<T>,
        run: &Outcome,
        load: Load,
        clock: Clock,
    ) -> Solution {
        let mut transforms = run.transforms;
        let ceiling = self.ceiling(problem);
        let energy_bound = match run.exact {
            _ if !self.settings.certified => None,
            Some(_) => Some(0.0),
            None => {
                let (operator, state) = (&mut self.operator, &self.state);
                let mut scratch = vec![T::zero(); state.pressure.len()];
                let (u, h, level) = (&state.displacement, &problem.heights, T::of(state.level));
                let gap = |i: usize| u[i] - h[i] - level;
                let error = under!(ceiling, top => {
                    certificate::energy_error(top, state, gap, &mut scratch, operator)
                });
                transforms += error.map_or(0.0, |_| 1.0);
                error.filter(|error| error.is_finite())
            }
        };
        let (units, settings, state) = (problem.units, &self.settings, &self.state);
        let (p, u, h, level) =
            (&state.pressure, &state.displacement, &problem.heights, state.level);
        let (top, hardness) = (T::of(ceiling), settings.hardness);
        // To the last digit, whatever the units of the iteration are.
        let pressure = |i: usize| if p[i] >= top { hardness } else { p[i].wide() * units.pressure };
        let gap = |i: usize| (u[i].wide() - h[i].wide() - level) * units.height;
        let (pixels, n) = (p.len(), p.len() as f64);
        let grid = problem.given;
        let blocks = grid.shape().map(|n| n.min(BLOCKS));
        let mut coarse_gap = vec![0.0; blocks[0] * blocks[1]];
        let (shape, boundary) = (grid.shape(), settings.boundary);
        let (sums, [lowest, largest]) = under!(ceiling, top => {
            tally(top, [p, u, h], level, boundary, shape, blocks, &mut coarse_gap)
        });
        let [below, contact, full, work, complementarity, duality, open] = sums;
        for gap in &mut coarse_gap {
            *gap *= units.height;
        }
        let coarse_gap = (blocks, coarse_gap);
        let borne = if full > 0.0 { full * hardness } else { 0.0 };
        let load_sum = below * units.pressure + borne;
        let [perimeter, sharp] = edges(problem.grid, p, ceiling, settings.boundary);
        let (contact_perimeter, cut) = (perimeter as f64 / n, (perimeter - sharp) as f64 / n);
        let yielded = ceiling.is_finite().then(|| Yielded {
            hardness,
            area_fraction: full / n,
            load_share: if load_sum > 0.0 { borne / load_sum } else { 0.0 },
        });
        let touching = contact / n;
        // No pressure exceeds the hardness: whatever the line, it takes this area to carry the load.
        let least = (load_sum / n / hardness).min(touching);
        let residuals = Residuals {
            preconditioned: run.residual,
            complementarity: if load_sum > 0.0 {
                complementarity * units.pressure / load_sum
            } else {
                0.0
            },
            penetration: (-lowest).max(0.0),
        };
        // Without a ceiling the gap counts from its lowest point; rounding may leave less than nothing.
        let from_lowest = (duality - lowest * below).max(0.0);
        let duality = if ceiling.is_finite() { duality } else { from_lowest };
        let duality_gap = duality * units.pressure * units.height / n;
        let diagnostics = Diagnostics {
            method: settings.method,
            boundary: settings.boundary,
            precision: settings.precision,
            exact: run.exact,
            end: run.end,
            iterations: run.iterations,
            transforms,
            residuals,
            duality_gap,
            energy_bound,
            seconds: clock.elapsed().as_secs_f64(),
            contact_pixels: contact as usize,
            contact_perimeter,
            yielded,
            max_pressure: (largest * units.pressure).max(0.0).min(hardness),
            elastic_energy: 0.5 * (work / n) * units.pressure * units.height,
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
            area_fraction: (touching - PERIMETER_CORRECTION * cut).max(least),
            separation: Some(-(problem.mean_height + state.level) * units.height),
            // Near full contact what is left of the residual may outweigh the gap; bodies do not overlap.
            mean_gap: Some(if touching < 1.0 { (open * units.height / n).max(0.0) } else { 0.0 }),
            caveat: None,
        };
        let approach = self.state.level * units.height;
        let (pressure, gap) = (pressure_map, gap_map);
        Solution { grid, state, approach, pressure, gap, coarse_gap, diagnostics }
    }
}

/// Edges between a pixel in contact and a neighbour (of four) that is not, across the edge of the map only if that
/// repeats; and of these, the edges of pixels at the ceiling, where the pressure drops at once, whatever the pixel.
fn edges<T: Real>(grid: Grid, pressure: &[T], ceiling: f64, boundary: Boundary) -> [usize; 2] {
    let [ny, nx] = grid.shape();
    let is_on = |p: &T| *p > T::zero();
    let top = T::of(ceiling);
    let is_full = |i: usize| pressure[i] >= top;
    let is_edge = |i: usize, j: usize| is_on(&pressure[i]) != is_on(&pressure[j]);
    let is_sharp = |i: usize, j: usize| is_edge(i, j) && (is_full(i) || is_full(j));
    let wraps = boundary == Boundary::Periodic;
    let mut counts = vec![[0_usize; 2]; ny];
    counts.par_iter_mut().enumerate().for_each(|(iy, [all, sharp])| {
        let first = iy * nx;
        let last = first + nx - 1;
        let below = (iy + 1 < ny || wraps).then_some((iy + 1) % ny * nx);
        let row = &pressure[first..=last];
        let edges = |a: &[T], b: &[T]| {
            let one = |(a, b)| u32::from(is_on(a) != is_on(b));
            vectorised!(a.iter().zip(b).map(one).sum::<u32>()) as usize
        };
        *all = edges(row, &row[1..]) + usize::from(wraps && is_edge(first, last));
        *all += below.map_or(0, |below| edges(row, &pressure[below..]));
        if ceiling.is_finite() {
            *sharp = (first..last).filter(|i| is_sharp(*i, i + 1)).count();
            *sharp += usize::from(wraps && is_sharp(first, last));
            if let Some(below) = below {
                *sharp += (0..nx).filter(|ix| is_sharp(first + ix, below + ix)).count();
            }
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
        let none = f64::INFINITY;
        assert_eq!(edges(grid, &pressure, none, Boundary::Periodic), [12 - 4, 0]);
        assert_eq!(edges(grid, &pressure, none, Boundary::Free), [12 - 2 - 5, 0]);
        assert_eq!(edges(grid, &pressure, 1.0, Boundary::Periodic), [12 - 4; 2]);
    }
}
