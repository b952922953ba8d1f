//! What the cheap inverse of the chord iteration makes of a fixed contact set: `E^T S E` and `E^T 1`, pass by
//! pass as in the iteration, with fields of their own.

use super::extension::Pyramid;
use super::node::NodeState;
use super::stiffness::Stiffness;
use contact_types::Grid;
use grid_fft::parallel::prelude::*;

/// Columns that are handled at a time: whole cells of the first level.
const PIECE: usize = 64;

/// `E^T S E` on one set.
pub(crate) struct SetInverse {
    nodes: Vec<NodeState>,
    pyramid: Pyramid,
    stiffness: Stiffness,
    residual: Vec<f32>,
    extended: Vec<f32>,
}

impl SetInverse {
    pub(crate) fn new(scaled: Grid, nodes: Vec<NodeState>) -> Self {
        let (shape, pixel, n) = (scaled.shape(), scaled.pixel(), scaled.len());
        Self {
            nodes,
            pyramid: Pyramid::new(shape, pixel),
            stiffness: Stiffness::new(shape, pixel),
            residual: vec![0.0; n],
            extended: vec![0.0; n],
        }
    }

    /// Pairs that one application costs.
    pub(crate) fn cost(&self) -> f64 {
        self.stiffness.cost
    }

    /// `z = E^T S E r` on the set, which is the pixels `on`; r and z have a value for each of these.
    pub(crate) fn apply(&mut self, on: &[usize], r: impl Fn(usize) -> f64, z: &mut [f64]) {
        self.residual.fill(0.0);
        for (k, i) in on.iter().enumerate() {
            self.residual[*i] = r(k) as f32;
        }
        self.extend();
        self.stiffness.apply_to_filled(&self.extended, &mut self.residual);
        self.restrict(on, z);
    }

    /// `z = E^T 1`: a uniform pressure, swept onto the set. Nearly that below a flat punch of its shape.
    pub(crate) fn sweep_uniform(&mut self, on: &[usize], z: &mut [f64]) {
        // Of the pyramid the weights are used, which are of the set alone.
        self.pyramid.levels[0].pull(&self.nodes, &self.residual);
        self.pyramid.pull_above();
        self.residual.fill(1.0);
        self.restrict(on, z);
    }

    /// `E` of the residual field, with the means over the cells of `S`.
    fn extend(&mut self) {
        let Self { nodes, pyramid, stiffness, residual, extended } = self;
        pyramid.levels[0].pull(nodes, residual);
        pyramid.extend_above();
        pyramid.push(nodes, residual, stiffness, extended);
    }

    /// `z = E^T` of the residual field.
    fn restrict(&mut self, on: &[usize], z: &mut [f64]) {
        self.pyramid.restrict(&self.nodes, &self.residual);
        let Self { pyramid, residual, .. } = self;
        let first = &pyramid.levels[0];
        residual.par_chunks_mut(first.transfer.fine[1]).enumerate().for_each(|(iy, y)| {
            for (k, y) in y.chunks_mut(PIECE).enumerate() {
                first.transfer.add_down_transposed(iy, k * PIECE, &first.value, y);
            }
        });
        for (z, i) in z.iter_mut().zip(on) {
            *z = f64::from(residual[*i]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `<E r, y> = <r, E^T y>`: odd and even sides, long pixels, lines, rows longer than a tile.
    #[test]
    fn restriction_is_the_transpose_of_the_extension() {
        let wave = |i: usize| (((i as f64 + 1.3) * 12.9898).sin()) as f32;
        for (shape, pixel) in [
            ([64, 64], [1.0, 1.0]),
            ([97, 131], [1.0, 1.0]),
            ([100, 37], [1.0, 1.0]),
            ([120, 90], [4.0, 1.0]),
            ([91, 121], [1.0, 4.0]),
            ([1, 257], [1.0, 1.0]),
            ([97, 1], [1.0, 1.0]),
            ([19, 1101], [1.0, 1.0]),
            ([4, 4], [1.0, 1.0]),
            ([1, 3], [1.0, 1.0]),
        ] {
            let grid = Grid::new(shape, pixel).unwrap();
            let nodes: Vec<_> = (0..grid.len()).map(|i| NodeState::of(wave(7 * i) > 0.3)).collect();
            let on: Vec<usize> = (0..grid.len()).filter(|i| nodes[*i].is_in()).collect();
            let mut inverse = SetInverse::new(grid, nodes);
            on.iter().enumerate().for_each(|(k, i)| inverse.residual[*i] = wave(3 * k));
            inverse.extend();
            let field = inverse.extended.clone();
            let mut z = vec![0.0; on.len()];
            inverse.residual = (0..grid.len()).map(|i| wave(5 * i)).collect();
            let y = inverse.residual.clone();
            inverse.restrict(&on, &mut z);
            let dot = |x: f32, y: f64| f64::from(x) * y;
            let left: f64 = field.iter().zip(&y).map(|(x, y)| dot(*x, f64::from(*y))).sum();
            let right: f64 = z.iter().enumerate().map(|(k, z)| dot(wave(3 * k), *z)).sum();
            let size: f64 = field.iter().map(|x| f64::from(x.abs())).sum();
            assert!((left - right).abs() < 1e-6 * size, "{shape:?} {pixel:?}: {left}, {right}");
        }
    }
}
