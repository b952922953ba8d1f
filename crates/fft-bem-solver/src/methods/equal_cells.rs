//! Cells of several pixels along an axis, all equally wide, for any number of pixels.
//!
//! If the factor does not divide the number of pixels, pixels are cut where one cell ends and the next begins. So the
//! axis keeps its length and has no seam.

pub(super) struct EqualCells {
    /// For each cell the first pixel it has a part of; then the number of pixels.
    start: Vec<usize>,
    /// The part of that pixel that belongs to the cell before; then 0.
    before: Vec<f32>,
    /// Pixels per cell, if no pixel is cut.
    pub(super) whole: Option<usize>,
    /// One over the width of a cell in pixels.
    share: f32,
}

impl EqualCells {
    /// Cells of about `factor` of `pixels` pixels.
    pub(super) fn new(pixels: usize, factor: usize) -> Self {
        let cells = ((2 * pixels + factor) / (2 * factor)).max(1); // rounded
        Self {
            start: (0..=cells).map(|j| j * pixels / cells).collect(),
            before: (0..=cells).map(|j| (j * pixels % cells) as f32 / cells as f32).collect(),
            whole: pixels.is_multiple_of(cells).then_some(pixels / cells),
            share: cells as f32 / pixels as f32,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.start.len() - 1
    }

    /// The pixels of cell `j` with their shares, which sum to one.
    pub(super) fn pixels(&self, j: usize) -> impl Iterator<Item = (usize, f32)> + use<'_> {
        let (from, to) = (self.start[j], self.start[j + 1]);
        let first = (from, 1.0 - self.before[j]);
        let last = (to, self.before[j + 1]);
        let all = [first].into_iter().chain((from + 1..to).map(|i| (i, 1.0))).chain([last]);
        all.filter(|p| p.1 > 0.0).map(|(i, part)| (i, part * self.share))
    }

    /// The cells that pixel `i` is part of, one or two, and its parts in them.
    pub(super) fn cells_of(&self, i: usize) -> impl Iterator<Item = (usize, f32)> + use<> {
        let (pixels, cells) = (self.start[self.len()], self.len());
        let j = ((i + 1) * cells - 1) / pixels; // the last cell that begins in or before it
        let before = if self.start[j] == i { self.before[j] } else { 0.0 };
        [(j, 1.0 - before), (j.saturating_sub(1), before)].into_iter().filter(|p| p.1 > 0.0)
    }

    /// Adds `factor` times the means over the cells.
    #[inline(always)]
    pub(super) fn add_means(&self, factor: f32, pixels: &[f32], means: &mut [f32]) {
        let factor = factor * self.share;
        if self.whole == Some(4) {
            for (m, x) in means.iter_mut().zip(pixels.as_chunks::<4>().0) {
                *m += factor * ((x[0] + x[1]) + (x[2] + x[3]));
            }
            return;
        }
        let mut here = 0.0; // the part of the first pixel that belongs to the cell before
        for (j, m) in means.iter_mut().enumerate() {
            let (from, to) = (self.start[j], self.start[j + 1]);
            let next = pixels.get(to).map_or(0.0, |x| self.before[j + 1] * x);
            let inside = match pixels[from..to] {
                [a, b, c, d] => (a + b) + (c + d), // most cells
                ref others => others.iter().sum::<f32>(),
            };
            *m += factor * (inside - here + next);
            here = next;
        }
    }

    /// Writes to each pixel `factor` times the value of its cell.
    #[inline(always)]
    pub(super) fn spread(&self, factor: f32, cells: &[f32], pixels: &mut [f32]) {
        if self.whole == Some(4) {
            for (x, cell) in pixels.as_chunks_mut::<4>().0.iter_mut().zip(cells) {
                *x = [factor * cell; 4];
            }
            return;
        }
        pixels.fill(0.0);
        self.replicate(factor, cells, pixels);
    }

    /// Adds `factor` times the value of its cell to each pixel.
    #[inline(always)]
    pub(super) fn replicate(&self, factor: f32, cells: &[f32], pixels: &mut [f32]) {
        if self.whole == Some(4) {
            for (x, cell) in pixels.as_chunks_mut::<4>().0.iter_mut().zip(cells) {
                let value = factor * cell;
                for x in x {
                    *x += value;
                }
            }
            return;
        }
        for (j, cell) in cells.iter().enumerate() {
            let value = factor * cell;
            let (from, to) = (self.start[j], self.start[j + 1]);
            match &mut pixels[from..to] {
                four @ [_, _, _, _] => four.iter_mut().for_each(|x| *x += value), // most cells
                others => others.iter_mut().for_each(|x| *x += value),
            }
            if self.before[j] > 0.0 {
                pixels[from] += self.before[j] * (factor * cells[j - 1] - value);
            }
        }
    }
}
