//! Separate contact spots of a solution, and how pressure, gap and spots are distributed over a map.

use contact_types::Grid;
use grid_fft::parallel::{join, map};
use serde::Serialize;

/// Classes of pressure and of gap.
const CLASSES: usize = 40;
/// Points that a thread counts at a time.
const BLOCK: usize = 1 << 14;

/// Distributions of one contact.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Distributions {
    /// Of the pressure.
    pub pressure: PressureHistogram,
    /// Of the gap outside the contact; `None` without a gap field, or where all touches.
    pub gap: Option<GapDistribution>,
    /// Of the spots.
    pub spots: SpotDistribution,
}

/// Density of the pressure over the nominal area: a weight at zero, where nothing touches, and a density
/// beyond.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PressureHistogram {
    /// Share of the nominal area without contact: the weight at zero pressure (-).
    pub apart: f64,
    /// Mean over the contact (Pa).
    pub mean: f64,
    /// Edges of the classes, rising from 0 (Pa); one more than there are densities.
    pub edges: Vec<f64>,
    /// Share of the nominal area per pressure in each class (1/Pa); with the weight at zero its integral is 1.
    pub density: Vec<f64>,
    /// Share of the nominal area with more pressure than each edge (-).
    pub above: Vec<f64>,
    /// Exponent s of a density that begins as `p^s`, from the shares of the contact below 0.1 and
    /// 0.3 of the mean pressure; `None` below 1000 touching points or with none below 0.1. Hertz's and Persson's
    /// theory have 1.
    pub exponent_at_zero: Option<f64>,
}

/// Share of the nominal area with less gap than each value; what touches has none.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct GapDistribution {
    /// Mean over what does not touch (m).
    pub mean: f64,
    /// Gaps (m), rising, spaced evenly in the logarithm up to the largest.
    pub gaps: Vec<f64>,
    /// Share of the nominal area below each, contact included (-).
    pub below: Vec<f64>,
}

/// Spots by their area.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SpotDistribution {
    /// How many there are.
    pub count: usize,
    /// Median area (m²), by counted points; listed with the spots of a study.
    #[serde(skip)]
    pub median_area: f64,
    /// Largest area (m²), likewise.
    #[serde(skip)]
    pub largest_area: f64,
    /// Areas (m²), rising by factors of two from one point.
    pub areas: Vec<f64>,
    /// Number of spots of at least each area.
    pub count_at_least: Vec<usize>,
    /// Their share of the real contact area (-).
    pub area_share: Vec<f64>,
    /// Their share of the load (-).
    pub load_share: Vec<f64>,
}

impl Distributions {
    /// Of a pressure field (Pa), the gap field on the same points (m; empty if there is none) and the list of spots;
    /// `None` if nothing touches.
    pub fn of(pressure: &[f64], gap: &[f64], spots: &[Spot]) -> Option<Self> {
        let (histogram, gap) =
            join(|| PressureHistogram::of(pressure), || GapDistribution::of(pressure, gap));
        Some(Self { pressure: histogram?, gap, spots: SpotDistribution::of(spots)? })
    }
}

impl PressureHistogram {
    /// Of a field (Pa); `None` if nothing touches.
    pub(crate) fn of(pressure: &[f64]) -> Option<Self> {
        let all = pressure.len() as f64;
        let touching: Vec<f64> = pressure.iter().copied().filter(|p| *p > 0.0).collect();
        let (count, sum) = (touching.len(), touching.iter().sum::<f64>());
        let highest = touching.iter().copied().fold(0.0, f64::max);
        if count == 0 || !highest.is_finite() {
            return None;
        }
        let width = highest / CLASSES as f64;
        let mut counts = [0_usize; CLASSES];
        for p in &touching {
            counts[((p / width) as usize).min(CLASSES - 1)] += 1;
        }
        let mut above = vec![count as f64 / all];
        let mut left = count;
        for n in counts {
            left -= n;
            above.push(left as f64 / all);
        }
        let mean = sum / count as f64;
        // A density p^s has below p a share that goes as p^(s + 1).
        let [few, more] =
            [0.1, 0.3].map(|part| touching.iter().filter(|p| **p < part * mean).count());
        let enough = count >= 1000 && few > 0;
        Some(Self {
            apart: (pressure.len() - count) as f64 / all,
            mean,
            edges: (0..=CLASSES).map(|i| i as f64 * width).collect(),
            density: counts.iter().map(|&n| n as f64 / all / width).collect(),
            above,
            exponent_at_zero: enough.then(|| (more as f64 / few as f64).ln() / 3.0_f64.ln() - 1.0),
        })
    }
}

impl GapDistribution {
    fn of(pressure: &[f64], gap: &[f64]) -> Option<Self> {
        if gap.len() != pressure.len() {
            return None;
        }
        let blocks: Vec<_> = pressure.chunks(BLOCK).zip(gap.chunks(BLOCK)).collect();
        let sums = map(&blocks, |block| {
            apart(block)
                .fold((0, 0.0, 0.0), |(n, sum, m): (usize, f64, f64), g| (n + 1, sum + g, m.max(g)))
        });
        let add =
            |(n, sum, m): (usize, f64, f64), s: (usize, f64, f64)| (n + s.0, sum + s.1, m.max(s.2));
        let (count, sum, widest) = sums.into_iter().fold((0, 0.0, 0.0), add);
        if count == 0 || widest <= 0.0 {
            return None;
        }
        // Four decades below the largest: what lies below them is in the first class.
        let gaps: Vec<f64> = (1..=CLASSES)
            .map(|i| widest * 10f64.powf(4.0 * (i as f64 / CLASSES as f64 - 1.0)))
            .collect();
        let counts = map(&blocks, |block| {
            let mut counts = [0_usize; CLASSES];
            for g in apart(block) {
                counts[gaps.partition_point(|limit| *limit < g).min(CLASSES - 1)] += 1;
            }
            counts
        });
        let mut closer = gap.len() - count;
        let below = (0..CLASSES).map(|class| {
            closer += counts.iter().map(|counts| counts[class]).sum::<usize>();
            closer as f64 / gap.len() as f64
        });
        Some(Self { mean: sum / count as f64, below: below.collect(), gaps })
    }
}

/// The gaps (m) of a block of pressures and gaps where it carries no pressure.
fn apart((pressure, gap): &(&[f64], &[f64])) -> impl Iterator<Item = f64> {
    pressure.iter().zip(*gap).filter(|(p, _)| **p <= 0.0).map(|(_, g)| g.max(0.0))
}

impl SpotDistribution {
    /// Of a list, largest first; `None` if it is empty.
    fn of(spots: &[Spot]) -> Option<Self> {
        let largest = spots.first()?.points;
        let point = spots[0].area / spots[0].points as f64;
        let sizes: Vec<usize> = std::iter::successors(Some(1_usize), |n| n.checked_mul(2))
            .take_while(|n| *n <= largest)
            .collect();
        let from = |size: usize| spots.iter().filter(move |s| s.points >= size);
        let share = |of: fn(&Spot) -> f64| -> Vec<f64> {
            let all: f64 = spots.iter().map(of).sum();
            sizes.iter().map(|&n| from(n).map(of).sum::<f64>() / all).collect()
        };
        Some(Self {
            count: spots.len(),
            // Largest first: the upper one of two in the middle.
            median_area: spots[spots.len() - 1 - spots.len() / 2].area,
            largest_area: spots[0].area,
            areas: sizes.iter().map(|&n| n as f64 * point).collect(),
            count_at_least: sizes.iter().map(|&n| from(n).count()).collect(),
            area_share: share(|s| s.area),
            load_share: share(|s| s.load),
        })
    }
}

/// One contact spot; of a grid of one row, the cross-section of ridges, area and load are those of 1 m of their length.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Spot {
    /// Area by counted points (m²).
    pub area: f64,
    /// Force it carries (N).
    pub load: f64,
    /// Mean position `[y, x]` of its points, from the centre of the first point (m). Of a spot that runs
    /// around a periodic map it has no meaning.
    pub centroid: [f64; 2],
    /// Load over area (Pa).
    pub mean_pressure: f64,
    /// Highest pressure of a point (Pa).
    pub max_pressure: f64,
    /// Its points.
    pub points: usize,
}

/// Every contact spot of a pressure field (Pa), largest first, and of each point the number of its spot in the order of
/// their first points, from 1; 0 where nothing touches. Spots are sets of touching points connected over edges or
/// corners; across the seam of the map too where it `repeats`: a spot at the edge of mirror images joins its own image, not
/// what lies at the other edge, and counts by its part on the map. Empty if nothing touches or the field is
/// not of this grid.
pub fn contact_spots(pressure: &[f64], grid: Grid, repeats: bool) -> (Vec<Spot>, Vec<i32>) {
    let [ny, nx] = grid.shape();
    if pressure.len() != grid.len() {
        return (Vec::new(), Vec::new());
    }
    let [dy, dx] = grid.pixel();
    let ly = if ny == 1 { 1.0 } else { dy };
    let mut labels = vec![0; pressure.len()];
    let (mut spots, mut label): (Vec<Spot>, _) = (Vec::new(), 0);
    // Points with the way to them from the first one, which does not jump at the seam.
    let mut front: Vec<(usize, [isize; 2])> = Vec::new();
    for start in 0..pressure.len() {
        let is_new = |labels: &[i32], i: usize| labels[i] == 0 && pressure[i] > 0.0;
        if !is_new(&labels, start) {
            continue;
        }
        label += 1;
        labels[start] = label;
        front.push((start, [0, 0]));
        let (mut points, mut sum, mut highest, mut way) = (0_usize, 0.0, 0.0_f64, [0.0; 2]);
        while let Some((i, [wy, wx])) = front.pop() {
            points += 1;
            sum += pressure[i];
            highest = highest.max(pressure[i]);
            way = [way[0] + wy as f64, way[1] + wx as f64];
            let (iy, ix) = (i / nx, i % nx);
            let columns = beside(ix, nx);
            for (y, ay) in beside(iy, ny) {
                for (x, ax) in columns {
                    let crosses = y.abs_diff(iy) > 1 || x.abs_diff(ix) > 1;
                    if crosses && !repeats {
                        continue;
                    }
                    let j = y * nx + x;
                    if is_new(&labels, j) {
                        labels[j] = label;
                        front.push((j, [wy + ay, wx + ax]));
                    }
                }
            }
        }
        let place = |first: usize, way: f64, n: usize, pixel: f64| {
            (first as f64 + way / points as f64).rem_euclid(n as f64) * pixel
        };
        spots.push(Spot {
            area: points as f64 * ly * dx,
            load: sum * ly * dx,
            centroid: [place(start / nx, way[0], ny, dy), place(start % nx, way[1], nx, dx)],
            mean_pressure: sum / points as f64,
            max_pressure: highest,
            points,
        });
    }
    spots.sort_by_key(|spot| std::cmp::Reverse(spot.points));
    (spots, labels)
}

/// Before, here and after on a ring of `n`, with the way there.
fn beside(i: usize, n: usize) -> [(usize, isize); 3] {
    let before = if i == 0 { n - 1 } else { i - 1 };
    let after = if i + 1 == n { 0 } else { i + 1 };
    [(before, -1), (i, 0), (after, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// p = p0 √(1 − r²/a²): the share of the contact with less pressure than p is (p/p0)².
    #[test]
    fn hertz_has_a_density_that_rises_linearly() {
        let (n, radius, highest) = (801, 300.0, 2e9);
        let pressure: Vec<f64> = (0..n * n)
            .map(|i| {
                let [y, x] = [i / n, i % n].map(|k| (k as f64 - 400.0) / radius);
                highest * (1.0 - x * x - y * y).max(0.0).sqrt()
            })
            .collect();
        let grid = Grid::new([n, n], [1e-6; 2]).unwrap();
        let (spots, _) = contact_spots(&pressure, grid, false);
        let found = Distributions::of(&pressure, &[], &spots).unwrap();
        let share = std::f64::consts::PI * radius * radius / (n * n) as f64;
        let p = &found.pressure;
        assert!((p.apart - (1.0 - share)).abs() < 1e-3 * share);
        assert!((p.mean / (2.0 / 3.0 * highest) - 1.0).abs() < 1e-3);
        for (i, density) in p.density.iter().enumerate() {
            let middle = f64::midpoint(p.edges[i], p.edges[i + 1]);
            let exact = share * 2.0 * middle / (highest * highest);
            // Few points lie in the first classes, at the edge of a circle on a lattice.
            assert!(i < 8 || (density / exact - 1.0).abs() < 0.08, "{i}: {density} and {exact}");
            let above = share * (1.0 - (p.edges[i] / highest).powi(2));
            assert!((p.above[i] - above).abs() < 1e-3 * share, "{i}");
        }
        assert!((p.exponent_at_zero.unwrap() - 1.0).abs() < 0.1, "{:?}", p.exponent_at_zero);
        assert_eq!((found.spots.count, found.gap.is_none()), (1, true));
        assert!(found.spots.area_share.iter().all(|s| (s - 1.0).abs() < 1e-12));
    }

    #[test]
    fn weights_densities_and_shares_are_whole() {
        let grid = Grid::new([4, 5], [1.0, 1.0]).unwrap();
        let mut pressure = vec![0.0; 20];
        for (i, p) in [(0, 1.0), (1, 3.0), (12, 4.0)] {
            pressure[i] = p;
        }
        let gap: Vec<f64> = pressure.iter().map(|p| if *p > 0.0 { 0.0 } else { 1e-6 }).collect();
        let (spots, _) = contact_spots(&pressure, grid, true);
        let found = Distributions::of(&pressure, &gap, &spots).unwrap();
        let p = &found.pressure;
        let integral: f64 = p.density.iter().map(|d| d * (p.edges[1] - p.edges[0])).sum();
        assert!((integral + p.apart - 1.0).abs() < 1e-12 && (p.apart - 0.85).abs() < 1e-12);
        assert!((p.above[0] - 0.15).abs() < 1e-12 && p.above[CLASSES] == 0.0);
        let spots = &found.spots;
        assert_eq!((&spots.areas[..], &spots.count_at_least[..]), (&[1.0, 2.0][..], &[2, 1][..]));
        assert_eq!(spots.load_share, [1.0, 0.5]);
        let [median, largest] = [spots.median_area, spots.largest_area];
        assert!((median - 2.0).abs() < 1e-12 && (largest - 2.0).abs() < 1e-12);
        let gap = found.gap.unwrap();
        let [lowest, highest] = [0, CLASSES - 1].map(|i| gap.below[i]);
        assert!((gap.mean - 1e-6).abs() < 1e-18);
        assert!((highest - 1.0).abs() < 1e-12 && (lowest - 0.15).abs() < 1e-12);
        assert!(Distributions::of(&[0.0; 20], &[], &[]).is_none());
    }

    #[test]
    fn corners_and_the_seam_connect() {
        let map = [
            "x....x", // joined across the seam
            "......", //
            "..x...", // joined over a corner
            "...x..", //
            "......", //
            ".....x", // joined with the first row, across a corner of the map
        ];
        let pressure: Vec<f64> =
            map.concat().chars().map(|c| f64::from(u8::from(c == 'x'))).collect();
        let grid = Grid::new([6, 6], [2.0, 1.0]).unwrap();
        let of = |pressure: &[f64], repeats| contact_spots(pressure, grid, repeats).0;
        let points = |list: &[Spot]| list.iter().map(|s| s.points).collect::<Vec<_>>();
        assert_eq!(points(&of(&pressure, true)), [3, 2]);
        assert_eq!(points(&of(&pressure, false)), [2, 1, 1, 1]);
        let (list, labels) = contact_spots(&pressure, grid, true);
        assert_eq!([0, 1, 5, 14, 21, 35].map(|i| labels[i]), [1, 0, 1, 2, 2, 1]);
        let sorted = list.windows(2).all(|w| w[0].points >= w[1].points);
        assert!(sorted && list.iter().all(|s| (s.load / s.area - 1.0).abs() < 1e-12));
        // Three points around the corner of the map: (0, 0), (0, 5), (5, 5) in rows and columns.
        let corner = list.iter().find(|s| s.centroid[1] > 3.0).unwrap();
        let [y, x] = corner.centroid;
        assert!(
            (y - 2.0 * (6.0 - 1.0 / 3.0)).abs() < 1e-12 && (x - (6.0 - 2.0 / 3.0)).abs() < 1e-12,
            "{y} {x}"
        );
        assert!(of(&[0.0; 36], true).is_empty() && of(&[1.0; 35], true).is_empty());
    }
}
