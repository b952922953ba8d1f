//! Autocorrelation length, texture aspect ratio and direction.

use crate::spectrum::PowerSpectrum;
use crate::{Edges, StatsError, scale};
use contact_types::{Grid, HeightMap};
use grid_fft::{Complex, GridFft};
use std::f64::consts::PI;

/// Where the autocorrelation counts as gone (default value of ISO 25178-2:2021, 4.3).
const DECAYED: f64 = 0.2;

/// Directions looked at over half a turn.
const DIRECTIONS: usize = 360;

/// Normalised autocorrelation of the heights about their mean.
///
/// Open maps are continued by zeros and each shift is divided by the area that overlaps; shifts beyond half the map are not
/// used.
struct Autocorrelation {
    grid: Grid,
    values: Vec<f64>,
    reach: [f64; 2],
}

/// Spatial parameters (ISO 25178-2:2021, 4.3), by the autocorrelation along rays half a degree apart; both are `None` on a
/// flat map. An open map needs four times its memory, twice.
/// - Sal: shortest shift, over all directions, at which the autocorrelation first falls to 0.2 (m). `None` if it does not
///   within half the map.
/// - Str: Sal over the longest such shift (-): 1 for an isotropic texture. `None` if in some direction it does not fall to
///   0.2 within half the map.
pub(super) fn spatial(map: &HeightMap, edges: Edges) -> Result<[Option<f64>; 2], StatsError> {
    let correlation = Autocorrelation::of(map, edges)?;
    if correlation.values[0] <= 0.0 {
        return Ok([None; 2]);
    }
    let rays: Vec<Option<f64>> =
        (0..DIRECTIONS).map(|k| correlation.decay(PI * k as f64 / DIRECTIONS as f64)).collect();
    let shortest = rays.iter().flatten().copied().min_by(f64::total_cmp);
    let longest = rays.into_iter().collect::<Option<Vec<f64>>>();
    let longest = longest.and_then(|rays| rays.into_iter().max_by(f64::total_cmp));
    Ok([shortest, shortest.zip(longest).map(|(short, long)| short / long)])
}

impl Autocorrelation {
    /// Correlates a map with itself by FFT.
    fn of(map: &HeightMap, edges: Edges) -> Result<Self, StatsError> {
        scale::check(map)?;
        let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
        let open = edges == Edges::Open;
        let shape = if open { [2 * ny, 2 * nx] } else { [ny, nx] };
        let grid = Grid::new(shape, map.grid().pixel())?;
        let mean = map.mean();
        let mut values = vec![0.0; grid.len()];
        for (iy, row) in map.heights().chunks_exact(nx).enumerate() {
            for (z, h) in values[iy * shape[1]..].iter_mut().zip(row) {
                *z = h - mean;
            }
        }
        let mut fft = GridFft::new(shape);
        let mut waves = fft.new_spectrum();
        fft.forward(&values, &mut waves);
        for wave in &mut waves {
            *wave = Complex::new(wave.norm_sqr(), 0.0);
        }
        fft.inverse(&mut waves, &mut values);
        let variance = values[0];
        for (i, value) in values.iter_mut().enumerate() {
            let shift = |i: usize, n: usize| i.min(n - i);
            let overlap = if open {
                let [sy, sx] = [shift(i / shape[1], shape[0]), shift(i % shape[1], shape[1])];
                (ny - sy.min(ny)) as f64 * (nx - sx.min(nx)) as f64 / (ny * nx) as f64
            } else {
                1.0
            };
            *value =
                if variance > 0.0 && overlap > 0.0 { *value / variance / overlap } else { 0.0 };
        }
        Ok(Self { grid, values, reach: [0.5 * ny as f64 * dy, 0.5 * nx as f64 * dx] })
    }

    /// Autocorrelation at the shift (y, x) in metres, linear between pixels; `None` beyond half
    /// the map.
    fn at(&self, y: f64, x: f64) -> Option<f64> {
        if y.abs() > self.reach[0] || x.abs() > self.reach[1] {
            return None;
        }
        let ([ny, nx], [dy, dx]) = (self.grid.shape(), self.grid.pixel());
        let (v, u) = (y / dy, x / dx);
        let (fy, fx) = (v - v.floor(), u - u.floor());
        let wrap = |i: f64, n: usize| i.rem_euclid(n as f64) as usize % n;
        let value = |ky: f64, kx: f64| {
            self.values[wrap(v.floor() + ky, ny) * nx + wrap(u.floor() + kx, nx)]
        };
        let row = |ky: f64| (1.0 - fx) * value(ky, 0.0) + fx * value(ky, 1.0);
        Some((1.0 - fy) * row(0.0) + fy * row(1.0))
    }

    /// Shift in direction `angle` (rad, from x towards y) at which the autocorrelation first
    /// falls to 0.2.
    fn decay(&self, angle: f64) -> Option<f64> {
        let [dy, dx] = self.grid.pixel();
        let (sin, cos) = angle.sin_cos();
        // Half a pixel along the axis that the ray crosses faster.
        let step = 0.5 / (sin.abs() / dy).max(cos.abs() / dx);
        let (mut before, mut k) = (1.0, 1.0);
        loop {
            let shift = k * step;
            let now = self.at(shift * sin, shift * cos)?;
            if now <= DECAYED {
                return Some(shift - step * (DECAYED - now) / (before - now));
            }
            before = now;
            k += 1.0;
        }
    }
}

/// Std: direction of the strongest waves in degrees from the x axis towards y, 0 to 180: the maximum of the power within
/// five degrees. The lay runs at right angles to it. `None` for a flat map.
pub(super) fn texture_direction(map: &HeightMap) -> Result<Option<f64>, StatsError> {
    let power = PowerSpectrum::of(map, Edges::Periodic)?;
    let mut angular = [0.0; 180];
    power.for_each(|[qy, qx], weight, variance| {
        let angle = qy.atan2(qx).to_degrees().rem_euclid(180.0);
        let nearest = angle.round() as usize;
        for offset in 0..=10 {
            let direction = (nearest + 175 + offset) % 180;
            let distance = (angle - direction as f64).abs();
            let distance = distance.min(180.0 - distance);
            // A cosine bell, so that the direction of a single wave is its own.
            let bell = (0.5 * PI * (distance / 5.0).min(1.0)).cos().powi(2);
            angular[direction] += weight * variance * bell;
        }
    });
    let strongest = (0..180).max_by(|&a, &b| angular[a].total_cmp(&angular[b]));
    Ok(strongest.filter(|&d| angular[d] > 0.0).map(|d| d as f64))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use crate::synthesis::rough;
    use approx::assert_relative_eq;
    use std::f64::consts::TAU;

    /// A wave in direction 30 degrees has the autocorrelation cos(q·t): it falls to 0.2 at
    /// acos(0.2)/q along itself and never along its crests.
    #[test]
    fn a_wave_by_its_own_autocorrelation() {
        let grid = Grid::new([240, 256], [1.5, 1.0]).unwrap();
        let q = [TAU * 7.0 / 360.0, TAU * 9.0 / 256.0];
        let map = HeightMap::from_fn(grid, |y, x| 5.0 + (q[0] * y + q[1] * x).cos()).unwrap();
        let expected = 0.2f64.acos() / q[0].hypot(q[1]);
        for edges in [Edges::Open, Edges::Periodic] {
            let [length, aspect] = spatial(&map, edges).unwrap();
            close(length.unwrap(), expected, 0.003);
            assert_eq!(aspect, None);
        }
        let direction = texture_direction(&map).unwrap().unwrap();
        assert_relative_eq!(direction, q[0].atan2(q[1]).to_degrees(), epsilon = 1.0);
        // Periodic: exactly the cosine, to the straight lines between pixels; not beyond half the map.
        let correlation = Autocorrelation::of(&map, Edges::Periodic).unwrap();
        for shift in -20..=20 {
            let (y, x) = (3.0, f64::from(shift));
            let value = correlation.at(y, x).unwrap();
            assert_relative_eq!(value, (q[0] * y + q[1] * x).cos(), epsilon = 1e-13);
        }
        assert_eq!(correlation.at(181.0, 0.0), None);
    }

    #[test]
    fn isotropic_and_stretched_surfaces() {
        let aspect = |dy: f64| {
            let grid = Grid::new([512, 512], [1e-6, 1e-6]).unwrap();
            let heights = rough(grid, 0.8, [20e-6, 4e-6], 1e-7, 9).into_heights();
            let grid = Grid::new([512, 512], [dy, 1e-6]).unwrap();
            let map = HeightMap::new(grid, heights).unwrap();
            spatial(&map, Edges::Periodic).unwrap()[1].unwrap()
        };
        let isotropic = aspect(1e-6);
        assert!(isotropic > 0.85, "{isotropic}");
        close(aspect(4e-6), 0.25, 0.15);
    }
}
