//! Spikes: single points far from their neighbours, and how much of the load they carry.

use crate::{Origin, PairOrigin};
use contact_types::HeightMap;
use serde::Serialize;
use surface_stats::clean::{Outliers, Record, find_outliers};

/// Robust standard deviations beyond which a point is a spike; the advice names the same number.
pub const SPIKE_THRESHOLD: f64 = 8.0;

/// Sweeps over the points that replace spikes; these are few and stand alone or in small groups.
const SWEEPS: usize = 200;

/// Spikes of a map.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Spikes {
    /// Their indices in the map, rising.
    pub indices: Vec<usize>,
    /// Largest distance of one from its neighbours (m).
    pub largest: f64,
    /// Points of the map.
    pub points: usize,
    /// Spikes that cleaning took out before, at this threshold or a lower one.
    pub taken: usize,
}

impl Spikes {
    /// Those of `map`; none in a map whose heights cannot be compared.
    pub(crate) fn of(map: &HeightMap) -> Self {
        let found = find_outliers(map.grid(), map.heights(), SPIKE_THRESHOLD);
        let Ok(Outliers { indices, largest, .. }) = found else { return Self::default() };
        Self { indices, largest, points: map.heights().len(), taken: 0 }
    }

    /// Those that are left of `map` after these steps of cleaning; of a sum of two bodies, after those of either.
    pub fn left(map: &HeightMap, cleaned: &[Record], pair: Option<&PairOrigin>) -> Self {
        let taken = |record: &Record| match record {
            Record::Outliers { threshold, count, .. } if *threshold <= SPIKE_THRESHOLD => *count,
            _ => 0,
        };
        let bodies = pair.into_iter().flat_map(|pair| &*pair.bodies).flat_map(Origin::cleaned);
        Self { taken: cleaned.iter().chain(bodies).map(taken).sum(), ..Self::of(map) }
    }

    /// Share of the load that they carry; `None` for a pressure that is not on the points of the map, or without load.
    pub fn share(&self, pressure: &[f64]) -> Option<f64> {
        if pressure.len() != self.points {
            return None;
        }
        let all: f64 = pressure.iter().sum();
        let theirs: f64 = self.indices.iter().map(|&i| pressure[i]).sum();
        (all > 0.0).then(|| theirs / all)
    }

    /// The map with a smooth surface through the neighbours in their place.
    pub(crate) fn without(&self, map: &HeightMap) -> Option<HeightMap> {
        let [ny, nx] = map.grid().shape();
        let mut heights = map.heights().to_vec();
        let around = |i: usize| {
            let (y, x) = (i / nx, i % nx);
            [
                (y > 0).then(|| i - nx),
                (y + 1 < ny).then(|| i + nx),
                (x > 0).then(|| i - 1),
                (x + 1 < nx).then(|| i + 1),
            ]
        };
        for _ in 0..SWEEPS {
            for &i in &self.indices {
                let near: Vec<f64> = around(i).into_iter().flatten().map(|k| heights[k]).collect();
                heights[i] = near.iter().sum::<f64>() / near.len().max(1) as f64;
            }
        }
        HeightMap::new(map.grid(), heights).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;

    /// Two spikes beside each other on a tilted wavy map.
    #[test]
    fn spikes_are_found_weighed_and_replaced() {
        let grid = Grid::new([40, 40], [1e-6, 1e-6]).unwrap();
        let wave = |i: usize| 1e-8 * ((i / 40) as f64 * 0.7).sin() * ((i % 40) as f64 * 0.9).cos();
        let smooth: Vec<f64> = (0..1600).map(|i| wave(i) + 1e-9 * (i % 40) as f64).collect();
        let mut heights = smooth.clone();
        heights[810] += 5e-6;
        heights[811] += 4e-6;
        let map = HeightMap::new(grid, heights).unwrap();
        let spikes = Spikes::of(&map);
        assert_eq!(spikes.indices, [810, 811]);
        // Taken out at a threshold beyond the one here, others may be left to take.
        let taken =
            |threshold, count| Record::Outliers { threshold, count, limit: 0.0, largest: 0.0 };
        let cleaned = [taken(8.0, 5), taken(4.0, 3), taken(12.0, 7)];
        assert_eq!(Spikes::left(&map, &cleaned, None), Spikes { taken: 8, ..spikes.clone() });
        let mut pressure = vec![0.0; 1600];
        (pressure[810], pressure[3]) = (3.0, 1.0);
        assert_eq!(spikes.share(&pressure), Some(0.75));
        assert_eq!(spikes.share(&[1.0]), None);
        let flat = spikes.without(&map).unwrap();
        for (a, b) in flat.heights().iter().zip(&smooth) {
            assert!((a - b).abs() < 6e-9, "{a:e} {b:e}");
        }
    }
}
