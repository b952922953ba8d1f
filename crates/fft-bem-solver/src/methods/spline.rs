//! Cubic B-splines on the cells of an axis: interpolation to its pixels, and the transpose.
//!
//! The cells are equally wide and need not end where a pixel does. Between the centres of two
//! neighbouring cells the spline is one polynomial of four coefficients.

use std::ops::Range;

/// An axis of pixels and its cells, one or more pixels wide; it repeats.
pub(super) struct Axis {
    pixels: usize,
    cells: usize,
    /// The pixels between the centres of cells j - 1 and j, for j from 0 to the number of cells.
    start: Vec<usize>,
    /// For each pixel how far it is from the one centre to the other, from 0 to 1, and how much it takes from
    /// each of the four cells around it.
    offset: Vec<f32>,
    shares: Vec<[f32; 4]>,
}

impl Axis {
    /// If there are as many cells as pixels, nothing is interpolated.
    pub(super) fn new(pixels: usize, cells: usize) -> Self {
        // In half cells per pixel and cell, so that nothing is rounded: pixel i is at (2 i + 1) m,
        // cell c at (2 c + 1) n, of 2 n m.
        let position = |i: usize| (2 * i + 1) * cells + pixels;
        let interval = |i: usize| position(i) / (2 * pixels);
        let mut before = 0; // pixels before the centre at hand
        let start = (0..=cells + 1).map(|j| {
            before += (before..pixels).take_while(|&i| interval(i) < j).count();
            before
        });
        let start = start.collect();
        let offset = |i: usize| (position(i) % (2 * pixels)) as f32 / (2 * pixels) as f32;
        let offset: Vec<f32> = (0..pixels).map(offset).collect();
        let shares = offset.iter().map(|f| shares(*f)).collect();
        Self { pixels, cells, start, offset, shares }
    }

    fn is_identity(&self) -> bool {
        self.cells == self.pixels
    }

    /// Pixels per cell.
    pub(super) fn width(&self) -> f64 {
        self.pixels as f64 / self.cells as f64
    }

    /// The four cells around interval j.
    #[inline(always)]
    fn around(&self, j: usize) -> [usize; 4] {
        let m = self.cells;
        if (2..m - 1).contains(&j) {
            return [j - 2, j - 1, j, j + 1];
        }
        [j + 2 * m - 2, j + m - 1, j, j + 1].map(|c| c % m)
    }

    #[inline(always)]
    fn interval(&self, j: usize) -> Range<usize> {
        self.start[j]..self.start[j + 1]
    }

    /// The cells that pixel i is interpolated from, and how much it takes from each.
    #[inline(always)]
    pub(super) fn cells_of(&self, i: usize) -> [(usize, f32); 4] {
        if self.is_identity() {
            return [(i, 1.0), (i, 0.0), (i, 0.0), (i, 0.0)];
        }
        let j = ((2 * i + 1) * self.cells + self.pixels) / (2 * self.pixels);
        let (cells, shares) = (self.around(j), self.shares[i]);
        std::array::from_fn(|k| (cells[k], shares[k]))
    }

    /// The pixels that are interpolated from cell c, and how much they take from it.
    pub(super) fn pixels_of(&self, c: usize) -> impl Iterator<Item = (usize, f32)> + use<'_> {
        let m = self.cells;
        let own = self.is_identity().then_some((c, 1.0));
        let places = (0..4).filter(move |_| own.is_none()).flat_map(move |k| {
            let j = (c + 2 * m + 2 - k) % m; // the interval of which c is the k-th cell
            let wrapped = (j == 0).then_some(m);
            [j].into_iter().chain(wrapped).map(move |j| (j, k))
        });
        let taken =
            move |(j, k): (usize, usize)| self.interval(j).map(move |i| (i, self.shares[i][k]));
        own.into_iter().chain(places.flat_map(taken))
    }

    /// Interpolates a row of cells to its pixels.
    #[inline(always)]
    pub(super) fn interpolate(&self, cells: &[f32], pixels: &mut [f32]) {
        if self.is_identity() {
            pixels.copy_from_slice(cells);
            return;
        }
        for j in 0..=self.cells {
            let polynomial = coefficients(self.around(j).map(|c| cells[c]));
            let range = self.interval(j);
            for (x, f) in pixels[range.clone()].iter_mut().zip(&self.offset[range]) {
                *x = value(polynomial, *f);
            }
        }
    }

    /// The transpose: what the cells gather from a row of pixels.
    #[inline(always)]
    pub(super) fn gather(&self, pixels: &[f32], cells: &mut [f32]) {
        if self.is_identity() {
            cells.copy_from_slice(pixels);
            return;
        }
        cells.fill(0.0);
        for j in 0..=self.cells {
            let mut sum = [0.0_f32; 4];
            let range = self.interval(j);
            for (x, shares) in pixels[range.clone()].iter().zip(&self.shares[range]) {
                for (sum, share) in sum.iter_mut().zip(shares) {
                    *sum += share * x;
                }
            }
            for (c, x) in self.around(j).into_iter().zip(sum) {
                cells[c] += x;
            }
        }
    }
}

/// The polynomial between the second and the third of four cells.
#[inline(always)]
fn coefficients([k0, k1, k2, k3]: [f32; 4]) -> [f32; 4] {
    const SIXTH: f32 = 1.0 / 6.0;
    [
        SIXTH * (k0 + 4.0 * k1 + k2),
        0.5 * (k2 - k0),
        0.5 * (k0 - 2.0 * k1 + k2),
        SIXTH * ((k3 - k0) + 3.0 * (k1 - k2)),
    ]
}

#[inline(always)]
fn value([a, b, c, d]: [f32; 4], f: f32) -> f32 {
    a + f * (b + f * (c + f * d))
}

/// How much a point takes from each of the four cells around it.
#[inline(always)]
fn shares(f: f32) -> [f32; 4] {
    let (f2, f3) = (f * f, f * f * f);
    let rest = 1.0 - f;
    let sixths = [rest * rest * rest, 4.0 - 6.0 * f2 + 3.0 * f3, 1.0 + 3.0 * (f + f2 - f3), f3];
    sixths.map(|x| x * (1.0 / 6.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXES: [(usize, usize); 6] = [(128, 32), (101, 25), (99, 25), (16, 4), (7, 7), (9, 2)];

    fn values(n: usize) -> Vec<f32> {
        (0..n).map(|i| ((i as f32 + 1.3) * 12.9898).sin()).collect()
    }

    /// `<I c, x> = <c, I^T x>`, and the lists of pixels and cells say the same as the rows.
    #[test]
    fn transposes_are_transposes() {
        for (n, m) in AXES {
            let axis = Axis::new(n, m);
            let (cells, pixels) = (values(m), values(n));
            let (mut up, mut down) = (vec![f32::NAN; n], vec![f32::NAN; m]);
            axis.interpolate(&cells, &mut up);
            axis.gather(&pixels, &mut down);
            let dot = |a: &[f32], b: &[f32]| -> f32 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
            assert!((dot(&up, &pixels) - dot(&cells, &down)).abs() < 1e-4, "{n} {m}");
            for (i, up) in up.iter().enumerate() {
                let sum: f32 = axis.cells_of(i).iter().map(|(c, part)| part * cells[*c]).sum();
                assert!((sum - up).abs() < 1e-5, "{n} {m} {i}");
            }
            for (c, down) in down.iter().enumerate() {
                let sum: f32 = axis.pixels_of(c).map(|(i, part)| part * pixels[i]).sum();
                assert!((sum - down).abs() < 1e-5, "{n} {m} {c}");
            }
        }
    }

    /// A straight line stays one, away from the wrap; a constant everywhere.
    #[test]
    fn straight_lines_are_interpolated() {
        for (n, m) in [(128, 32), (101, 25), (99, 25)] {
            let axis = Axis::new(n, m);
            let width = axis.width() as f32;
            let cells: Vec<f32> = (0..m).map(|c| (c as f32 + 0.5) * width).collect();
            let mut up = vec![0.0; n];
            axis.interpolate(&cells, &mut up);
            for (i, x) in up.iter().enumerate().take(n - 10).skip(10) {
                assert!((x - (i as f32 + 0.5)).abs() < 1e-4, "{n} {m} {i}: {x}");
            }
            axis.interpolate(&vec![1.0; m], &mut up);
            assert!(up.iter().all(|x| (x - 1.0).abs() < 1e-6));
        }
    }
}
