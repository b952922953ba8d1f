//! Marks that run across a map: scratches, grooves, tool marks.
//!
//! A few of them strewn at random make the rms height and the rms gradient of one map differ from
//! those of the next by far more than its waves say, because all points along a mark come together.
//! They are seen in the spectrum of the squared slopes: that of spots, or of independent waves, is
//! alike in all directions at its long end, and that of a lay changes slowly with the direction; marks
//! put all of theirs onto one ray each. What stands out of its surroundings is therefore of marks. The
//! variance of the mean over a map is the power of its long waves, and that of marks adds up over their
//! directions, where a mean over all directions would count each with the small part of the plane that
//! its ray takes up.

use contact_types::HeightMap;
use std::f64::consts::{PI, TAU};

/// Sectors of the half plane of waves.
const SECTORS: usize = 12;
/// Waves looked at: periods along the shorter side.
const LOOKED_AT: [f64; 2] = [2.5, 8.6];
/// Sectors to either side that are surroundings.
const APART: usize = 2;
/// Power of a sector that stands out, over that of the middle one.
const STANDS_OUT: f64 = 1.0;
/// Waves of a sector over those of a ray through it, π/12 (8.6² − 2.5²)/2 : (8.6 − 2.5).
const PER_RAY: f64 = 1.5;
/// Points along a side below which there are too few waves.
const FEWEST: usize = 32;

/// Relative standard errors of rms height and rms gradient over maps of the same surface that marks
/// across it make; zeros where none stand out.
pub(super) fn scatter_by_lines(surface: &HeightMap) -> [f64; 2] {
    let [ny, nx] = surface.grid().shape();
    if ny.min(nx) < FEWEST {
        return [0.0; 2];
    }
    let [dy, dx] = surface.grid().pixel();
    let slope = |iy: usize, ix: usize| {
        let here = surface.at(iy, ix);
        // The last line has its neighbour before it.
        let y = if iy + 1 < ny { iy + 1 } else { iy - 1 };
        let x = if ix + 1 < nx { ix + 1 } else { ix - 1 };
        ((surface.at(y, ix) - here) / dy).powi(2) + ((surface.at(iy, x) - here) / dx).powi(2)
    };
    let Some(gradient) = standing_out(&sectors(surface, slope)) else { return [0.0; 2] };
    let mean = surface.mean();
    let heights = sectors(surface, |iy, ix| (surface.at(iy, ix) - mean).powi(2));
    let height = standing_out(&heights).unwrap_or(0.0);
    [height, gradient].map(|power| 0.5 * power.sqrt())
}

/// Power of the long waves of marks, with what lies beneath it; `None` if nothing stands out.
fn standing_out(sectors: &[f64; SECTORS]) -> Option<f64> {
    let mut sorted = *sectors;
    sorted.sort_by(f64::total_cmp);
    let ground = 0.5 * (sorted[SECTORS / 2 - 1] + sorted[SECTORS / 2]);
    let excess = |j: usize| {
        let beside = [APART, SECTORS - APART].map(|apart| sectors[(j + apart) % SECTORS]);
        sectors[j] - ground.max(beside[0]).max(beside[1])
    };
    let marks: f64 = (0..SECTORS).map(excess).filter(|e| *e > STANDS_OUT * ground).sum();
    (marks > 0.0).then_some(ground + PER_RAY * marks)
}

/// Mean power, over the square of the mean, of the waves of a positive field in each sector.
fn sectors(surface: &HeightMap, field: impl Fn(usize, usize) -> f64) -> [f64; SECTORS] {
    let [ny, nx] = surface.grid().shape();
    let [dy, dx] = surface.grid().pixel();
    let sides = [ny as f64 * dy, nx as f64 * dx];
    let shorter = sides[0].min(sides[1]);
    let most = |side: f64, n: usize| ((LOOKED_AT[1] * side / shorter) as usize).min((n - 1) / 2);
    let (ky_most, kx_most) = (most(sides[0], ny), most(sides[1], nx));
    let turns = |n: usize| -> Vec<(f64, f64)> {
        (0..n).map(|i| (TAU * i as f64 / n as f64).sin_cos()).collect()
    };
    let (turns_y, turns_x) = (turns(ny), turns(nx));
    // Sums of field exp(i q x) over the map, row after row.
    let mut sums = vec![[0.0; 2]; (2 * ky_most + 1) * (kx_most + 1)];
    let mut along = vec![[0.0; 2]; kx_most + 1];
    for iy in 0..ny {
        along.fill([0.0; 2]);
        for ix in 0..nx {
            let value = field(iy, ix);
            for (kx, [re, im]) in along.iter_mut().enumerate() {
                let (sin, cos) = turns_x[kx * ix % nx];
                *re += value * cos;
                *im += value * sin;
            }
        }
        for (j, row) in sums.chunks_exact_mut(kx_most + 1).enumerate() {
            // ky runs from -ky_most to ky_most.
            let (sin, cos) = turns_y[(j + ny - ky_most) % ny * iy % ny];
            for (sum, [re, im]) in row.iter_mut().zip(&along) {
                sum[0] += re * cos - im * sin;
                sum[1] += re * sin + im * cos;
            }
        }
    }
    let mean_square = sums[ky_most * (kx_most + 1)][0].powi(2);
    let mut found = [[0.0; 2]; SECTORS];
    for (i, [re, im]) in sums.iter().enumerate() {
        let (ky, kx) = ((i / (kx_most + 1)) as f64 - ky_most as f64, (i % (kx_most + 1)) as f64);
        let (y, x) = (ky * shorter / sides[0], kx * shorter / sides[1]);
        if kx < 0.5 && ky < 0.5 || !(LOOKED_AT[0]..=LOOKED_AT[1]).contains(&y.hypot(x)) {
            continue; // each wave once
        }
        let width = PI / SECTORS as f64;
        let sector = ((y.atan2(x) + 0.5 * width).rem_euclid(PI) / width) as usize % SECTORS;
        found[sector][0] += (re * re + im * im) / mean_square;
        found[sector][1] += 1.0;
    }
    found.map(|[sum, count]| if sum > 0.0 { sum / f64::max(count, 1.0) } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;
    use surface_stats::synthesis::{Scale, SelfAffine};

    fn map(stretch: f64, seed: u64) -> HeightMap {
        let grid = Grid::new([128, 128], [1.0 / stretch, 1.0]).unwrap();
        let scale = Scale::ExpectedRmsGradient(0.1);
        let recipe = SelfAffine {
            grid,
            hurst: 0.7,
            rolloff: 20.0,
            cutoff: 5.0,
            scale,
            seed,
            quantise: None,
        };
        let square = Grid::new([128, 128], [1.0, 1.0]).unwrap();
        HeightMap::new(square, recipe.generate().unwrap().into_heights()).unwrap()
    }

    /// Steep lines stand out of a rough ground, whatever the shape of the map; the ground alone,
    /// and spots strewn over it, do not.
    #[test]
    fn lines_stand_out_and_roughness_and_spots_do_not() {
        for seed in 0..6 {
            let ground = map(1.0, 40 + seed);
            let with = |mark: &dyn Fn(f64, f64) -> f64| {
                let at = |i: usize| ((i / 128) as f64, (i % 128) as f64);
                let marked =
                    ground.heights().iter().enumerate().map(|(i, h)| h - mark(at(i).0, at(i).1));
                HeightMap::new(ground.grid(), marked.collect()).unwrap()
            };
            let groove = |s: f64| 2.0 * (-0.5 * (s / 3.0).powi(2)).exp();
            let shift = seed as f64;
            let line = |y: f64, x: f64| groove(0.8 * (x - 40.0 - shift) + 0.6 * (y - 64.0));
            let spot = |y: f64, x: f64| groove((x - 40.0 - shift).hypot(y - 64.0) / 2.0);
            let [plain, spots, lines] = [&ground, &with(&spot), &with(&line)].map(scatter_by_lines);
            assert!(lines[1] > 0.1, "{seed}: {lines:?}");
            assert!(lines[1] > 3.0 * plain[1] && lines[1] > 3.0 * spots[1], "{plain:?} {spots:?}");
        }
    }

    /// One wave of the squared heights along x has half its amplitude squared, over the square of the mean, in one wave
    /// of the sector along x.
    #[test]
    fn power_of_one_wave_lands_in_its_sector() {
        let grid = Grid::new([64, 96], [1.0, 2.0]).unwrap();
        let map = HeightMap::from_fn(grid, |_, _| 0.0).unwrap();
        let wave = |_: usize, ix: usize| 2.0 + (TAU * 12.0 * ix as f64 / 96.0).cos();
        let found = sectors(&map, wave);
        // 12 periods along the side of 192: 4 along the shorter one of 64. |F|² = (1/2)² over 2².
        let filled: Vec<usize> = (0..SECTORS).filter(|j| found[*j] > 1e-12).collect();
        assert_eq!(filled, [0]);
        let waves = 0.0625 / found[0];
        assert!((waves - waves.round()).abs() < 1e-6 && waves > 3.0, "{waves}");
    }
}
