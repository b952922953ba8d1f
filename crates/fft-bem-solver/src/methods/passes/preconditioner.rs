//! The extension and its transpose between the finest grid and the first level.

use crate::methods::extension::{Pyramid, gather_row};
use crate::methods::transfer::ON;
use grid_fft::parallel::prelude::*;

/// `E` on the finest grid: the residual on F, what the pyramid knows elsewhere.
pub(crate) fn push(
    mask: &[u8],
    residual: &[f32],
    pyramid: &Pyramid,
    [rows, nx]: [usize; 2],
    extended: &mut [f32],
) {
    let Some(first) = pyramid.levels.first() else {
        extended.copy_from_slice(residual);
        return;
    };
    let chunk = rows * nx;
    extended
        .par_chunks_mut(chunk)
        .zip(mask.par_chunks(chunk))
        .zip(residual.par_chunks(chunk))
        .enumerate()
        .for_each(|(task, ((x, mask), r))| {
            let lines = x.chunks_exact_mut(nx).zip(mask.chunks_exact(nx)).zip(r.chunks_exact(nx));
            for (i, ((x, mask), r)) in lines.enumerate() {
                first.transfer.up_row(task * rows + i, &first.value, |ix, up| {
                    let fields = x[ix..].iter_mut().zip(&mask[ix..]).zip(&r[ix..]);
                    for (((x, m), r), up) in fields.zip(up) {
                        *x = if *m == ON { *r } else { *up };
                    }
                });
            }
        });
}

/// `E^T` from the finest grid to the first level: what the gap hands up.
pub(crate) fn gather(mask: &[u8], field: &[f32], pyramid: &mut Pyramid) {
    let Some(first) = pyramid.levels.first_mut() else { return };
    let (t, task_rows) = (first.transfer, first.rows_per_task());
    let mx = t.coarse[1];
    first.value.par_chunks_mut(task_rows * mx).enumerate().for_each(|(task, value)| {
        for (j, out) in value.chunks_exact_mut(mx).enumerate() {
            gather_row(&t, task * task_rows + j, mask, field, out);
        }
    });
}
