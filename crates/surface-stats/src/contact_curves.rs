//! What a map tells of the part of it that touches: how steep its highest part is, and how much of it lies flat
//! under which pressure.

use crate::Edges;
use contact_types::HeightMap;
use grid_fft::GridFft;

/// Levels of the curves over the highest part.
pub const CURVE_LEVELS: usize = 23;
/// Shares of the map of [`ContactCurves::flattened`].
pub const CURVE_SHARES: usize = 20;

/// Curves over the highest parts `2^(-k/2)` of a map, k = 0 to 22, from all of it to the highest 1/2048; and
/// the distribution of the pressure that presses all of it flat. All without units.
///
/// The square of the gradient at a point is the mean over its neighbours along each axis, by single
/// differences; g² is its mean over the map. By central differences, from neighbour to neighbour, it is less where
/// waves or crests are narrower than a few points. The full-contact pressure is E\* |q| h(q)/2 for each wave of
/// the map as it repeats (Johnson, *Contact Mechanics*, 1985, section 13.2), of mean 0.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ContactCurves {
    /// Rms gradient of the part over that of the map, by central differences: 1 at all levels for a Gaussian surface
    /// without end, below 1 where summits are smoother than flanks and valleys.
    pub slope: [f64; CURVE_LEVELS],
    /// Mean gradient over rms gradient, both of the part: (π/4)^½ for an isotropic Gaussian surface, less where
    /// flat places lie between steep ones.
    pub evenness: [f64; CURVE_LEVELS],
    /// Rms gradient by central differences over that by single ones, both of the part: 1 where the points are dense
    /// to its waves, towards 0 where its crests lie between two points.
    pub resolved: [f64; CURVE_LEVELS],
    /// Mean full-contact pressure of the part over E\* g.
    pub pressure: [f64; CURVE_LEVELS],
    /// Quantiles of the size of the full-contact pressure over E\* g, at the shares (k + ½)/20 of the map.
    pub flattened: [f64; CURVE_SHARES],
}

/// A point: height from the top in steps of the range over 2^32, and its place in the map.
type Point = (u32, u32);

impl ContactCurves {
    /// Of a map; `None` for a flat one, and for one of more than 2^32 points. Two transforms and two sorts.
    ///
    /// ```
    /// use surface_stats::{ContactCurves, Edges, Grid, HeightMap};
    /// // A ramp that ends in a plateau: the highest half has no slope.
    /// let heights: Vec<f64> = (0..4096).map(|i| ((i % 64) as f64).min(31.5)).collect();
    /// let map = HeightMap::new(Grid::new([64, 64], [1.0, 1.0])?, heights)?;
    /// let curves = ContactCurves::of(&map, Edges::Open).unwrap();
    /// assert!(curves.slope[0] == 1.0 && curves.slope[4] < 0.2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(map: &HeightMap, edges: Edges) -> Option<Self> {
        let (low, high) = map.range();
        let span = high - low;
        if span <= 0.0 {
            return None;
        }
        let last = u32::try_from(map.grid().len() - 1).ok()?;
        let pressures = full_contact(map, span);
        let down = |height: f64| ((high - height) / span * f64::from(u32::MAX)) as u32;
        let mut points: Vec<Point> = map.heights().iter().map(|&h| down(h)).zip(0..=last).collect();
        points.sort_unstable();
        let squares = Squares::of(map, edges, span);
        let means = over_highest(&points, |place| {
            let [square, across] = squares.at(place);
            [square, square.sqrt(), f64::from(pressures[place]), across]
        });
        drop(points);
        let mean = means[0][0];
        if mean <= 0.0 {
            return None;
        }
        let gradient = mean.sqrt();
        Some(Self {
            slope: means.map(|m| over(m[3], means[0][3]).sqrt()),
            evenness: means.map(|m| over(m[1], m[0].sqrt())),
            resolved: means.map(|m| over(m[3], m[0]).sqrt()),
            pressure: means.map(|m| m[2] / gradient),
            flattened: quantiles(pressures).map(|q| q / gradient),
        })
    }
}

/// A ratio, 1 of what is not there.
fn over(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 1.0 }
}

/// Full-contact pressure over E\* at each point, heights over `span` and lengths over the shorter side of a pixel, so that
/// numbers are about 1 whatever the units; single precision, which is enough for means and quantiles.
fn full_contact(map: &HeightMap, span: f64) -> Vec<f32> {
    let mean = map.mean();
    let mut field: Vec<f64> = map.heights().iter().map(|h| (h - mean) / span).collect();
    let mut fft = GridFft::new(map.grid().shape());
    let mut waves = fft.new_spectrum();
    fft.forward(&field, &mut waves);
    let (nq, short) = (fft.spectrum_shape()[1], shorter(map));
    for (i, wave) in waves.iter_mut().enumerate() {
        *wave *= 0.5 * short * map.grid().wavenumber(i / nq, i % nq);
    }
    fft.inverse(&mut waves, &mut field);
    drop(waves);
    field.into_iter().map(|q| q as f32).collect()
}

fn shorter(map: &HeightMap) -> f64 {
    let [dy, dx] = map.grid().pixel();
    dy.min(dx)
}

/// Squares of the slope at the places of a map, in the units of [`full_contact`].
struct Squares<'a> {
    map: &'a HeightMap,
    edges: Edges,
    span: f64,
    /// Of neighbours in y and in x.
    distance: [f64; 2],
}

impl<'a> Squares<'a> {
    fn of(map: &'a HeightMap, edges: Edges, span: f64) -> Self {
        Self { map, edges, span, distance: map.grid().pixel().map(|d| d / shorter(map)) }
    }

    /// By single and by central differences.
    fn at(&self, place: usize) -> [f64; 2] {
        let Self { map, edges, span, distance } = *self;
        let [ny, nx] = map.grid().shape();
        let (iy, ix) = (place / nx, place % nx);
        let here = map.at(iy, ix);
        let y = beside(iy, ny, edges).map(|i| i.map(|i| (map.at(i, ix) - here) / span));
        let x = beside(ix, nx, edges).map(|i| i.map(|i| (map.at(iy, i) - here) / span));
        let square = mean_square(y, distance[0]) + mean_square(x, distance[1]);
        [square, central(y, distance[0]).powi(2) + central(x, distance[1]).powi(2)]
    }
}

/// Means of what `values` gives at a place (squared slope, slope, pressure, squared slope by central differences) over the
/// highest parts of sorted points.
fn over_highest(points: &[Point], values: impl Fn(usize) -> [f64; 4]) -> [[f64; 4]; CURVE_LEVELS] {
    let n = points.len() as f64;
    let counts: [usize; CURVE_LEVELS] =
        std::array::from_fn(|k| ((n * 0.5f64.powf(0.5 * k as f64)).round() as usize).max(1));
    let mut means = [[0.0; 4]; CURVE_LEVELS];
    let (mut sums, mut done, mut k) = ([0.0; 4], 0, CURVE_LEVELS);
    // Of points of one height, as on a plateau, each part takes its share of their mean.
    for level in points.chunk_by(|a, b| a.0 == b.0) {
        let mut here = [0.0; 4];
        for &(_, place) in level {
            for (sum, value) in here.iter_mut().zip(values(place as usize)) {
                *sum += value;
            }
        }
        while k > 0 && counts[k - 1] <= done + level.len() {
            k -= 1;
            let share = (counts[k] - done) as f64 / level.len() as f64;
            means[k] = std::array::from_fn(|i| (sums[i] + here[i] * share) / counts[k] as f64);
        }
        sums = std::array::from_fn(|i| sums[i] + here[i]);
        done += level.len();
    }
    means
}

/// Quantiles of the sizes of the full-contact pressure at the shares (k + ½)/20.
fn quantiles(mut pressures: Vec<f32>) -> [f64; CURVE_SHARES] {
    pressures.sort_unstable_by(|a, b| a.abs().total_cmp(&b.abs()));
    let last = pressures.len() - 1;
    let size = |i: usize| f64::from(pressures[i.min(last)].abs());
    std::array::from_fn(|k| {
        let place = (k as f64 + 0.5) / CURVE_SHARES as f64 * last as f64;
        let (i, t) = (place as usize, place.fract());
        size(i) * (1.0 - t) + size(i + 1) * t
    })
}

/// The places before and after one of `n`, where there are any.
fn beside(i: usize, n: usize, edges: Edges) -> [Option<usize>; 2] {
    match edges {
        Edges::Periodic => [Some((i + n - 1) % n), Some((i + 1) % n)],
        Edges::Open => [i.checked_sub(1), Some(i + 1).filter(|i| *i < n)],
    }
}

/// Slope from neighbour to neighbour, or to the only one there is.
fn central(rises: [Option<f64>; 2], distance: f64) -> f64 {
    match rises {
        [Some(before), Some(after)] => 0.5 * (after - before) / distance,
        [None, Some(rise)] | [Some(rise), None] => rise / distance,
        [None, None] => 0.0,
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

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;
    use std::f64::consts::{PI, TAU};

    /// Of one wave of N points, central differences see cos(π/N) of what single ones see.
    #[test]
    fn a_wave_is_resolved_by_its_points() {
        for points in [4.0, 8.0, 32.0] {
            let heights = (0..4096).map(|i| (TAU * f64::from(i % 64) / points).sin()).collect();
            let map = HeightMap::new(Grid::new([64, 64], [1.0, 1.0]).unwrap(), heights).unwrap();
            let curves = ContactCurves::of(&map, Edges::Periodic).unwrap();
            assert!((curves.resolved[0] - (PI / points).cos()).abs() < 1e-6, "{points}");
            assert!((curves.slope[0] - 1.0).abs() < 1e-12);
        }
    }
}
