//! How moments depend on what was measured: sampling interval, cut-off and height step.
//!
//! For a self-affine surface m2 and m4 have no limit for small pixels; αN, asperity density and
//! radius even less. These functions show by how much, on the map itself.

use crate::{DirectionalMoments, Edges, HeightStatistics, StatsError, Summits};
use contact_types::{Grid, HeightMap, SpectralMoments};

/// Moments of the map as if it had been measured with larger pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct AtInterval {
    /// Every how many points were used.
    pub every: usize,
    /// Distance of the points used, `[dy, dx]` (m).
    pub interval: [f64; 2],
    /// m0 of the whole map; m2 and m4 by finite differences over this distance.
    pub moments: SpectralMoments,
}

/// m2 and m4 by finite differences over 1, 2, 4, 8, ... pixels, as long as four such distances
/// fit: forward slope `(z[i+n] - z[i]) / n dx` and second difference
/// `(z[i+n] - 2 z[i] + z[i-n]) / (n dx)²`, over all pixels of the map where they fit, so that the
/// values differ by the interval and not by the choice of points. The map must be levelled.
///
/// # Errors
/// [`StatsError::TooSmall`] below 3 x 3 pixels.
pub fn moments_by_interval(map: &HeightMap, edges: Edges) -> Result<Vec<AtInterval>, StatsError> {
    let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
    let m0 = HeightStatistics::of(map).rms_height.powi(2);
    let mut points = vec![AtInterval {
        every: 1,
        interval: [dy, dx],
        moments: DirectionalMoments::of(map, edges)?.isotropic(m0),
    }];
    let mut every = 2;
    while 4 * every <= ny.min(nx) {
        let [slope_x, curve_x] = differences(map, edges, every, [0, 1]);
        let [slope_y, curve_y] = differences(map, edges, every, [1, 0]);
        let (y, x) = (every as f64 * dy, every as f64 * dx);
        points.push(AtInterval {
            every,
            interval: [y, x],
            moments: SpectralMoments {
                m0,
                m2: f64::midpoint(slope_x / (x * x), slope_y / (y * y)),
                m4: f64::midpoint(curve_x / (x * x) / (x * x), curve_y / (y * y) / (y * y)),
            },
        });
        every *= 2;
    }
    Ok(points)
}

/// Mean squares of first and second differences over `every` pixels along `[y, x]`.
pub(crate) fn differences(
    map: &HeightMap,
    edges: Edges,
    every: usize,
    [y, x]: [usize; 2],
) -> [f64; 2] {
    let [ny, nx] = map.grid().shape();
    let (step_y, step_x) = (every * y, every * x);
    let (mut sums, mut counts) = ([0.0; 2], [0usize; 2]);
    let periodic = edges == Edges::Periodic;
    for iy in 0..ny {
        let mut row_sums = [0.0; 2];
        for ix in 0..nx {
            let here = map.at(iy, ix);
            if !periodic && (iy + step_y >= ny || ix + step_x >= nx) {
                continue;
            }
            let ahead = map.at((iy + step_y) % ny, (ix + step_x) % nx);
            row_sums[0] += (ahead - here).powi(2);
            counts[0] += 1;
            if periodic || (iy >= step_y && ix >= step_x) {
                let behind = map.at((iy + ny - step_y) % ny, (ix + nx - step_x) % nx);
                row_sums[1] += (ahead - here - (here - behind)).powi(2);
                counts[1] += 1;
            }
        }
        sums[0] += row_sums[0];
        sums[1] += row_sums[1];
    }
    [sums[0] / counts[0] as f64, sums[1] / counts[1] as f64]
}

/// What rounding the heights to a step does.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct AtStep {
    /// Height step (m); 0 for the heights as they are.
    pub step: f64,
    /// Moments by finite differences.
    pub moments: SpectralMoments,
    /// Counted summits and flat tops.
    pub summits: Summits,
}

/// Moments and counted summits of the heights as they are, then rounded to each of `steps` (m).
///
/// # Errors
/// [`StatsError::BadSetting`] for a step that is not positive; [`StatsError::TooSmall`].
pub fn effect_of_steps(
    map: &HeightMap,
    steps: &[f64],
    edges: Edges,
) -> Result<Vec<AtStep>, StatsError> {
    let measure = |map: &HeightMap, step: f64| -> Result<AtStep, StatsError> {
        let m0 = HeightStatistics::of(map).rms_height.powi(2);
        Ok(AtStep {
            step,
            moments: DirectionalMoments::of(map, edges)?.isotropic(m0),
            summits: Summits::of(map, edges)?,
        })
    };
    let mut effects = vec![measure(map, 0.0)?];
    for &step in steps {
        if !(step.is_normal() && step > 0.0) {
            return Err(StatsError::BadSetting {
                setting: "height step",
                value: step,
                requirement: "must be finite and greater than 0",
            });
        }
        effects.push(measure(&rounded(map.grid(), map.heights(), step)?, step)?);
    }
    Ok(effects)
}

fn rounded(grid: Grid, heights: &[f64], step: f64) -> Result<HeightMap, StatsError> {
    let heights = heights.iter().map(|h| (h / step).round() * step).collect();
    Ok(HeightMap::new(grid, heights)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise::white_noise_moments;
    use crate::synthesis::{Scale, SelfAffine};
    use approx::assert_relative_eq;
    use std::f64::consts::TAU;

    fn surface() -> HeightMap {
        let recipe = SelfAffine {
            grid: Grid::new([240, 256], [1e-6, 1.25e-6]).unwrap(),
            hurst: 0.7,
            rolloff: 40e-6,
            cutoff: 8e-6,
            scale: Scale::RmsHeight(0.3e-6),
            seed: 5,
            quantise: None,
        };
        recipe.generate().unwrap()
    }

    /// A wave: transfer functions of the longer interval, [2 sin(q n d/2)/(n d)]² and its square.
    #[test]
    fn transfer_functions_of_every_interval() {
        let grid = Grid::new([64, 80], [1.5, 1.0]).unwrap();
        let q = [TAU * 3.0 / 96.0, TAU * 5.0 / 80.0];
        let map = HeightMap::from_fn(grid, |y, x| (q[0] * y + q[1] * x).cos()).unwrap();
        let points = moments_by_interval(&map, Edges::Periodic).unwrap();
        assert_eq!(points.iter().map(|p| p.every).collect::<Vec<_>>(), [1, 2, 4, 8, 16]);
        for p in points {
            let factor =
                |k: usize| (2.0 * (0.5 * q[k] * p.interval[k]).sin() / p.interval[k]).powi(2);
            let [y, x] = [factor(0), factor(1)];
            assert_relative_eq!(p.moments.m2, 0.25 * (y + x), max_relative = 1e-12);
            assert_relative_eq!(p.moments.m4, 0.25 * (y * y + x * x), max_relative = 1e-12);
        }
    }

    /// Open: a parabola has the same second difference everywhere, so that a stencil that
    /// reached beyond an edge would show; slopes along x are those of its chords.
    #[test]
    fn open_stencils_stay_inside() {
        let grid = Grid::new([16, 32], [1.5, 1.0]).unwrap();
        let map = HeightMap::from_fn(grid, |y, x| 0.5 * (x * x + 3.0 * y * y)).unwrap();
        for p in moments_by_interval(&map, Edges::Open).unwrap() {
            assert_relative_eq!(p.moments.m4, 0.5 * (1.0 + 9.0), max_relative = 1e-12);
        }
    }

    /// Steps add the moments of noise of rms Q/√12 once slopes climb a good part of a step per
    /// pixel, and hide more than half of the summits of a 0.3 um surface at 10 nm.
    #[test]
    fn steps_add_noise_and_hide_summits() {
        let effects = effect_of_steps(&surface(), &[2e-9, 5e-9, 10e-9], Edges::Periodic).unwrap();
        let clean = effects[0];
        for e in &effects[1..] {
            let noise = white_noise_moments(e.step / 12f64.sqrt(), [1e-6, 1.25e-6]);
            let (m2, m4) = (e.moments.m2 - clean.moments.m2, e.moments.m4 - clean.moments.m4);
            // The product of noise and relief averages out to two of its standard deviations.
            let products = |noise: f64, relief: f64| 4.0 * (noise * relief / 61440.0).sqrt();
            assert_relative_eq!(m2, noise.m2, epsilon = products(noise.m2, clean.moments.m2));
            assert_relative_eq!(m4, noise.m4, epsilon = products(noise.m4, clean.moments.m4));
        }
        assert!(effects[1].summits.count < clean.summits.count);
        assert!(2 * effects[3].summits.count < clean.summits.count, "{effects:?}");
        for step in [0.0, -1.0, f64::NAN] {
            let error = effect_of_steps(&surface(), &[step], Edges::Open);
            assert!(matches!(error, Err(StatsError::BadSetting { .. })));
        }
    }
}
