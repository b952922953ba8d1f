//! How steep the highest part of a map is.

use crate::Edges;
use contact_types::HeightMap;

/// Levels of [`slope_curve`].
pub const SLOPE_LEVELS: usize = 23;

/// Rms gradient over the highest part of a map over that of all, for the parts `2^(-k/2)`,
/// k = 0 to 22: from all of it (1) to the highest 1/2048. `None` for a flat map.
///
/// The square of the gradient at a point is the mean over its neighbours along each axis, by single
/// differences. It says how unlike the part that touches is to the rest: 1 at all levels for a
/// Gaussian surface without end, below 1 where summits are smoother than flanks and valleys.
///
/// ```
/// use surface_stats::{Edges, Grid, HeightMap, slope_curve};
/// // A ramp that ends in a plateau: the highest half has no slope.
/// let heights: Vec<f64> = (0..4096).map(|i| ((i % 64) as f64).min(31.5)).collect();
/// let map = HeightMap::new(Grid::new([64, 64], [1.0, 1.0])?, heights)?;
/// let curve = slope_curve(&map, Edges::Open).unwrap();
/// assert!(curve[0] == 1.0 && curve[4] < 0.2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn slope_curve(map: &HeightMap, edges: Edges) -> Option<[f64; SLOPE_LEVELS]> {
    let ([ny, nx], pixel) = (map.grid().shape(), map.grid().pixel());
    let (low, high) = map.range();
    let span = high - low;
    if span <= 0.0 {
        return None;
    }
    // Of numbers about 1, whatever the units.
    let pixel = pixel.map(|side| side / pixel[0].min(pixel[1]));
    // Height from the top in steps of the range over 2^32, and the square of the slope, in one number: half
    // the memory of two doubles, and points of one height in one order.
    let steps = f64::from(u32::MAX);
    let mut points: Vec<u64> = Vec::with_capacity(ny * nx);
    for iy in 0..ny {
        for ix in 0..nx {
            let here = map.at(iy, ix);
            let y = beside(iy, ny, edges).map(|i| i.map(|i| (map.at(i, ix) - here) / span));
            let x = beside(ix, nx, edges).map(|i| i.map(|i| (map.at(iy, i) - here) / span));
            let square = mean_square(y, pixel[0]) + mean_square(x, pixel[1]);
            let down = ((high - here) / span * steps) as u32;
            points.push(u64::from(down) << 32 | u64::from((square as f32).to_bits()));
        }
    }
    points.sort_unstable();
    let n = points.len();
    let counts: [usize; SLOPE_LEVELS] =
        std::array::from_fn(|k| ((n as f64 * 0.5f64.powf(0.5 * k as f64)).round() as usize).max(1));
    let mut sums = [0.0; SLOPE_LEVELS];
    let (mut sum, mut done, mut k) = (0.0, 0, SLOPE_LEVELS);
    // Of points of one height, as on a plateau, each part takes its share of their mean.
    for level in points.chunk_by(|a, b| a >> 32 == b >> 32) {
        let square = |point: &u64| f64::from(f32::from_bits(*point as u32));
        let here: f64 = level.iter().map(square).sum();
        while k > 0 && counts[k - 1] <= done + level.len() {
            k -= 1;
            sums[k] = sum + here * (counts[k] - done) as f64 / level.len() as f64;
        }
        (sum, done) = (sum + here, done + level.len());
    }
    let mean = sums[0] / n as f64;
    if mean <= 0.0 {
        return None;
    }
    let mut highest = [1.0; SLOPE_LEVELS];
    for k in 1..SLOPE_LEVELS {
        highest[k] = (sums[k] / counts[k] as f64 / mean).sqrt();
    }
    Some(highest)
}

/// The places before and after one of `n`, where there are any.
fn beside(i: usize, n: usize, edges: Edges) -> [Option<usize>; 2] {
    match edges {
        Edges::Periodic => [Some((i + n - 1) % n), Some((i + 1) % n)],
        Edges::Open => [i.checked_sub(1), Some(i + 1).filter(|i| *i < n)],
    }
}

/// Mean of the squared slopes to neighbours at a distance.
fn mean_square(rises: [Option<f64>; 2], distance: f64) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for rise in rises.into_iter().flatten() {
        sum += (rise / distance).powi(2);
        count += 1.0;
    }
    if count > 0.0 { sum / count } else { 0.0 }
}
