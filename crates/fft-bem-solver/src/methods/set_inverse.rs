//! What the cheap inverse of the chord iteration makes of a fixed contact set: `E^T S E` and `E^T 1`, pass by
//! pass as in the iteration, with fields of their own.

use super::extension::{Pyramid, pull_rows};
use super::node::Node;
use super::passes;
use super::stiffness::Stiffness;
use crate::simd::vectorised;
use contact_types::Grid;

/// Columns that are handled at a time: whole cells of the first level.
const PIECE: usize = 64;

/// `E^T S E` on one set.
pub(crate) struct SetInverse {
    nodes: Vec<Node>,
    columns: usize,
    pyramid: Pyramid,
    stiffness: Stiffness,
    residual: Vec<f32>,
    extended: Vec<f32>,
}

impl SetInverse {
    /// For a grid whose finer pixel side is 1.
    pub(crate) fn new(scaled: Grid, nodes: Vec<Node>) -> Self {
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

    /// `z = E^T S E r` on the set, of an r that is 0 outside.
    pub(crate) fn apply(&mut self, r: impl Fn(usize) -> f64, z: &mut [f64]) {
        for (i, x) in self.residual.iter_mut().enumerate() {
            *x = if self.nodes[i].is_in() { r(i) as f32 } else { 0.0 };
        }
        self.weigh();
        self.pyramid.extend_above();
        let Self { nodes, columns, pyramid, stiffness, residual, extended } = self;
        passes::push(nodes, residual, pyramid, *columns, stiffness, extended);
        stiffness.apply_to_filled(extended, residual);
        self.restrict(z);
    }

    /// `z = E^T 1`: a uniform pressure, swept onto the set. Nearly that below a flat punch of its shape.
    pub(crate) fn sweep_uniform(&mut self, z: &mut [f64]) {
        self.residual.fill(0.0);
        self.weigh();
        self.pyramid.extend_above();
        self.residual.fill(1.0);
        self.restrict(z);
    }

    /// The first level of the pyramid over the set and the residual.
    fn weigh(&mut self) {
        let Some(first) = self.pyramid.levels.first_mut() else { return };
        let (t, capacity) = (first.transfer, first.capacity);
        let (weight, value) = (&mut first.weight, &mut first.value);
        vectorised!(pull_rows(&t, capacity, &self.nodes, &self.residual, weight, value));
    }

    /// `z = E^T` of the residual field.
    fn restrict(&mut self, z: &mut [f64]) {
        passes::gather(&self.nodes, &self.residual, &mut self.pyramid);
        self.pyramid.restrict_above();
        let nx = self.columns;
        let rows = z.chunks_exact_mut(nx).zip(self.residual.chunks_exact_mut(nx));
        for (iy, (z, y)) in rows.enumerate() {
            if let Some(first) = self.pyramid.levels.first() {
                for (k, y) in y.chunks_mut(PIECE).enumerate() {
                    first.transfer.add_down_transposed(iy, k * PIECE, &first.value, y);
                }
            }
            for ((z, y), node) in z.iter_mut().zip(y).zip(&self.nodes[iy * nx..]) {
                *z = if node.is_in() { f64::from(*y) } else { 0.0 };
            }
        }
    }
}
