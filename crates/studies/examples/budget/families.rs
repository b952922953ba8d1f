//! Families of surfaces for the part of the finite sample: maps of one family differ by their seed
//! alone, as places on one surface do.

use contact_types::{Grid, HeightMap};
use std::error::Error;
use std::fmt;
use surface_stats::synthesis::{Scale, SelfAffine};

const PIXEL: f64 = 1e-6;
/// Rms gradient expected of a self-affine family \[-\].
pub(crate) const GRADIENT: f64 = 0.1;

/// What the maps of a family are.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// Hurst exponent, shortest and roll-off wavelength in points.
    SelfAffine([f64; 3]),
    /// A lay of 6 : 1 with white noise on top.
    GroundNoisy,
    /// Worn to a plateau, with a fine roughness: deep valleys, negative skewness.
    PlateauHoned,
    /// Two levels joined by slopes, with a fine roughness: a bimodal height distribution.
    TwoLevels,
    /// Roughness that is strong in some places and weak in others.
    Patchy,
    /// A lay of 4 : 1.
    Lay,
    /// Two lays of 5 : 1 across each other.
    CrossHatched,
    /// Few high plateaus, with a fine roughness: positive skewness.
    Pillars,
    /// Deep pits in a smoother ground.
    Pitted,
    /// Rough, but for wide smooth places.
    PartlyPolished,
    /// Log-normal heights.
    LogNormal,
}

/// What a family was used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// Fixed the factors.
    Calibration,
    /// Seen when the factors were widened.
    Widening,
    /// Solved once to check the factors of then; seen when those of gap and stiffness were widened.
    Check,
    /// Solved once, after the factors were fixed.
    Fresh,
}

/// One family.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Family {
    pub(crate) role: Role,
    kind: Kind,
    /// Points along y and x.
    shape: [usize; 2],
}

const fn old(role: Role, spectrum: [f64; 3]) -> Family {
    Family { role, kind: Kind::SelfAffine(spectrum), shape: [256, 256] }
}

const fn check(kind: Kind, shape: [usize; 2]) -> Family {
    Family { role: Role::Check, kind, shape }
}

const fn fresh(kind: Kind, shape: [usize; 2]) -> Family {
    Family { role: Role::Fresh, kind, shape }
}

const SQUARE: [usize; 2] = [240, 240];
const OBLONG: [usize; 2] = [180, 360];
const WIDE: [usize; 2] = [192, 320];

/// All of them. The table keeps their places: new ones go to the end.
pub(crate) const FAMILIES: [Family; 48] = [
    old(Role::Calibration, [0.3, 4.0, 64.0]),
    old(Role::Calibration, [0.3, 8.0, 32.0]),
    old(Role::Calibration, [0.3, 8.0, 128.0]),
    old(Role::Calibration, [0.5, 4.0, 16.0]),
    old(Role::Calibration, [0.5, 8.0, 64.0]),
    old(Role::Calibration, [0.5, 16.0, 128.0]),
    old(Role::Calibration, [0.8, 4.0, 32.0]),
    old(Role::Calibration, [0.8, 8.0, 16.0]),
    old(Role::Calibration, [0.8, 8.0, 64.0]),
    old(Role::Calibration, [0.8, 4.0, 256.0]),
    old(Role::Calibration, [0.9, 16.0, 64.0]),
    old(Role::Calibration, [0.9, 4.0, 128.0]),
    old(Role::Widening, [0.4, 6.0, 48.0]),
    old(Role::Widening, [0.4, 12.0, 96.0]),
    old(Role::Widening, [0.7, 4.0, 24.0]),
    old(Role::Widening, [0.7, 6.0, 96.0]),
    old(Role::Widening, [0.8, 8.0, 128.0]),
    old(Role::Widening, [0.9, 8.0, 32.0]),
    old(Role::Widening, [0.6, 4.0, 200.0]),
    old(Role::Widening, [0.85, 16.0, 40.0]),
    check(Kind::SelfAffine([0.2, 5.0, 40.0]), SQUARE),
    check(Kind::SelfAffine([0.35, 10.0, 120.0]), SQUARE),
    check(Kind::SelfAffine([0.45, 20.0, 80.0]), SQUARE),
    check(Kind::SelfAffine([0.55, 5.0, 240.0]), SQUARE),
    check(Kind::SelfAffine([0.65, 12.0, 60.0]), OBLONG),
    check(Kind::SelfAffine([0.75, 3.0, 30.0]), SQUARE),
    check(Kind::SelfAffine([0.75, 6.0, 160.0]), OBLONG),
    check(Kind::SelfAffine([0.95, 5.0, 20.0]), SQUARE),
    check(Kind::SelfAffine([0.95, 10.0, 200.0]), SQUARE),
    check(Kind::SelfAffine([1.0, 8.0, 48.0]), SQUARE),
    check(Kind::GroundNoisy, SQUARE),
    check(Kind::PlateauHoned, SQUARE),
    check(Kind::TwoLevels, SQUARE),
    check(Kind::Patchy, SQUARE),
    fresh(Kind::SelfAffine([0.25, 6.0, 30.0]), SQUARE),
    fresh(Kind::SelfAffine([0.4, 4.0, 90.0]), WIDE),
    fresh(Kind::SelfAffine([0.5, 12.0, 180.0]), SQUARE),
    fresh(Kind::SelfAffine([0.6, 8.0, 40.0]), WIDE),
    fresh(Kind::SelfAffine([0.7, 10.0, 100.0]), SQUARE),
    fresh(Kind::SelfAffine([0.8, 3.0, 220.0]), SQUARE),
    fresh(Kind::SelfAffine([0.85, 14.0, 56.0]), WIDE),
    fresh(Kind::SelfAffine([0.9, 6.0, 70.0]), SQUARE),
    fresh(Kind::Lay, SQUARE),
    fresh(Kind::CrossHatched, SQUARE),
    fresh(Kind::Pillars, SQUARE),
    fresh(Kind::Pitted, SQUARE),
    fresh(Kind::PartlyPolished, SQUARE),
    fresh(Kind::LogNormal, SQUARE),
];

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            Kind::SelfAffine([hurst, cutoff, rolloff]) => {
                write!(f, "{hurst}, {cutoff}, {rolloff}")?;
            }
            Kind::GroundNoisy => write!(f, "ground, with noise")?,
            Kind::PlateauHoned => write!(f, "plateau-honed")?,
            Kind::TwoLevels => write!(f, "two levels")?,
            Kind::Patchy => write!(f, "patchy")?,
            Kind::Lay => write!(f, "lay")?,
            Kind::CrossHatched => write!(f, "cross-hatched")?,
            Kind::Pillars => write!(f, "pillars")?,
            Kind::Pitted => write!(f, "pitted")?,
            Kind::PartlyPolished => write!(f, "partly polished")?,
            Kind::LogNormal => write!(f, "log-normal")?,
        }
        let [ny, nx] = self.shape;
        if ny == nx { Ok(()) } else { write!(f, "; {nx} × {ny}") }
    }
}

impl Family {
    /// The map of this family, which stands at `place` in the list, with this seed.
    pub(crate) fn generate(&self, place: usize, seed: usize) -> Result<HeightMap, Box<dyn Error>> {
        let seed = match self.role {
            Role::Calibration | Role::Widening => 20_000 + 1000 * place + seed,
            Role::Check | Role::Fresh => 400_000 + 1000 * place + seed,
        } as u64;
        let square = Grid::new(self.shape, [PIXEL, PIXEL])?;
        let map = |heights| Ok(HeightMap::new(square, heights)?);
        match self.kind {
            Kind::SelfAffine(spectrum) => waves(square, spectrum, GRADIENT, seed),
            Kind::GroundNoisy => {
                // Made on pixels short in y, then called square: lengths along y come out longer.
                let short = Grid::new(self.shape, [PIXEL / 6.0, PIXEL])?;
                let lay = waves(short, [0.8, 6.0, 60.0], GRADIENT, seed)?;
                let noise = SelfAffine {
                    scale: Scale::RmsHeight(0.06 * GRADIENT * PIXEL),
                    ..recipe(square, [0.5, 2.0, 2.0], GRADIENT, seed + 500)
                };
                map(pairs(&lay, &noise.generate()?, |h, n| h + n))
            }
            Kind::PlateauHoned => {
                let coarse = waves(square, [0.8, 12.0, 80.0], GRADIENT, seed)?;
                let fine = waves(square, [0.6, 4.0, 24.0], 0.3 * GRADIENT, seed + 500)?;
                map(pairs(&coarse, &fine, |h, fine| worn(h - 0.3 * HEIGHT) + fine))
            }
            Kind::TwoLevels => {
                let coarse = waves(square, [0.8, 12.0, 80.0], GRADIENT, seed)?;
                let fine = waves(square, [0.6, 5.0, 30.0], GRADIENT, seed + 500)?;
                map(pairs(&coarse, &fine, |h, fine| HEIGHT * (2.0 * h / HEIGHT).tanh() + fine))
            }
            Kind::Patchy => {
                let strength = waves(square, [0.8, 40.0, 80.0], GRADIENT, seed)?;
                let rough = waves(square, [0.7, 5.0, 40.0], GRADIENT, seed + 500)?;
                map(pairs(&strength, &rough, |s, h| (1.0 + 0.8 * (s / HEIGHT).tanh()) * h))
            }
            Kind::Lay => {
                let short = Grid::new(self.shape, [PIXEL / 4.0, PIXEL])?;
                map(waves(short, [0.7, 5.0, 40.0], GRADIENT, seed)?.into_heights())
            }
            Kind::CrossHatched => {
                let [ny, nx] = self.shape;
                let short = Grid::new(self.shape, [PIXEL / 5.0, PIXEL])?;
                let right = waves(short, [0.8, 6.0, 36.0], GRADIENT, seed)?;
                let left = waves(short, [0.8, 6.0, 36.0], GRADIENT, seed + 500)?;
                let sum = |i: usize| {
                    let (iy, ix) = (i / nx, i % nx);
                    right.at(iy, (ix + iy) % nx) + left.at(iy, (ix + ny - iy) % nx)
                };
                map((0..ny * nx).map(sum).collect())
            }
            Kind::Pillars => {
                let coarse = waves(square, [0.8, 12.0, 48.0], GRADIENT, seed)?;
                let fine = waves(square, [0.5, 4.0, 20.0], 0.5 * GRADIENT, seed + 500)?;
                let height = 0.5 * HEIGHT;
                map(pairs(&coarse, &fine, |h, fine| {
                    height * (2.0 * (h - height) / height).tanh() + fine
                }))
            }
            Kind::Pitted => {
                let pits = waves(square, [0.8, 16.0, 48.0], GRADIENT, seed)?;
                let ground = waves(square, [0.8, 5.0, 40.0], 0.5 * GRADIENT, seed + 500)?;
                map(pairs(&pits, &ground, |p, h| h - 2.0 * (p - 0.5 * HEIGHT).max(0.0)))
            }
            Kind::PartlyPolished => {
                let place = waves(square, [0.9, 60.0, 120.0], GRADIENT, seed)?;
                let rough = waves(square, [0.6, 5.0, 30.0], GRADIENT, seed + 500)?;
                map(pairs(&place, &rough, |s, h| if s > 0.0 { 0.2 * h } else { h }))
            }
            Kind::LogNormal => {
                let coarse = waves(square, [0.7, 6.0, 60.0], GRADIENT, seed)?;
                map(coarse.heights().iter().map(|h| HEIGHT * (0.5 * h / HEIGHT).exp()).collect())
            }
        }
    }
}

/// About the rms height of the long waves that are bent \[m\].
const HEIGHT: f64 = 0.75e-6;

/// Heights below 0 as they are, those above pressed to 0.
fn worn(height: f64) -> f64 {
    let sharp = 8.0 / HEIGHT;
    -(-sharp * height).exp().ln_1p() / sharp
}

fn pairs(a: &HeightMap, b: &HeightMap, f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    a.heights().iter().zip(b.heights()).map(|(a, b)| f(*a, *b)).collect()
}

fn recipe(grid: Grid, [hurst, cutoff, rolloff]: [f64; 3], gradient: f64, seed: u64) -> SelfAffine {
    SelfAffine {
        grid,
        hurst,
        rolloff: rolloff * PIXEL,
        cutoff: cutoff * PIXEL,
        scale: Scale::ExpectedRmsGradient(gradient),
        seed,
        quantise: None,
    }
}

fn waves(
    grid: Grid,
    spectrum: [f64; 3],
    gradient: f64,
    seed: u64,
) -> Result<HeightMap, Box<dyn Error>> {
    Ok(recipe(grid, spectrum, gradient, seed).generate()?)
}
