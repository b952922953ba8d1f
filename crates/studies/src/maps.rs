//! What the maps of the studies' families are drawn with: numbers that fix one map, random fields,
//! shapes. Heights are in any unit, lengths in points, until a map is scaled.

use contact_types::Grid;
use std::error::Error;
use surface_stats::synthesis::{Scale, SelfAffine};

/// Pixel \[m\].
pub const PIXEL: f64 = 1e-6;

/// Heights of a map, row by row.
pub type Heights = Result<Vec<f64>, Box<dyn Error>>;

/// Numbers that fix one map of a family.
#[derive(Debug, Clone, Copy)]
pub struct Draw {
    /// Points along each side.
    pub n: usize,
    /// Of all that is random in it.
    pub seed: u64,
    /// Between 0 and 1.
    pub t: [f64; 4],
}

/// A random field on `n` points along each side, `stretch` times longer along y; Hurst exponent, shortest
/// wavelength and roll-off in points.
///
/// # Errors
/// Wavelengths that the points cannot hold.
pub fn self_affine(
    n: usize,
    [hurst, cutoff, rolloff]: [f64; 3],
    stretch: f64,
    scale: Scale,
    seed: u64,
) -> Heights {
    let grid = Grid::new([n, n], [1.0 / stretch, 1.0])?;
    let recipe = SelfAffine { grid, hurst, rolloff, cutoff, scale, seed, quantise: None };
    Ok(recipe.generate()?.into_heights())
}

impl Draw {
    /// The number `k` of the draw, from `low` to `high`, evenly in the logarithm.
    pub fn log(&self, k: usize, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.t[k])
    }
    /// The same, evenly.
    pub fn lin(&self, k: usize, low: f64, high: f64) -> f64 {
        low + (high - low) * self.t[k]
    }

    /// Gaussian field of unit rms height, repeating; wavelengths in points. `stretch` times longer along
    /// y; `salt` tells the fields of one map apart.
    ///
    /// # Errors
    /// Wavelengths that the points cannot hold.
    pub fn field(&self, hurst: f64, cutoff: f64, rolloff: f64, stretch: f64, salt: u64) -> Heights {
        self.field_on(self.n, hurst, cutoff, rolloff, stretch, salt)
    }

    /// The same on `n` points along each side.
    ///
    /// # Errors
    /// Wavelengths that the points cannot hold.
    pub fn field_on(
        &self,
        n: usize,
        hurst: f64,
        cutoff: f64,
        rolloff: f64,
        stretch: f64,
        salt: u64,
    ) -> Heights {
        let scale = Scale::RmsHeight(1.0);
        self_affine(n, [hurst, cutoff, rolloff], stretch, scale, self.seed + 1000 * salt)
    }

    /// A field with the wavelengths of this draw.
    ///
    /// # Errors
    /// Wavelengths that the points cannot hold.
    pub fn rough(&self, salt: u64) -> Heights {
        let n = self.n as f64;
        let cutoff = self.log(1, 4.0, 16.0);
        self.field(
            self.lin(0, 0.3, 0.95),
            cutoff,
            (n / self.log(2, 2.0, 12.0)).max(1.5 * cutoff),
            1.0,
            salt,
        )
    }

    /// Independent numbers between 0 and 1.
    pub fn uniform(&self, count: usize, salt: u64) -> Vec<f64> {
        let mut state = self.seed.wrapping_mul(2_654_435_761).wrapping_add(salt);
        let mut next = || {
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..count).map(|_| next()).collect()
    }

    /// Heights by a formula of y and x in points.
    pub fn points(&self, f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let n = self.n;
        (0..n * n).map(|i| f((i / n) as f64, (i % n) as f64)).collect()
    }

    /// Shortest distance of two points on the map that repeats.
    pub fn apart(&self, a: f64, b: f64) -> f64 {
        let n = self.n as f64;
        let d = (a - b).rem_euclid(n);
        if d > 0.5 * n { d - n } else { d }
    }
}

/// The lower of a height and a level, with a rounded rim.
pub fn softmin(z: f64, level: f64, width: f64) -> f64 {
    let s = (level - z) / width;
    let softplus = if s > 30.0 { s } else { s.exp().ln_1p() };
    level - width * softplus
}

/// Two fields, point by point.
pub fn mix(a: &[f64], b: &[f64], f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| f(*a, *b)).collect()
}

/// Rms gradient by forward differences, heights and pixel in the same unit.
pub fn gradient(h: &[f64], n: usize) -> f64 {
    let mut sum = 0.0;
    for iy in 0..n - 1 {
        for ix in 0..n - 1 {
            let here = h[iy * n + ix];
            sum += (h[iy * n + ix + 1] - here).powi(2) + (h[(iy + 1) * n + ix] - here).powi(2);
        }
    }
    (sum / ((n - 1) * (n - 1)) as f64).sqrt()
}
