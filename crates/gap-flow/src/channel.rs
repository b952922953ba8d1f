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
    /// Open points in a row through it from wall to wall, along rows, columns and diagonals: the fewest.
    pub width: usize,
}

/// Clusters of points, and on which copy of the map along the flow each point lies.
struct Clusters {
    parent: Vec<usize>,
    /// Copies of the map from the parent.
    apart: Vec<isize>,
    /// Whether a cluster meets itself on another copy.
    carries: Vec<bool>,
}

impl Clusters {
    /// The root of a point, and how many copies the point is from it.
    fn root(&mut self, mut i: usize) -> (usize, isize) {
        let mut apart = 0;
        while self.parent[i] != i {
            let up = self.parent[i];
            self.apart[i] += self.apart[up];
            self.parent[i] = self.parent[up];
            apart += self.apart[i];
            i = self.parent[i];
        }
        (i, apart)
    }

    /// Joins neighbours, the second so many copies from the first.
    fn join(&mut self, first: usize, second: usize, copies: isize) {
        let ((a, from), (b, to)) = (self.root(first), self.root(second));
        let apart = from + copies - to;
        // Towards the lower number: with halved paths that is fast enough on a grid.
        let (low, high) = (a.min(b), a.max(b));
        self.carries[low] |= self.carries[high] || (a == b && apart != 0);
        self.parent[high] = low;
        self.apart[high] = apart * b.cmp(&a) as isize;
    }
}

impl Gap<'_> {
    /// The channels along an axis: clusters of open points (four neighbours) that meet themselves on the next copy of the map. Inlet
    /// and outlet of a map with ends are one point more, the last. For each point of a channel its deepest; and the bottleneck.
    /// `None` where there is none.
    pub(crate) fn channel(&self, axis: Axis) -> Option<(Vec<Option<usize>>, Bottleneck)> {
        let (nx, beyond) = (self.grid.shape()[1], self.heights.len());
        let mut order: Vec<usize> = (0..beyond).filter(|&i| self.heights[i] > 0.0).collect();
        order.sort_unstable_by(|a, b| self.heights[*b].total_cmp(&self.heights[*a]).then(a.cmp(b)));
        order.insert(0, beyond);
        let mut rank = vec![usize::MAX; beyond + 1];
        order.iter().enumerate().for_each(|(k, &i)| rank[i] = k);
        let n = order.len();
        let mut clusters =
            Clusters { parent: (0..n).collect(), apart: vec![0; n], carries: vec![false; n] };
        // The deepest points first: the one that closes a way to the next copy is the bottleneck.
        let mut last = None;
        for (k, &i) in order.iter().enumerate().skip(1) {
            for (next, copies) in self.neighbours(i, axis).into_iter().flatten() {
                if rank[next] < k {
                    clusters.join(k, rank[next], copies);
                }
            }
            let (root, _) = clusters.root(k);
            last = last.or_else(|| clusters.carries[root].then_some(i));
        }
        let last = last?;
        let mut deepest = vec![None; beyond + 1];
        for (k, &i) in order.iter().enumerate() {
            let (root, _) = clusters.root(k);
            deepest[i] = clusters.carries[root].then_some(order[root]);
        }
        let place = [last / nx, last % nx];
        let width = self.width(last, axis);
        Some((deepest, Bottleneck { place, height: self.heights[last], width }))
    }

    /// The neighbours along x and y before and after a point, each as [`step`](Self::step) has it.
    pub(crate) fn neighbours(&self, i: usize, axis: Axis) -> [Option<(usize, isize)>; 4] {
        [[0, -1], [0, 1], [-1, 0], [1, 0]].map(|step| self.step(i, step, axis))
    }

    /// One step from a point, and to which copy of the map along the flow; over an end to the point beyond, whose copies lie
    /// before each inlet. `None` over a wall.
    fn step(&self, i: usize, step: [isize; 2], axis: Axis) -> Option<(usize, isize)> {
        let (shape, along) = (self.grid.shape(), 1 - axis as usize);
        let (mut to, mut copies) = ([i / shape[1], i % shape[1]], 0);
        for k in [along, 1 - along] {
            let inside = to[k].checked_add_signed(step[k]).filter(|to| *to < shape[k]);
            to[k] = inside.unwrap_or(if step[k] < 0 { shape[k] - 1 } else { 0 });
            match (inside, k == along) {
                (None, false) if !self.repeats[1] => return None,
                // With one point along the flow ends beside it change nothing.
                (None, true) if !self.repeats[0] || shape[k] < 2 => {
                    return Some((self.heights.len(), step[k].max(0)));
                }
                (None, true) => copies = step[k],
                _ => {}
            }
        }
        Some((to[0] * shape[1] + to[1], copies))
    }

    /// The shortest row of open points through one that contact or walls bound on both sides.
    fn width(&self, through: usize, axis: Axis) -> usize {
        let [ny, nx] = self.grid.shape();
        let beside = |step: [isize; 2]| {
            let mut here = through;
            for count in 0..ny.max(nx) {
                match self.step(here, step, axis) {
                    Some((next, _)) if self.heights.get(next)? > &0.0 => here = next,
                    _ => return Some(count),
                }
            }
            None
        };
        let run = |step: [isize; 2]| Some(1 + beside(step)? + beside(step.map(|s| -s))?);
        let shortest = [[0, 1], [1, 0], [1, 1], [1, -1]].into_iter().filter_map(run).min();
        shortest.unwrap_or(usize::MAX).min(ny.min(nx))
    }
}
