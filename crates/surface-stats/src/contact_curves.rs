//! What a map tells of the part of it that touches: how steep, how curved and how much pressed its highest part is, and
//! how much of it lies flat under which pressure.

use crate::Edges;
use contact_types::{CURVE_LEVELS, CURVE_SHARES, ContactCurves, HeightMap, PartCurve};
use grid_fft::GridFft;

/// Added to shares and their sums of squares, so that a share of nothing has the slope of the map.
const NOTHING: f64 = 1e-4;

/// What is summed over a part, in this order.
const SUMS: usize = 11;
type Sums = [f64; SUMS];

/// The curves of a map; `None` for a flat one. Two transforms, and two passes over the points.
///
/// ```
/// use surface_stats::{Edges, Grid, HeightMap, contact_curves};
/// // A ramp that ends in a plateau: the highest half has no slope.
/// let heights: Vec<f64> = (0..4096).map(|i| ((i % 64) as f64).min(31.5)).collect();
/// let map = HeightMap::new(Grid::new([64, 64], [1.0, 1.0])?, heights)?;
/// let curves = contact_curves(&map, Edges::Open).unwrap();
/// assert!(curves.slope[0] == 1.0 && curves.slope[4] < 0.2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn contact_curves(map: &HeightMap, edges: Edges) -> Option<ContactCurves> {
    let (low, high) = map.range();
    let span = high - low;
    if span <= 0.0 {
        return None;
    }
    let pressures = full_contact(map, span);
    // Heights from the top in steps of the range over 2^32: integers are told apart sooner.
    let down = |height: &f64| ((high - height) / span * f64::from(u32::MAX)) as u32;
    let depths: Vec<u32> = map.heights().iter().map(down).collect();
    let parts = Parts::of(&depths);
    let [
        square,
        slope,
        central,
        pressure,
        squared,
        pressed,
        below,
        curvature,
        of_sum,
        shape,
        level,
    ] = parts.means(&depths, &Local { map, edges, span, pressures: &pressures });
    drop(depths);
    let (mean, mean_central) = (square[0], central[0]);
    if mean <= 0.0 {
        return None;
    }
    let gradient = mean.sqrt();
    let each = |value: &dyn Fn(usize) -> f64| -> PartCurve { std::array::from_fn(value) };
    // Of [sum and product of the curvatures]: the square of their difference is s² - 4p.
    Some(ContactCurves {
        slope: each(&|k| over(central[k], mean_central).sqrt()),
        evenness: each(&|k| over(slope[k], square[k].sqrt())),
        resolved: each(&|k| over(central[k], square[k]).sqrt()),
        pressure: each(&|k| pressure[k] / gradient),
        pressure_evenness: each(&|k| share_of(pressure[k], squared[k].sqrt())),
        pressed: pressed.map(|share| share.clamp(0.0, 1.0)),
        pressed_slope: each(&|k| {
            ((share_of(below[k], mean_central) + NOTHING) / (pressed[k] + NOTHING)).sqrt()
        }),
        curvature_evenness: each(&|k| share_of(curvature[k], of_sum[k].sqrt())),
        curvature_difference: each(&|k| {
            share_of((of_sum[k] - 4.0 * shape[k]).max(0.0).sqrt(), of_sum[k].sqrt())
        }),
        curvature_product: each(&|k| share_of(shape[k], of_sum[k])),
        level: level.map(|share| share.clamp(0.0, 1.0)),
        flattened: quantiles(&pressures).map(|q| q / gradient),
    })
}

/// A ratio, 1 of what is not there.
fn over(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 1.0 }
}

/// A ratio, 0 of what is not there.
fn share_of(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 0.0 }
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

/// What is asked of each point, in the units of [`full_contact`].
struct Local<'a> {
    map: &'a HeightMap,
    edges: Edges,
    span: f64,
    pressures: &'a [f32],
}

impl Local<'_> {
    /// Of every point in its order: squared slope, slope, squared slope by central differences, full-contact pressure, its
    /// square, whether it is positive, squared slope if it is; sum of the principal curvatures, its square, their product; whether
    /// it has no slope.
    fn each(&self, mut take: impl FnMut(usize, Sums)) {
        let Self { map, edges, span, pressures } = *self;
        let [ny, nx] = map.grid().shape();
        let [dy, dx] = map.grid().pixel().map(|d| d / shorter(map));
        for iy in 0..ny {
            let [above, under] = beside(iy, ny, edges);
            for ix in 0..nx {
                let here = map.at(iy, ix);
                let y = [above, under].map(|i| i.map(|i| (map.at(i, ix) - here) / span));
                let x = beside(ix, nx, edges).map(|i| i.map(|i| (map.at(iy, i) - here) / span));
                let square = mean_square(y, dy) + mean_square(x, dx);
                let central = central(y, dy).powi(2) + central(x, dx).powi(2);
                let place = iy * nx + ix;
                let pressure = f64::from(pressures[place]);
                let pressed = f64::from(u8::from(pressure > 0.0));
                let [sum, product] = self.curvatures([iy, ix], [dy, dx]);
                take(
                    place,
                    [
                        square,
                        square.sqrt(),
                        central,
                        pressure,
                        pressure * pressure,
                        pressed,
                        pressed * central,
                        sum,
                        sum * sum,
                        product,
                        f64::from(u8::from(square <= 0.0)),
                    ],
                );
            }
        }
    }

    /// Sum and product of the principal curvatures, positive on a summit.
    fn curvatures(&self, [iy, ix]: [usize; 2], [dy, dx]: [f64; 2]) -> [f64; 2] {
        let Self { map, edges, span, .. } = *self;
        let [ny, nx] = map.grid().shape();
        let [y, x] = [around(iy, ny, edges), around(ix, nx, edges)];
        let at = |i: usize, j: usize| map.at(y[i], x[j]);
        let middle = at(1, 1);
        let along_y = (2.0 * middle - at(0, 1) - at(2, 1)) / span / (dy * dy);
        let along_x = (2.0 * middle - at(1, 0) - at(1, 2)) / span / (dx * dx);
        let mixed = 0.25 * (at(2, 2) + at(0, 0) - at(2, 0) - at(0, 2)) / span / (dy * dx);
        [along_y + along_x, along_y * along_x - mixed * mixed]
    }
}

/// The highest parts of a map: how many points each has, and the depth of the last of them.
struct Parts {
    counts: [usize; CURVE_LEVELS],
    /// From the smallest part to the whole map.
    last: [u32; CURVE_LEVELS],
}

impl Parts {
    fn of(depths: &[u32]) -> Self {
        let n = depths.len();
        let counts: [usize; CURVE_LEVELS] = std::array::from_fn(|k| {
            ((n as f64 * 0.5f64.powf(0.5 * k as f64)).round() as usize).clamp(1, n)
        });
        let mut points = depths.to_vec();
        let mut last = [u32::MAX; CURVE_LEVELS];
        // Each part lies in the one before.
        let mut rest = points.as_mut_slice();
        for (k, &count) in counts.iter().enumerate() {
            last[CURVE_LEVELS - 1 - k] = *rest.select_nth_unstable(count - 1).1;
            rest = &mut rest[..count];
        }
        Self { counts, last }
    }

    /// Means over the parts of what is asked of each point. Of points of one depth, as on a plateau, each part takes its
    /// share of their mean.
    fn means(&self, depths: &[u32], local: &Local<'_>) -> [PartCurve; SUMS] {
        // Points above the last of a part and below that of the next smaller one, and points as deep as it.
        let mut between = [(0usize, [0.0; SUMS]); CURVE_LEVELS];
        let mut level = between;
        local.each(|place, values| {
            let depth = depths[place];
            let part = self.last.partition_point(|l| *l < depth).min(CURVE_LEVELS - 1);
            let class =
                if self.last[part] == depth { &mut level[part] } else { &mut between[part] };
            class.0 += 1;
            for (sum, value) in class.1.iter_mut().zip(values) {
                *sum += value;
            }
        });
        let mut means = [[0.0; CURVE_LEVELS]; SUMS];
        for k in 0..CURVE_LEVELS {
            // The first of the parts that end at this depth holds all points of it.
            let end = self.last.partition_point(|l| *l < self.last[CURVE_LEVELS - 1 - k]);
            let (mut done, mut sums) = (0, [0.0; SUMS]);
            for (count, values) in between[..=end].iter().chain(&level[..end]) {
                done += count;
                sums = std::array::from_fn(|i| sums[i] + values[i]);
            }
            let (count, values) = level[end];
            let share = (self.counts[k] - done) as f64 / count.max(1) as f64;
            for (i, mean) in means.iter_mut().enumerate() {
                mean[k] = (sums[i] + values[i] * share) / self.counts[k] as f64;
            }
        }
        means
    }
}

/// Quantiles of the sizes of the full-contact pressure at the shares (k + ½)/20.
fn quantiles(pressures: &[f32]) -> [f64; CURVE_SHARES] {
    // Numbers that are not negative are in the order of their bits.
    let mut sizes: Vec<u32> = pressures.iter().map(|q| q.abs().to_bits()).collect();
    let last = sizes.len() - 1;
    let size = |bits: u32| f64::from(f32::from_bits(bits));
    let mut quantiles = [0.0; CURVE_SHARES];
    let mut rest = sizes.as_mut_slice();
    for (k, quantile) in quantiles.iter_mut().enumerate().rev() {
        let place = (k as f64 + 0.5) / CURVE_SHARES as f64 * last as f64;
        let (i, t) = (place as usize, place.fract());
        let (below, above, _) = rest.select_nth_unstable((i + 1).min(last));
        let below = below.iter().copied().max().unwrap_or(*above);
        *quantile = size(below) * (1.0 - t) + size(*above) * t;
        rest = &mut rest[..=(i + 1).min(last)];
    }
    quantiles
}

/// The places before and after one of `n`, where there are any.
fn beside(i: usize, n: usize, edges: Edges) -> [Option<usize>; 2] {
    match edges {
        Edges::Periodic => [Some((i + n - 1) % n), Some((i + 1) % n)],
        Edges::Open => [i.checked_sub(1), Some(i + 1).filter(|i| *i < n)],
    }
}

/// A place with those before and after it; at an open edge those of the next place inside, and one place thrice where there are
/// fewer than three.
fn around(i: usize, n: usize, edges: Edges) -> [usize; 3] {
    if n < 3 {
        return [i; 3];
    }
    let i = if edges == Edges::Open { i.clamp(1, n - 2) } else { i };
    [(i + n - 1) % n, i, (i + 1) % n]
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

    fn curves(heights: impl Fn(f64, f64) -> f64, edges: Edges) -> ContactCurves {
        let heights = (0..4096).map(|i| heights(f64::from(i / 64), f64::from(i % 64))).collect();
        let map = HeightMap::new(Grid::new([64, 64], [1.0, 1.0]).unwrap(), heights).unwrap();
        contact_curves(&map, edges).unwrap()
    }

    /// Of one wave of N points, central differences see cos(π/N) of what single ones see.
    #[test]
    fn a_wave_is_resolved_by_its_points() {
        for points in [4.0, 8.0, 32.0] {
            let curves = curves(|_, x| (TAU * x / points).sin(), Edges::Periodic);
            assert!((curves.resolved[0] - (PI / points).cos()).abs() < 1e-6, "{points}");
            assert!((curves.slope[0] - 1.0).abs() < 1e-12);
        }
    }

    /// A ball, a ridge and a saddle, up to the edge: the curvatures of all points are alike.
    #[test]
    fn curvatures_tell_a_ball_from_a_ridge() {
        let shape = |a: f64, b: f64| {
            let c = curves(|y, x| -a * (y - 30.0).powi(2) - b * (x - 31.0).powi(2), Edges::Open);
            [c.curvature_evenness, c.curvature_difference, c.curvature_product].map(|c| c[6])
        };
        let near = |found: [f64; 3], wanted: [f64; 3]| {
            found.iter().zip(wanted).all(|(f, w)| (f - w).abs() < 1e-6)
        };
        assert!(near(shape(1.0, 1.0), [1.0, 0.0, 0.25]));
        assert!(near(shape(0.0, 1.0), [1.0, 1.0, 0.0]));
        assert!(near(shape(-1.0, 3.0), [1.0, 2.0, -0.75]));
    }

    /// A wave is pressed on its upper half, where its full-contact pressure is in proportion to its height.
    #[test]
    fn a_wave_is_pressed_above_its_mean() {
        let curves = curves(|_, x| (TAU * (x + 0.5) / 64.0).cos(), Edges::Periodic);
        assert!((curves.pressed[0] - 0.5).abs() < 1e-12 && curves.pressed[4] > 1.0 - 1e-12);
        // E* π/λ of the amplitude over the rms gradient, √2 π/λ of it; means over the highest half 2/π, squares 1/2.
        assert!((curves.pressure[2] - 2.0 / PI / 2f64.sqrt()).abs() < 2e-3);
        assert!((curves.pressure_evenness[2] - 8f64.sqrt() / PI).abs() < 1e-3);
    }

    /// Points of one height are shared: of a map in two steps, half of it high, every part of the high half is alike, and
    /// the whole is the mean of both.
    #[test]
    fn a_plateau_is_shared() {
        let two_levels = |rough: &dyn Fn(f64) -> f64| {
            curves(|y, x| f64::from(u8::from(y < 32.0)) + rough(x), Edges::Open)
        };
        let rough = two_levels(&|x| 1e-12 * (TAU * x / 4.0).sin());
        assert!(rough.evenness.iter().all(|e| (0.0..=1.0).contains(e)));
        let flat = two_levels(&|_| 0.0);
        for k in 3..CURVE_LEVELS {
            assert!((flat.slope[k] - flat.slope[2]).abs() < 1e-12, "{k}");
        }
    }
}
