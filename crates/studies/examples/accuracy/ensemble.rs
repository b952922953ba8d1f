//! Surfaces that took no part in the calibration of the budget: other sizes, seeds and families.

use contact_types::{Grid, HeightMap};
use std::error::Error;
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, level};

/// Points along each side.
const POINTS: usize = 160;
const PIXEL: f64 = 1e-6;
/// Rms gradient before heights are bent, disturbed or rounded \[-\].
const GRADIENT: f64 = 0.1;
/// Surfaces of each family.
const EACH: usize = 18;

/// What kind of surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Family {
    /// Self-affine, isotropic, Gaussian.
    SelfAffine,
    /// The sum of two of different Hurst exponent and cut-off.
    TwoScales,
    /// Worn: heights above one deviation pressed together, negative skewness.
    Plateau,
    /// A lay at 45 degrees to the grid.
    ObliqueLay,
    /// With white noise of up to a tenth of pixel and gradient.
    Noisy,
    /// Cut out of a larger map, plane removed: it does not repeat.
    Crop,
    /// Rounded to height steps of 0.05 to 1.5 of pixel and gradient.
    Stepped,
}

impl Family {
    pub(crate) const ALL: [Self; 7] = [
        Self::SelfAffine,
        Self::TwoScales,
        Self::Plateau,
        Self::ObliqueLay,
        Self::Noisy,
        Self::Crop,
        Self::Stepped,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::SelfAffine => "self-affine",
            Self::TwoScales => "two scales",
            Self::Plateau => "plateau",
            Self::ObliqueLay => "oblique lay",
            Self::Noisy => "noisy",
            Self::Crop => "crop",
            Self::Stepped => "stepped",
        }
    }
}

/// One surface of the check.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Recipe {
    pub(crate) family: Family,
    hurst: f64,
    /// Shortest wavelength in pixels.
    pub(crate) cutoff: f64,
    /// Longest in pixels.
    rolloff: f64,
    /// Between 0 and 1, for what is special to the family.
    special: f64,
    seed: u64,
}

/// All of them.
pub(crate) fn recipes() -> Vec<Recipe> {
    let one = |(k, family): (usize, Family)| {
        (0..EACH).map(move |i| {
            // Kronecker sequences: even cover of all ranges from any first part of the list.
            let t = |by: f64| ((1 + i) as f64 * by + 0.37 * k as f64).fract();
            let cutoff = 2.5 * 16f64.powf(t(0.754_877_666));
            Recipe {
                family,
                hurst: 0.3 + 0.7 * t(0.569_840_290),
                cutoff,
                rolloff: (POINTS as f64 / (2.0 + 8.0 * t(0.381_966))).max(1.5 * cutoff),
                special: t(0.618_034),
                seed: 70_001 + (100 * k + i) as u64,
            }
        })
    };
    Family::ALL.into_iter().enumerate().flat_map(one).collect()
}

impl Recipe {
    fn base(&self, points: usize, pixel: [f64; 2], seed: u64) -> Result<HeightMap, Box<dyn Error>> {
        let grid = Grid::new([points, points], pixel)?;
        let recipe = SelfAffine {
            grid,
            hurst: self.hurst,
            rolloff: self.rolloff * PIXEL,
            cutoff: self.cutoff * PIXEL,
            scale: Scale::RmsGradient(GRADIENT),
            seed,
            quantise: None,
        };
        let square = Grid::new([points, points], [PIXEL, PIXEL])?;
        Ok(HeightMap::new(square, recipe.generate()?.into_heights())?)
    }

    fn periodic(&self) -> Result<HeightMap, Box<dyn Error>> {
        self.base(POINTS, [PIXEL, PIXEL], self.seed)
    }

    /// The map.
    pub(crate) fn make(&self) -> Result<HeightMap, Box<dyn Error>> {
        let scale = PIXEL * GRADIENT;
        match self.family {
            Family::SelfAffine => self.periodic(),
            Family::TwoScales => {
                let coarse = Self { hurst: 1.0, cutoff: 3.0 * self.cutoff, ..*self };
                let long = Self { rolloff: self.rolloff.max(4.0 * self.cutoff), ..coarse };
                let (a, b) = (self.periodic()?, long.base(POINTS, [PIXEL, PIXEL], self.seed + 50)?);
                let weight = 0.5 + self.special;
                let sum = a.heights().iter().zip(b.heights()).map(|(a, b)| a + weight * b);
                Ok(HeightMap::new(a.grid(), sum.collect())?)
            }
            Family::Plateau => {
                let map = self.periodic()?;
                let n = map.grid().len() as f64;
                let rms = (map.heights().iter().map(|h| h * h).sum::<f64>() / n).sqrt();
                let sharpness = 1.0 + 4.0 * self.special;
                let worn = |h: &f64| -rms / sharpness * (sharpness * (1.0 - h / rms)).exp().ln_1p();
                let map = HeightMap::new(map.grid(), map.heights().iter().map(worn).collect())?;
                // Bending makes shorter waves: keep those down to 3 pixels.
                let kept = 2 * POINTS / 3;
                let coarse = resample(&map, [kept, kept], Edges::Periodic)?;
                Ok(resample(&coarse, map.grid().shape(), Edges::Periodic)?)
            }
            Family::ObliqueLay => {
                let stretch = 1.5 + 4.5 * self.special;
                let lay = self.base(POINTS, [PIXEL / stretch, PIXEL], self.seed)?;
                let sheared = |i: usize| lay.at(i / POINTS, (i % POINTS + i / POINTS) % POINTS);
                let heights = (0..POINTS * POINTS).map(sheared).collect();
                Ok(HeightMap::new(lay.grid(), heights)?)
            }
            Family::Noisy => {
                let map = self.periodic()?;
                let rms = 0.1 * self.special * scale;
                let noise = self.noise(map.grid().len());
                let sum = map.heights().iter().zip(noise).map(|(h, s)| h + rms * s);
                Ok(HeightMap::new(map.grid(), sum.collect())?)
            }
            Family::Crop => {
                let large = self.base(3 * POINTS, [PIXEL, PIXEL], self.seed)?;
                let cut = |i: usize| large.at(POINTS + i / POINTS, POINTS + i % POINTS);
                let grid = Grid::new([POINTS, POINTS], [PIXEL, PIXEL])?;
                let crop = HeightMap::new(grid, (0..POINTS * POINTS).map(cut).collect())?;
                Ok(level(&crop, Level::Plane)?)
            }
            Family::Stepped => {
                let map = self.periodic()?;
                let step = 0.05 * 30f64.powf(self.special) * scale;
                let rounded = map.heights().iter().map(|h| (h / step).round() * step).collect();
                Ok(HeightMap::new(map.grid(), rounded)?)
            }
        }
    }

    /// Sums of twelve uniform numbers: mean 0, deviation 1, close to normal.
    fn noise(&self, count: usize) -> Vec<f64> {
        let mut state = self.seed;
        let mut uniform = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..count).map(|_| (0..12).map(|_| uniform()).sum::<f64>() - 6.0).collect()
    }
}
