//! The extension and its transpose between the finest grid and the first level.

use crate::methods::extension::{Pyramid, gather_row};
use crate::methods::node::NodeState;
use crate::methods::stiffness::Stiffness;
use crate::methods::transfer::{FilledPart, Transfer};
use crate::simd::vectorised;
use grid_fft::parallel::prelude::*;

/// `E` on the finest grid: the residual on F, what the pyramid knows elsewhere; with the means over
/// the cells of `S`.
pub(crate) fn push(
    nodes: &[NodeState],
    residual: &[f32],
    pyramid: &Pyramid,
    nx: usize,
    stiffness: &mut Stiffness,
    extended: &mut [f32],
) {
    stiffness.fill(extended, |i, x| {
        let (nodes, r) = (&nodes[i * nx..][..nx], &residual[i * nx..][..nx]);
        match pyramid.levels.first() {
            Some(first) => vectorised!(push_row(&first.transfer, i, nodes, r, &first.value, x)),
            None => x.copy_from_slice(r),
        }
    });
}

/// Row `i` of the extended field.
#[inline(always)]
fn push_row(t: &Transfer, i: usize, nodes: &[NodeState], r: &[f32], coarse: &[f32], x: &mut [f32]) {
    t.up_row(
        i,
        coarse,
        #[inline(always)]
        |ix, up| {
            let fields = x[ix..].iter_mut().zip(&nodes[ix..]).zip(&r[ix..]);
            for (((x, m), r), up) in fields.zip(up) {
                *x = r + (1.0 - m.value()) * up; // r is 0 off F: an `if` would choose between addresses
            }
        },
    );
}

/// `E^T` from the finest grid to the first level: what the gap hands up.
pub(crate) fn gather(nodes: &[NodeState], field: &[f32], pyramid: &mut Pyramid) {
    let Some(first) = pyramid.levels.first_mut() else { return };
    let (t, task_rows) = (first.transfer, first.rows_per_task());
    let mx = t.coarse[1];
    first.value.par_chunks_mut(task_rows * mx).enumerate().for_each(|(task, value)| {
        vectorised!({
            for (j, out) in value.chunks_exact_mut(mx).enumerate() {
                gather_row(&t, task * task_rows + j, nodes, field, out);
            }
        });
    });
}
