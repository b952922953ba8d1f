//! The long waves of a positive field: how far its mean scatters from map to map.
//!
//! The variance of the mean of a field over a map is its power at long waves, which is flat there. Of spots,
//! or of waves that are independent, it is alike in all directions. Marks that run across a map, such as
//! scratches, grooves or tool marks, put all of theirs onto one ray each, since all points along a mark come
//! together; that of a lay changes slowly with the direction. What stands out of its surroundings is therefore of
//! marks, and adds up over their directions, where a mean over all directions would count each with the small
//! part of the plane that its ray takes up.

use contact_types::Grid;
use std::f64::consts::{PI, TAU};

/// Waves that stand for the long end: periods over the map along y and x. It is flat there, so that edges
/// which do not match need no window.
const LONGEST: [[f64; 2]; 6] =
    [[0.0, 1.0], [0.0, 2.0], [1.0, 0.0], [2.0, 0.0], [1.0, 1.0], [-1.0, 1.0]];
/// Sectors of the half plane of waves.
const SECTORS: usize = 12;
/// Waves looked at for marks: periods along the shorter side.
const LOOKED_AT: [f64; 2] = [2.5, 8.6];
/// Sectors to either side that are surroundings.
const APART: usize = 2;
/// Power of a sector that stands out, over that of the middle one.
const STANDS_OUT: f64 = 1.0;
/// Waves of a sector over those of a ray through it, π/12 (8.6² − 2.5²)/2 : (8.6 − 2.5).
const PER_RAY: f64 = 1.5;
/// Points along a side below which there are too few waves to look for marks.
const FEWEST: usize = 32;

/// Long waves of a field, over its mean.
pub(super) struct LongWaves {
    /// `[ky, kx]`, periods along each side, and power; each wave once.
    waves: Vec<([f64; 2], f64)>,
    /// Sides of the map over the shorter one.
    sides: [f64; 2],
    /// Whether there are enough to look for marks.
    enough: bool,
}

impl LongWaves {
    /// Of the values that `field` has at the points of `grid`; none if their mean is not above 0.
    pub(super) fn of(grid: Grid, field: impl Fn(usize, usize) -> f64) -> Self {
        let ([ny, nx], [dy, dx]) = (grid.shape(), grid.pixel());
        let sides = [ny as f64 * dy, nx as f64 * dx];
        let sides = sides.map(|side| side / sides[0].min(sides[1]));
        let enough = ny.min(nx) >= FEWEST;
        let most = |side: f64, n: usize| {
            // A profile has no waves across.
            (if enough { (LOOKED_AT[1] * side) as usize } else { 2 }).min((n - 1) / 2)
        };
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
        let sum = sums[ky_most * (kx_most + 1)][0];
        let wave = |(i, [re, im]): (usize, &[f64; 2])| {
            let ky = (i / (kx_most + 1)) as f64 - ky_most as f64;
            let kx = (i % (kx_most + 1)) as f64;
            let once = kx > 0.5 || ky > 0.5;
            (once && sum > 0.0).then(|| ([ky, kx], (re * re + im * im) / (sum * sum)))
        };
        let waves = sums.iter().enumerate().filter_map(wave).collect();
        Self { waves, sides, enough }
    }

    /// Relative standard error of the mean if the field is alike in all directions.
    pub(super) fn scatter(&self) -> f64 {
        let power = |[ky, kx]: &[f64; 2]| {
            let is_it = |wave: &&([f64; 2], f64)| (wave.0[0] - ky).hypot(wave.0[1] - kx) < 0.5;
            self.waves.iter().find(is_it).map(|wave| wave.1)
        };
        let longest: Vec<f64> = LONGEST.iter().filter_map(power).collect();
        (longest.iter().sum::<f64>() / longest.len().max(1) as f64).sqrt()
    }

    /// That by marks across the map, with what lies beneath them; 0 where none stand out.
    pub(super) fn scatter_by_marks(&self) -> f64 {
        if !self.enough {
            return 0.0;
        }
        let sectors = self.sectors();
        let mut sorted = sectors;
        sorted.sort_by(f64::total_cmp);
        let ground = 0.5 * (sorted[SECTORS / 2 - 1] + sorted[SECTORS / 2]);
        let excess = |j: usize| {
            let beside = [APART, SECTORS - APART].map(|apart| sectors[(j + apart) % SECTORS]);
            sectors[j] - ground.max(beside[0]).max(beside[1])
        };
        let marks: f64 = (0..SECTORS).map(excess).filter(|e| *e > STANDS_OUT * ground).sum();
        if marks > 0.0 { (ground + PER_RAY * marks).sqrt() } else { 0.0 }
    }

    /// Mean power of the waves of each sector.
    fn sectors(&self) -> [f64; SECTORS] {
        let mut found = [[0.0; 2]; SECTORS];
        for ([ky, kx], power) in &self.waves {
            let (y, x) = (ky / self.sides[0], kx / self.sides[1]);
            if !(LOOKED_AT[0]..=LOOKED_AT[1]).contains(&y.hypot(x)) {
                continue;
            }
            let width = PI / SECTORS as f64;
            let sector = ((y.atan2(x) + 0.5 * width).rem_euclid(PI) / width) as usize % SECTORS;
            found[sector][0] += power;
            found[sector][1] += 1.0;
        }
        found.map(|[sum, count]| sum / f64::max(count, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::HeightMap;
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
            let marks = |map: &HeightMap| {
                let step = |iy: usize, ix: usize| map.at(iy, (ix + 1) % 128) - map.at(iy, ix);
                LongWaves::of(map.grid(), |iy, ix| step(iy, ix).powi(2)).scatter_by_marks()
            };
            let [plain, spots, lines] = [&ground, &with(&spot), &with(&line)].map(marks);
            assert!(lines > 0.2, "{seed}: {lines}");
            assert!(lines > 3.0 * plain && lines > 3.0 * spots, "{plain} {spots} {lines}");
        }
    }

    /// One wave of the squared heights along x has half its amplitude squared, over the square of the mean, in one wave
    /// of the sector along x.
    #[test]
    fn power_of_one_wave_lands_in_its_sector() {
        let grid = Grid::new([64, 96], [1.0, 2.0]).unwrap();
        let wave = |_: usize, ix: usize| 2.0 + (TAU * 12.0 * ix as f64 / 96.0).cos();
        let found = LongWaves::of(grid, wave).sectors();
        // 12 periods along the side of 192: 4 along the shorter one of 64. |F|² = (1/2)² over 2².
        let filled: Vec<usize> = (0..SECTORS).filter(|j| found[*j] > 1e-12).collect();
        assert_eq!(filled, [0]);
        let waves = 0.0625 / found[0];
        assert!((waves - waves.round()).abs() < 1e-6 && waves > 3.0, "{waves}");
    }
}
