//! Rows of a field that repeats, two by two: what a symmetric stencil takes of them.

/// `factor` times the sum of two rows, from `reach` columns before the column `first` on; rows repeat.
#[inline(always)]
pub(super) fn fold_rows(
    [above, below]: [&[f32]; 2],
    factor: f32,
    first: usize,
    reach: usize,
    line: &mut [f32],
) {
    let (nx, length) = (above.len(), line.len());
    let (begin, end) = (first.saturating_sub(reach), (first + length - reach).min(nx));
    let skip = begin + reach - first;
    let inner = skip..skip + end - begin;
    let rows = above[begin..end].iter().zip(&below[begin..end]);
    for (l, (a, b)) in line[inner.clone()].iter_mut().zip(rows) {
        *l = factor * (a + b);
    }
    let before = nx * reach.div_ceil(nx) - reach;
    for k in (0..inner.start).chain(inner.end..length) {
        let mut column = first + k + before;
        while column >= nx {
            column -= nx; // once or twice, but on narrow grids: a division would cost more
        }
        line[k] = factor * (above[column] + below[column]);
    }
}
