//! What can be put beyond the edges of a map that does not repeat.

use contact_types::HeightMap;
use fft_bem_solver::Boundary;
use std::f64::consts::PI;
use surface_stats::clean::mirrored;

/// A way to hand a map that does not repeat to the solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Treatment {
    /// The map again, with the jump.
    Periodic,
    /// The map again, its heights led to their mean over an eighth of the side at each edge.
    Tapered,
    /// The map and its mirror images, four maps in all.
    Mirrored,
    /// A free half-space: no contact and no pressure beyond the edges.
    Free,
}

impl Treatment {
    /// In the order of the tables.
    pub(crate) const ALL: [Self; 4] = [Self::Periodic, Self::Tapered, Self::Mirrored, Self::Free];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Periodic => "periodic as it is",
            Self::Tapered => "tapered",
            Self::Mirrored => "mirrored",
            Self::Free => "free boundary",
        }
    }

    pub(crate) fn boundary(self) -> Boundary {
        if self == Self::Free { Boundary::Free } else { Boundary::Periodic }
    }

    /// Sides of the solver's map over those of the given one.
    pub(crate) fn factor(self) -> usize {
        if self == Self::Mirrored { 2 } else { 1 }
    }

    /// The map the solver gets. Its first quarter is the given map if mirrored.
    pub(crate) fn apply(self, map: &HeightMap) -> HeightMap {
        match self {
            Self::Periodic | Self::Free => map.clone(),
            Self::Tapered => {
                let [ny, nx] = map.grid().shape();
                let mean = map.mean();
                let height = |i: usize| {
                    let window = tukey(i / nx, ny) * tukey(i % nx, nx);
                    mean + window * (map.heights()[i] - mean)
                };
                HeightMap::new(map.grid(), (0..map.grid().len()).map(height).collect())
                    .expect("finite heights stay finite")
            }
            Self::Mirrored => mirrored(map).expect("a crop is far below the most points"),
        }
    }
}

/// Tukey's window: 1 inside, a cosine flank over an eighth of the side at each end.
fn tukey(i: usize, n: usize) -> f64 {
    let from_edge = i.min(n - 1 - i) as f64 + 0.5;
    let flank = n as f64 / 8.0;
    0.5 - 0.5 * (PI * (from_edge / flank).min(1.0)).cos()
}
