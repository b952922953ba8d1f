//! What the ensembles of the studies are drawn with: numbers that cover their ranges evenly, and
//! heights bent out of the Gaussian.

use contact_types::HeightMap;
use std::error::Error;
use surface_stats::Edges;
use surface_stats::clean::resample;

/// Digits of `i` in `base`, mirrored at the point: a number between 0 and 1. Any first part of
/// the sequence covers that range evenly.
pub fn van_der_corput(mut i: usize, base: usize) -> f64 {
    let (mut value, mut place) = (0.0, 1.0 / base as f64);
    while i > 0 {
        value += (i % base) as f64 * place;
        i /= base;
        place /= base as f64;
    }
    value
}

/// From `low` at `t` = 0 to `high` at `t` = 1, evenly in the logarithm.
pub fn log_between(low: f64, high: f64, t: f64) -> f64 {
    low * (high / low).powf(t)
}

/// Heights through sinh((asinh z + bend) / tails) (Jones & Pewsey 2009), z in units of their rms:
/// a positive bend gives positive skewness, `tails` below 1 heavier tails.
///
/// # Errors
/// A map that is not finite, or one that cannot be resampled.
pub fn bent(
    map: &HeightMap,
    bend: f64,
    tails: f64,
    cutoff: f64,
) -> Result<HeightMap, Box<dyn Error>> {
    bent_by(map, |z| ((z.asinh() + bend) / tails).sinh(), cutoff)
}

/// Heights, in units of their rms, through `change`. Then without the waves shorter than `cutoff`
/// pixels that this makes.
///
/// # Errors
/// A map that is not finite, or one that cannot be resampled.
pub fn bent_by(
    map: &HeightMap,
    change: impl Fn(f64) -> f64,
    cutoff: f64,
) -> Result<HeightMap, Box<dyn Error>> {
    let grid = map.grid();
    let n = grid.len() as f64;
    let rms = (map.heights().iter().map(|h| h * h).sum::<f64>() / n).sqrt();
    let heights = map.heights().iter().map(|h| rms * change(h / rms)).collect();
    let bent = HeightMap::new(grid, heights)?;
    let kept = grid.shape().map(|points| ((2.0 * points as f64 / cutoff) as usize).min(points));
    Ok(resample(&resample(&bent, kept, Edges::Periodic)?, grid.shape(), Edges::Periodic)?)
}
