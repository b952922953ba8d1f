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
    columns: usize,
    pyramid: Pyramid,
    stiffness: Stiffness,
    residual: Vec<f32>,
    extended: Vec<f32>,
}

impl SetInverse {
    /// For a grid whose finer pixel side is 1.
    pub(crate) fn new(scaled: Grid, nodes: Vec<NodeState>) -> Self {
        let (shape, pixel, n) = (scaled.shape(), scaled.pixel(), scaled.len());
        Self {
            nodes,
            columns: shape[1],
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
        let Self { nodes, columns, pyramid, stiffness, residual, extended } = self;
        pyramid.push(nodes, residual, *columns, stiffness, extended);
        stiffness.apply_to_filled(extended, residual);
        self.restrict(on, z);
    }

    /// `z = E^T 1`: a uniform pressure, swept onto the set. Nearly that below a flat punch of its shape.
    pub(crate) fn sweep_uniform(&mut self, on: &[usize], z: &mut [f64]) {
        self.residual.fill(0.0);
        self.extend();
        self.residual.fill(1.0);
        self.restrict(on, z);
    }

    /// The pyramid over the set and the residual.
    fn extend(&mut self) {
        if let Some(first) = self.pyramid.levels.first_mut() {
            first.pull(&self.nodes, &self.residual);
        }
        self.pyramid.extend_above();
    }

    /// `z = E^T` of the residual field.
    fn restrict(&mut self, on: &[usize], z: &mut [f64]) {
        self.pyramid.restrict(&self.nodes, &self.residual);
        let Self { columns, pyramid, residual, .. } = self;
        if let Some(first) = pyramid.levels.first() {
            residual.par_chunks_mut(*columns).enumerate().for_each(|(iy, y)| {
                for (k, y) in y.chunks_mut(PIECE).enumerate() {
                    first.transfer.add_down_transposed(iy, k * PIECE, &first.value, y);
                }
            });
        }
        for (z, i) in z.iter_mut().zip(on) {
            *z = f64::from(residual[*i]);
        }
    }
}
