//! Transfer of fields between a grid and the grid with one or both axes halved, row by row.
//!
//! A coarse cell has two children along a halved axis, but for an odd one: there the second child
//! of the last cell is missing and counts as empty, or the cells are all equally wide and cut pixels
//! ([`CutCells`]). Four linear maps are needed: half the sum of the children, or the mean over the cell
//! (`down`), cell-centred linear interpolation with periodic wrap (`up`), and the transposes of both.

use super::cut_cells::CutCells;

/// Columns of the coarse grid handled at a time, so that lines fit the stack.
const TILE: usize = 256;

/// A weight from 0 (gap) to 1 (contact): a [`NodeState`](super::node::NodeState) on the finest grid, a number above.
pub(crate) trait FilledPart: Copy + Send + Sync {
    fn value(self) -> f32;
}

impl FilledPart for f32 {
    fn value(self) -> f32 {
        self
    }
}

/// From a `fine` to a `coarse` shape.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Transfer {
    pub(crate) fine: [usize; 2],
    pub(crate) coarse: [usize; 2],
    pub(crate) halved: [bool; 2],
    /// Axes whose cells cut pixels.
    pub(super) cut: [Option<CutCells>; 2],
}

impl Transfer {
    /// Cells may cut pixels; else the last of an odd axis is narrow. Axes of one pixel must not be halved.
    pub(crate) fn new(fine: [usize; 2], halved: [bool; 2], may_cut: bool) -> Self {
        let coarse = [0, 1].map(|a| if halved[a] { fine[a].div_ceil(2) } else { fine[a] });
        let cut = |a: usize| CutCells::new(fine[a]).filter(|_| may_cut && halved[a]);
        Self { fine, coarse, halved, cut: [cut(0), cut(1)] }
    }

    /// Fine rows that make up one coarse row: a whole number of pairs.
    pub(crate) fn rows_per_coarse_row(&self) -> usize {
        if self.halved[0] { 2 } else { 1 }
    }

    /// The coarse row above fine row `i`.
    pub(crate) fn parent(&self, i: usize) -> usize {
        if self.halved[0] { i / 2 } else { i }
    }

    /// Share of its cell that `down^T` hands to each node.
    pub(crate) fn node_share(&self) -> f32 {
        self.halved.iter().map(|&h| if h { 0.5 } else { 1.0 }).product()
    }

    /// One row of `down(w)` and of `down(w v)`. `w` and `v` are the two rows below it;
    /// where the second is missing, the result is to be halved.
    #[inline(always)]
    pub(crate) fn down_row<W: FilledPart>(
        &self,
        w: [&[W]; 2],
        v: [&[f32]; 2],
        mass: &mut [f32],
        value: &mut [f32],
    ) {
        let cell = |i: usize| {
            let (a, b) = (w[0][i].value(), w[1][i].value());
            (0.5 * (a + b), 0.5 * (a * v[0][i] + b * v[1][i]))
        };
        if !self.halved[1] {
            for (i, (m, s)) in mass.iter_mut().zip(value).enumerate() {
                (*m, *s) = cell(i);
            }
            return;
        }
        let pairs = self.fine[1] / 2;
        let (wa, wb) = (&w[0].as_chunks::<2>().0[..pairs], &w[1].as_chunks::<2>().0[..pairs]);
        let (va, vb) = (&v[0].as_chunks::<2>().0[..pairs], &v[1].as_chunks::<2>().0[..pairs]);
        let (inner_mass, inner_value) = (&mut mass[..pairs], &mut value[..pairs]);
        for j in 0..pairs {
            let (a, b) = (wa[j].map(FilledPart::value), wb[j].map(FilledPart::value));
            inner_mass[j] = 0.25 * ((a[0] + a[1]) + (b[0] + b[1]));
            inner_value[j] =
                0.25 * ((a[0] * va[j][0] + a[1] * va[j][1]) + (b[0] * vb[j][0] + b[1] * vb[j][1]));
        }
        if self.fine[1] % 2 == 1 {
            let (m, s) = cell(2 * pairs); // half of its cell
            (mass[pairs], value[pairs]) = (0.5 * m, 0.5 * s);
        }
    }

    /// Fine row `i` of `up(coarse)`, handed over in pieces: `piece(first column, values)`.
    #[inline(always)]
    pub(crate) fn up_row(&self, i: usize, coarse: &[f32], mut piece: impl FnMut(usize, &[f32])) {
        let [my, mx] = self.coarse;
        let row = |j: usize| &coarse[j * mx..(j + 1) * mx];
        let j = self.parent(i);
        let (other, part) = match (self.halved[0], self.cut[0]) {
            (false, _) => (j, 0.25),
            (_, Some(cut)) => cut.interpolation(i),
            (_, None) if i.is_multiple_of(2) => ((j + my - 1) % my, 0.25),
            (_, None) => ((j + 1) % my, 0.25),
        };
        let (near, far) = (row(j), row(other));
        let mut between = [0.0_f32; TILE + 2]; // rows combined, with one cell beyond each end
        let mut line = [[0.0_f32; 2]; TILE];
        for first in (0..mx).step_by(TILE) {
            let width = TILE.min(mx - first);
            let at = |j: usize| (1.0 - part) * near[j] + part * far[j];
            let inner = &mut between[1..=width];
            let (a, b) = (&near[first..][..width], &far[first..][..width]);
            for ((t, a), b) in inner.iter_mut().zip(a).zip(b) {
                *t = (1.0 - part) * a + part * b;
            }
            if !self.halved[1] {
                piece(first, inner);
                continue;
            }
            between[0] = at((first + mx - 1) % mx);
            between[width + 1] = at((first + width) % mx);
            let columns = (2 * width).min(self.fine[1] - 2 * first);
            if let Some(cut) = self.cut[1] {
                cut.interpolate(first, &between[..width + 2], &mut line[..width]);
            } else {
                let (left, right) = (&between[..width], &between[2..width + 2]);
                let cells = left.iter().zip(&between[1..=width]).zip(right);
                for (x, ((l, c), r)) in line[..width].iter_mut().zip(cells) {
                    *x = [0.75 * c + 0.25 * l, 0.75 * c + 0.25 * r];
                }
            }
            piece(2 * first, &line[..width].as_flattened()[..columns]);
        }
    }

    /// Row `j` of the transpose of `up`. `add(first, factor, line)` must add `factor` times the
    /// fine values from that pixel on to the line.
    #[inline(always)]
    pub(crate) fn up_transposed_row(
        &self,
        j: usize,
        out: &mut [f32],
        mut add: impl FnMut(usize, f32, &mut [f32]),
    ) {
        let ([ny, nx], [my, mx]) = (self.fine, self.coarse);
        // The fine rows that interpolate from coarse row j, and how much they take from it.
        let (below, above) = (2 * ((j + my - 1) % my) + 1, 2 * ((j + 1) % my));
        let pairs = [(2 * j, 0.75), (2 * j + 1, 0.75), (above, 0.25), (below, 0.25)];
        let cut = self.cut[0].map(|cut| cut.interpolated(j));
        let rows: &[(usize, f32)] = match &cut {
            _ if !self.halved[0] => &[(j, 1.0)],
            Some(cut) => cut,
            None => &pairs,
        };
        let mut line = [0.0_f32; 2 * TILE + 3];
        for first in (0..mx).step_by(TILE) {
            let width = TILE.min(mx - first);
            let out = &mut out[first..first + width];
            if !self.halved[1] {
                out.fill(0.0);
                for &(iy, factor) in rows.iter().filter(|r| r.0 < ny) {
                    add(iy * nx + first, factor, out);
                }
                continue;
            }
            // Fine columns 2 first - 2 ..= 2 (first + width), wrapped; an odd axis lacks its last.
            let line = &mut line[..2 * width + 3];
            line.fill(0.0);
            let begin = (2 * first).saturating_sub(2);
            let end = (2 * (first + width) + 1).min(nx);
            let skip = if first == 0 { 2 } else { 0 };
            for &(iy, factor) in rows.iter().filter(|r| r.0 < ny) {
                add(iy * nx + begin, factor, &mut line[skip..skip + end - begin]);
                if first == 0 {
                    add(iy * nx + 2 * mx - 2, factor, &mut line[..nx + 2 - 2 * mx]);
                }
                if first + width == mx {
                    add(iy * nx, factor, &mut line[2 * width + 2..]);
                }
            }
            if let Some(cut) = self.cut[1] {
                cut.interpolate_transposed(first, line, out);
                continue;
            }
            let line = &line[1..];
            for (o, window) in out.iter_mut().zip(line.windows(4).step_by(2)) {
                *o = 0.25 * (window[0] + window[3]) + 0.75 * (window[1] + window[2]);
            }
        }
    }

    /// Adds to a coarse row what its cells gather from the fine columns below cell `c`: the transpose of
    /// `up` along x, for cells that do not cut pixels.
    #[inline(always)]
    pub(crate) fn add_columns_transposed(&self, c: usize, fine: [f32; 2], row: &mut [f32]) {
        if !self.halved[1] {
            row[c] += fine[0];
            return;
        }
        let left = if c == 0 { row.len() - 1 } else { c - 1 };
        let right = if c + 1 == row.len() { 0 } else { c + 1 };
        row[left] += 0.25 * fine[0];
        row[c] += 0.75 * (fine[0] + fine[1]);
        row[right] += 0.25 * fine[1];
    }

    /// Whether the cells of an axis cut pixels: then the two functions below are to be used for
    /// `down`. They do for any axis, but the three others are faster.
    pub(crate) fn has_cut_cells(&self) -> bool {
        self.cut.iter().any(Option::is_some)
    }

    /// Row `j` of `down`, with `add` as for [`up_transposed_row`](Self::up_transposed_row).
    #[inline(always)]
    pub(crate) fn down_row_of(
        &self,
        j: usize,
        out: &mut [f32],
        mut add: impl FnMut(usize, f32, &mut [f32]),
    ) {
        let ([ny, nx], mx) = (self.fine, self.coarse[1]);
        let [left, middle, right] = self.cut[0].map_or([0.0, 0.5, 0.5], |cut| cut.shares(j));
        let three = [((2 * j).saturating_sub(1), left), (2 * j, middle), (2 * j + 1, right)];
        let rows: &[(usize, f32)] = if self.halved[0] { &three } else { &[(j, 1.0)] };
        let mut line = [0.0_f32; 2 * TILE + 1];
        for first in (0..mx).step_by(TILE) {
            let width = TILE.min(mx - first);
            let out = &mut out[first..first + width];
            // Fine columns 2 first - 1 .. 2 (first + width), those that exist; or the same columns.
            let (begin, end, skip) = match self.halved[1] {
                true if first == 0 => (0, 2 * width, 1),
                true => (2 * first - 1, 2 * (first + width), 0),
                false => (first, first + width, 0),
            };
            let end = end.min(nx);
            line.fill(0.0);
            for &(iy, share) in rows.iter().filter(|r| r.0 < ny && r.1 > 0.0) {
                add(iy * nx + begin, share, &mut line[skip..skip + end - begin]);
            }
            match self.cut[1] {
                Some(cut) => cut.average(first, &line[..=2 * width], out),
                None if self.halved[1] => {
                    for (o, x) in out.iter_mut().zip(line[1..].as_chunks::<2>().0) {
                        *o = 0.5 * (x[0] + x[1]);
                    }
                }
                None => out.copy_from_slice(&line[..width]),
            }
        }
    }

    /// Adds the transpose of `down` to fine row `i`.
    #[inline(always)]
    pub(crate) fn add_down_row_of_transposed(&self, i: usize, coarse: &[f32], fine: &mut [f32]) {
        let mx = self.coarse[1];
        let two = match (self.halved[0], self.cut[0]) {
            (false, _) => [(i, 1.0), (i, 0.0)],
            (_, None) => [(i / 2, 0.5), (i / 2, 0.0)],
            (_, Some(cut)) => cut.parents(i),
        };
        for (j, share) in two.into_iter().filter(|r| r.1 > 0.0) {
            let above = &coarse[j * mx..(j + 1) * mx];
            match self.cut[1] {
                Some(cut) => cut.average_transposed(share, above, fine),
                None if self.halved[1] => {
                    for (x, c) in fine.as_chunks_mut::<2>().0.iter_mut().zip(above) {
                        x[0] += 0.5 * share * c;
                        x[1] += 0.5 * share * c;
                    }
                }
                None => fine.iter_mut().zip(above).for_each(|(x, c)| *x += share * c),
            }
        }
    }

    /// Adds the transpose of `down` to part of fine row `i`, from the even column `ix` on.
    #[inline(always)]
    pub(crate) fn add_down_transposed(
        &self,
        i: usize,
        ix: usize,
        coarse: &[f32],
        fine: &mut [f32],
    ) {
        let mx = self.coarse[1];
        let above = &coarse[self.parent(i) * mx..][..mx];
        let share = self.node_share();
        if !self.halved[1] {
            for (x, c) in fine.iter_mut().zip(&above[ix..]) {
                *x += share * c;
            }
            return;
        }
        let (pairs, single) = fine.as_chunks_mut::<2>();
        for (x, c) in pairs.iter_mut().zip(&above[ix / 2..]) {
            x[0] += share * c;
            x[1] += share * c;
        }
        if let ([x], Some(c)) = (single, above.last()) {
            *x += share * c;
        }
    }
}
