//! Halving an odd axis: cells that are all equally wide and cut pixels.
//!
//! `n = 2 m - 1` pixels make `m` cells of `n/m` pixels: nearly two. Cell c holds all of pixel `2 c`
//! and a part of its neighbours, `c/m` of pixel `2 c - 1` and `(m - 1 - c)/m` of pixel `2 c + 1`. So
//! the axis keeps its length and has no seam.

/// An axis of an odd number of pixels with its cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CutCells {
    cells: usize,
    per_pixel: f32,
}

/// The number of a cell. An axis has less than 2^31 of them, and vectors of `i32` are what processors turn into
/// numbers at once.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "an axis is shorter")]
fn number(c: usize) -> f32 {
    c as i32 as f32
}

impl CutCells {
    /// `None` if the pixels can be paired, or if there is but one.
    pub(crate) fn new(pixels: usize) -> Option<Self> {
        let is_odd = pixels > 1 && pixels % 2 == 1;
        is_odd.then(|| Self { cells: pixels.div_ceil(2), per_pixel: 1.0 / pixels as f32 })
    }

    /// Distance of the centre of pixel `2 c` from that of cell c, in cells: from -1/4 to 1/4.
    #[inline(always)]
    fn even(&self, c: f32) -> f32 {
        (c - 0.5 * number(self.cells - 1)) * self.per_pixel
    }

    /// The same of pixel `2 c + 1`: from 1/4 to 3/4.
    #[inline(always)]
    fn odd(&self, c: f32) -> f32 {
        (c + 0.5 * number(self.cells + 1)) * self.per_pixel
    }

    fn left(&self, c: usize) -> usize {
        if c == 0 { self.cells - 1 } else { c - 1 }
    }

    fn right(&self, c: usize) -> usize {
        if c + 1 == self.cells { 0 } else { c + 1 }
    }

    /// Pixel i is interpolated between the cell i/2 and another: which, and how much of that.
    pub(crate) fn interpolation(&self, i: usize) -> (usize, f32) {
        let c = i / 2;
        let f = if i.is_multiple_of(2) { self.even(number(c)) } else { self.odd(number(c)) };
        (if f < 0.0 { self.left(c) } else { self.right(c) }, f.abs())
    }

    /// Interpolates the pixels below cells `first..`; `cells` has one more at each end.
    #[inline(always)]
    pub(crate) fn interpolate(&self, first: usize, cells: &[f32], pixels: &mut [[f32; 2]]) {
        let (left, right) = (cells, &cells[2..]);
        for (k, (((x, l), c), r)) in
            pixels.iter_mut().zip(left).zip(&cells[1..]).zip(right).enumerate()
        {
            let (f, g) = (self.even(number(first + k)), self.odd(number(first + k)));
            let side = if f < 0.0 { l } else { r };
            *x = [(1.0 - f.abs()) * c + f.abs() * side, (1.0 - g) * c + g * r];
        }
    }

    /// The pixels that are interpolated from cell c, and how much of it they take. A pixel beyond
    /// the last is to be left out.
    pub(crate) fn interpolated(&self, c: usize) -> [(usize, f32); 5] {
        let (l, r) = (self.left(c), self.right(c));
        let (even, odd) = (|c| self.even(number(c)), |c| self.odd(number(c)));
        [
            (2 * l, even(l).max(0.0)),
            (2 * l + 1, odd(l)),
            (2 * c, 1.0 - even(c).abs()),
            (2 * c + 1, 1.0 - odd(c)),
            (2 * r, (-even(r)).max(0.0)),
        ]
    }

    /// What the cells `first..` gather from `pixels`, which begin at `2 first - 2`.
    #[inline(always)]
    pub(crate) fn interpolate_transposed(&self, first: usize, pixels: &[f32], cells: &mut [f32]) {
        let [x, y, z] = [0, 2, 4].map(|first| pixels[first..].as_chunks::<2>().0);
        for (k, (((out, x), y), z)) in cells.iter_mut().zip(x).zip(y).zip(z).enumerate() {
            let c = number(first + k);
            let left = self.even(c - 1.0).max(0.0) * x[0] + self.odd(c - 1.0) * x[1];
            let own = left + (1.0 - self.even(c).abs()) * y[0] + (1.0 - self.odd(c)) * y[1];
            *out = own + (-self.even(c + 1.0)).max(0.0) * z[0];
        }
        // The cells of an axis whose neighbour is at its other end, and the one that was left out.
        for k in [0, cells.len() - 1] {
            let taken = self.interpolated(first + k).into_iter().zip(&pixels[2 * k..]);
            cells[k] = taken.map(|(t, x)| t.1 * x).sum();
        }
    }

    /// Shares of the pixels `2 c - 1`, `2 c`, `2 c + 1` in cell c; the first and the last cell lack
    /// one of them.
    #[inline(always)]
    pub(crate) fn shares(&self, c: usize) -> [f32; 3] {
        [c, self.cells, self.cells - 1 - c].map(|x| number(x) * self.per_pixel)
    }

    /// Means over the cells `first..` of `pixels`, which begin at `2 first - 1`.
    #[inline(always)]
    pub(crate) fn average(&self, first: usize, pixels: &[f32], cells: &mut [f32]) {
        let (left, both) = (pixels.as_chunks::<2>().0, pixels[1..].as_chunks::<2>().0);
        for (k, ((out, left), both)) in cells.iter_mut().zip(left).zip(both).enumerate() {
            let [a, b, c] = self.shares(first + k);
            *out = a * left[0] + b * both[0] + c * both[1];
        }
    }

    /// The cells that pixel i is part of, and its share in each.
    pub(crate) fn parents(&self, i: usize) -> [(usize, f32); 2] {
        let c = i / 2;
        let [_, all, right] = self.shares(c);
        if i.is_multiple_of(2) {
            [(c, all), (c, 0.0)]
        } else {
            [(c, right), (c + 1, self.shares(c + 1)[0])]
        }
    }

    /// Adds `factor` times the transpose of [`average`](Self::average).
    #[inline(always)]
    pub(crate) fn average_transposed(&self, factor: f32, cells: &[f32], pixels: &mut [f32]) {
        let all = factor * number(self.cells) * self.per_pixel;
        let (pairs, last) = pixels.as_chunks_mut::<2>();
        for (c, ((x, own), next)) in pairs.iter_mut().zip(cells).zip(&cells[1..]).enumerate() {
            let (right, left) = (self.shares(c)[2], self.shares(c + 1)[0]);
            x[0] += all * own;
            x[1] += factor * (right * own + left * next);
        }
        if let ([x], Some(c)) = (last, cells.last()) {
            *x += all * c;
        }
    }
}
