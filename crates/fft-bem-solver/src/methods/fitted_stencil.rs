//! The taps of the stencil of the cheap compliance, and what it leaves to the coarse grid.

use std::f64::consts::TAU;

/// Waves along each axis to which the taps are fitted.
const PROBE: usize = 32;
/// Below this response, a wave of the coarse grid is not brought to full strength.
const WEAKEST: f64 = 0.3;

/// Reach of the stencil along an axis, in cells, and in pixels at most.
const REACH: f64 = 1.25;
pub(super) const MAX_REACH: usize = 12;

/// A stencil that is even along both axes.
#[derive(Debug, Clone)]
pub(super) struct Stencil {
    /// Pixels it reaches beyond its centre along each axis.
    pub(super) reach: [usize; 2],
    /// Taps at `(dy, dx)`, `dx` fastest, each from 0 to the reach.
    pub(super) taps: Vec<f64>,
}

impl Stencil {
    /// What the taps along an axis, each with its mirror image, are to a wave of this phase per pixel.
    pub(super) fn along(&self, axis: usize, phase: f64) -> Vec<f64> {
        let wave = |d: usize| if d == 0 { 1.0 } else { 2.0 * (d as f64 * phase).cos() };
        (0..=self.reach[axis]).map(wave).collect()
    }

    /// The taps summed along x for a wave of this phase: those of a stencil along y.
    pub(super) fn summed_along_x(&self, phase: f64) -> Vec<f64> {
        let waves = self.along(1, phase);
        self.taps.chunks_exact(waves.len()).map(|row| dot(row, &waves)).collect()
    }

    /// Writes the Fourier symbols of all taps, each one, for a wave.
    fn symbols(&self, phase: [f64; 2], out: &mut [f64]) {
        let wave = |d: usize, a: usize| {
            if d == 0 { 1.0 } else { 2.0 * (d as f64 * phase[a]).cos() }
        };
        let mut along_x = [0.0; MAX_REACH + 1];
        let along_x = &mut along_x[..=self.reach[1]];
        along_x.iter_mut().enumerate().for_each(|(d, w)| *w = wave(d, 1));
        for (dy, row) in out.chunks_exact_mut(along_x.len()).enumerate() {
            let along_y = wave(dy, 0);
            row.iter_mut().zip(&*along_x).for_each(|(x, w)| *x = along_y * w);
        }
    }
}

/// Inner product.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Waves on pixels of this size, and a coarse grid whose cells are so many pixels wide.
#[derive(Debug, Clone, Copy)]
pub(super) struct Waves {
    pub(super) pixel: [f64; 2],
    pub(super) width: [f64; 2],
}

impl Waves {
    /// `2/|q|` of a wave of these phases per pixel; 0 for the mean.
    fn compliance(&self, phase: [f64; 2]) -> f64 {
        let q = (phase[0] / self.pixel[0]).hypot(phase[1] / self.pixel[1]);
        if q > 0.0 { 2.0 / q } else { 0.0 }
    }

    /// B: what a cubic spline over the cells leaves of a wave.
    fn response(&self, phase: [f64; 2]) -> f64 {
        let along = |axis: usize| {
            let half = 0.5 * phase[axis] * self.width[axis];
            let is_passed = self.width[axis] <= 1.0 || half == 0.0;
            if is_passed { 1.0 } else { (half.sin() / half).powi(4) }
        };
        along(0) * along(1)
    }

    /// Symbol of the coarse grid for a wave of which the stencil leaves `rest`.
    fn coarse(&self, phase: [f64; 2], rest: f64) -> f64 {
        rest / self.response(phase).max(WEAKEST).powi(2)
    }

    /// Symbol of the coarse grid for a wave to which the stencil is `local`.
    pub(super) fn symbol(&self, phase: [f64; 2], local: f64) -> f64 {
        let compliance = self.compliance(phase);
        if compliance == 0.0 { 0.0 } else { self.coarse(phase, compliance - local) }
    }

    /// The stencil that makes the error of the pressure smallest for white noise on a grid of `shape`, if
    /// each cell is a whole number of pixels wide.
    ///
    /// Waves that differ by a multiple of the coarse sampling rate are one to the coarse grid. If the
    /// stencil leaves `x_j` of them, the displacement of wave k is wrong by `x_k` on itself and by
    /// `- B_j c B_k` on all, where c is what the coarse grid does; the pressure, by |q_j|/2 times that.
    /// Both are linear in the taps: least squares.
    pub(super) fn fitted_stencil(&self, shape: [usize; 2]) -> Stencil {
        let factor = self.width.map(|w| w.round() as usize);
        let coarse = [0, 1].map(|a| if shape[a] > 1 { PROBE.div_ceil(factor[a]) } else { 1 });
        let probe = [0, 1].map(|a| factor[a] * coarse[a]);
        let reach = self.width.map(|w| (REACH * w).round() as usize);
        let reach = [0, 1]
            .map(|a| reach[a].min(MAX_REACH).min((shape[a] - 1) / 2) * usize::from(factor[a] > 1));
        let mut stencil = Stencil { reach, taps: Vec::new() };
        let unknowns = (reach[0] + 1) * (reach[1] + 1);
        // What each tap, and K itself, is to a wave.
        let fill = |phase: [f64; 2], row: &mut [f64]| {
            let (taps, whole) = row.split_at_mut(unknowns);
            stencil.symbols(phase, taps);
            whole[0] = self.compliance(phase);
        };
        let [mut passed, mut x, mut crossed] = [(); 3].map(|()| vec![0.0; unknowns + 1]);
        let mut normal = vec![vec![0.0; unknowns + 1]; unknowns + 1];
        // Everything is even along both axes: half of the waves along each tell it all.
        let half = coarse.map(|n| n / 2 + 1);
        for class in 0..half[0] * half[1] {
            let k = [class / half[1], class % half[1]];
            let alike = |a: usize| if k[a] == 0 || 2 * k[a] == coarse[a] { 1.0 } else { 2.0 };
            let count = alike(0) * alike(1);
            let main = [0, 1].map(|a| phase_of(k[a], coarse[a]) / factor[a] as f64);
            fill(main, &mut passed);
            for x in &mut passed {
                *x = if class == 0 { 0.0 } else { self.coarse(main, *x) };
            }
            crossed.fill(0.0);
            let (mut into, mut out_of) = (0.0, 0.0);
            for member in 0..factor[0] * factor[1] {
                let alias = [member / factor[1], member % factor[1]];
                let phase = [0, 1].map(|a| phase_of(k[a] + alias[a] * coarse[a], probe[a]));
                let compliance = self.compliance(phase);
                if compliance == 0.0 {
                    continue;
                }
                fill(phase, &mut x);
                let (stiff2, b2) = (compliance.powi(-2), self.response(phase).powi(2));
                into += b2;
                out_of += stiff2 * b2;
                for i in 0..=unknowns {
                    crossed[i] += stiff2 * b2 * x[i];
                    for j in 0..=i {
                        normal[i][j] += count * stiff2 * x[i] * x[j];
                    }
                }
            }
            for i in 0..=unknowns {
                for j in 0..=i {
                    let more = passed[i] * passed[j] * into * out_of
                        - crossed[i] * passed[j]
                        - crossed[j] * passed[i];
                    normal[i][j] += count * more;
                }
            }
        }
        stencil.taps = least_squares(normal);
        stencil
    }
}

/// Phase per pixel of wave `k` on `n` pixels.
fn phase_of(k: usize, n: usize) -> f64 {
    TAU * (if 2 * k <= n { k as f64 } else { k as f64 - n as f64 }) / n as f64
}

/// Solves for the unknowns from the lower half of the normal matrix, whose last row is the right hand
/// side, by Cholesky's factors. An unknown that adds nothing to those before comes out as 0.
fn least_squares(mut a: Vec<Vec<f64>>) -> Vec<f64> {
    let n = a.len() - 1;
    for j in 0..n {
        let own = a[j][j];
        let rest = own - a[j][..j].iter().map(|x| x * x).sum::<f64>();
        let pivot = if rest > 1e-12 * own { rest.sqrt() } else { f64::INFINITY };
        a[j][j] = pivot;
        let (above, below) = a.split_at_mut(j + 1);
        for row in below {
            let known: f64 = row[..j].iter().zip(&above[j]).map(|(x, f)| x * f).sum();
            row[j] = (row[j] - known) / pivot;
        }
    }
    let mut x = a[n][..n].to_vec();
    for j in (0..n).rev() {
        let known: f64 = (j + 1..n).map(|i| a[i][j] * x[i]).sum();
        x[j] = (x[j] - known) / a[j][j];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial through its values, with one unknown too many.
    #[test]
    fn least_squares_find_a_polynomial() {
        let basis = |x: f64| [1.0, x, x * x, 2.0 * x, 3.0 - x + 0.5 * x * x];
        let mut normal = vec![vec![0.0; 5]; 5];
        for row in (0..7).map(|i| basis(0.3 * f64::from(i))) {
            for (i, normal) in normal.iter_mut().enumerate() {
                normal.iter_mut().zip(row).for_each(|(n, x)| *n += row[i] * x);
            }
        }
        let found = least_squares(normal);
        for (x, expected) in found.iter().zip([3.0, -1.0, 0.5, 0.0]) {
            assert!((x - expected).abs() < 1e-9, "{found:?}");
        }
    }
}
