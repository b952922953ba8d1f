//! Which points of the gap carry a flow, and the narrowest place of the best channel.

use crate::gap::Gap;
use contact_types::Axis;

/// The narrowest place of the channel whose lowest gap is highest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Bottleneck {
    /// Row and column of its point.
    pub place: [usize; 2],
    /// Gap there (m): the lowest along the channel.
    pub height: f64,
    /// Open points in a row through it, along rows, columns and diagonals: the fewest.
    pub width: usize,
}

/// Clusters of points; each knows which ends it touches.
struct Clusters {
    parent: Vec<usize>,
    ends: Vec<[bool; 2]>,
}

impl Clusters {
    fn root(&mut self, mut i: usize) -> usize {
        while self.parent[i] != i {
            self.parent[i] = self.parent[self.parent[i]];
            i = self.parent[i];
        }
        i
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        // Towards the lower number: with halved paths that is fast enough on a grid.
        let (low, high) = (a.min(b), a.max(b));
        self.parent[high] = low;
        let [one, two] = self.ends[high];
        self.ends[low][0] |= one;
        self.ends[low][1] |= two;
    }
}

impl Gap<'_> {
    /// The channels along an axis: true for each point of a cluster of open points (four
    /// neighbours) that reaches both ends; and the bottleneck. `None` where there is none.
    pub(crate) fn channel(&self, axis: Axis) -> Option<(Vec<bool>, Bottleneck)> {
        let nx = self.grid.shape()[1];
        let mut order: Vec<usize> =
            (0..self.heights.len()).filter(|&i| self.heights[i] > 0.0).collect();
        order.sort_unstable_by(|a, b| self.heights[*b].total_cmp(&self.heights[*a]).then(a.cmp(b)));
        let mut clusters = Clusters {
            parent: (0..self.heights.len()).collect(),
            ends: (0..self.heights.len()).map(|i| self.at_ends(i, axis)).collect(),
        };
        // The deepest points first: the one that closes a way between the ends is the bottleneck.
        let mut filled = vec![false; self.heights.len()];
        let mut last = None;
        for &i in &order {
            filled[i] = true;
            for next in self.neighbours(i, axis).into_iter().flatten() {
                if filled[next] {
                    clusters.join(i, next);
                }
            }
            if last.is_none() {
                let root = clusters.root(i);
                last = (clusters.ends[root] == [true; 2]).then_some(i);
            }
        }
        let last = last?;
        for &i in &order {
            let root = clusters.root(i);
            filled[i] = clusters.ends[root] == [true; 2];
        }
        let (place, height) = ([last / nx, last % nx], self.heights[last]);
        let bottleneck = Bottleneck { place, height, width: self.width(place, axis) };
        Some((filled, bottleneck))
    }

    /// Whether a point lies at the inlet, and at the outlet.
    pub(crate) fn at_ends(&self, i: usize, axis: Axis) -> [bool; 2] {
        let [ny, nx] = self.grid.shape();
        let (place, last) = match axis {
            Axis::X => (i % nx, nx - 1),
            Axis::Y => (i / nx, ny - 1),
        };
        [place == 0, place == last]
    }

    /// The neighbours along x and y before and after a point; the map goes on at its other edge across the flow.
    pub(crate) fn neighbours(&self, i: usize, axis: Axis) -> [Option<usize>; 4] {
        let nx = self.grid.shape()[1];
        [[0, -1], [0, 1], [-1, 0], [1, 0]]
            .map(|step| self.step([i / nx, i % nx], step, axis).map(|[y, x]| y * nx + x))
    }

    /// One step on the map, `None` over an edge that is an end or a wall.
    fn step(&self, from: [usize; 2], step: [isize; 2], axis: Axis) -> Option<[usize; 2]> {
        let shape = self.grid.shape();
        let along = |k: usize| {
            let (n, ends) = (shape[k], (k == 1) == (axis == Axis::X));
            match from[k].checked_add_signed(step[k]).filter(|to| *to < n) {
                None if ends || !self.repeats || n < 3 => None,
                None => Some(if step[k] < 0 { n - 1 } else { 0 }),
                inside => inside,
            }
        };
        Some([along(0)?, along(1)?])
    }

    fn width(&self, place: [usize; 2], axis: Axis) -> usize {
        let [ny, nx] = self.grid.shape();
        let run = |step: [isize; 2]| {
            let one_way = |step: [isize; 2]| {
                let mut here = place;
                (0..ny.max(nx))
                    .take_while(|_| match self.step(here, step, axis) {
                        Some(next) if self.heights[next[0] * nx + next[1]] > 0.0 => {
                            here = next;
                            true
                        }
                        _ => false,
                    })
                    .count()
            };
            1 + one_way(step) + one_way(step.map(|s| -s))
        };
        let fewest = [[0, 1], [1, 0], [1, 1], [1, -1]].map(run).into_iter().min();
        fewest.unwrap_or(1).min(ny.min(nx))
    }
}
