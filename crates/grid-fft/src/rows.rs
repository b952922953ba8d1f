//! Real transforms of rows.

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftNum, FftPlanner};
use std::sync::Arc;

/// Transforms of rows of one length.
///
/// A real row of even length is transformed as a complex one of half the length. Where the length is odd
/// that is not possible, and a complex transform is shared by two rows instead, the second as the
/// imaginary part of the first: their spectra are the even and the odd part of what comes out.
#[derive(Clone)]
pub(crate) enum Rows<T> {
    /// Even length.
    Single { forward: Arc<dyn RealToComplex<T>>, inverse: Arc<dyn ComplexToReal<T>> },
    /// Odd length.
    Paired { forward: Arc<dyn Fft<T>>, inverse: Arc<dyn Fft<T>> },
}

/// What a thread needs for the transforms of rows.
pub(crate) struct RowScratch<T> {
    /// One row, of even length.
    row: Vec<T>,
    /// Two rows of odd length.
    pair: Vec<Complex<T>>,
    fft: Vec<Complex<T>>,
}

impl<T: FftNum> Rows<T> {
    /// For rows of `length` values, at least 1.
    pub(crate) fn plan(length: usize, planner: &mut FftPlanner<T>) -> Self {
        if length.is_multiple_of(2) {
            let mut real = RealFftPlanner::new();
            let (forward, inverse) = (real.plan_fft_forward(length), real.plan_fft_inverse(length));
            return Self::Single { forward, inverse };
        }
        let (forward, inverse) =
            (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
        Self::Paired { forward, inverse }
    }

    pub(crate) fn scratch(&self) -> RowScratch<T> {
        let zero = Complex::new(T::zero(), T::zero());
        match self {
            Self::Single { forward, inverse } => {
                let fft = forward.get_scratch_len().max(inverse.get_scratch_len());
                let row = vec![T::zero(); forward.len()];
                RowScratch { row, pair: Vec::new(), fft: vec![zero; fft] }
            }
            Self::Paired { forward, inverse } => {
                let fft = forward.get_inplace_scratch_len().max(inverse.get_inplace_scratch_len());
                let pair = vec![zero; forward.len()];
                RowScratch { row: Vec::new(), pair, fft: vec![zero; fft] }
            }
        }
    }

    /// Number of waves of a row: `length / 2 + 1`.
    fn waves(&self) -> usize {
        match self {
            Self::Single { forward, .. } => forward.complex_len(),
            Self::Paired { forward, .. } => forward.len() / 2 + 1,
        }
    }

    /// Half spectra of rows, each continued with zeros to the length planned for.
    pub(crate) fn forward(
        &self,
        rows: &[T],
        waves: &mut [Complex<T>],
        scratch: &mut RowScratch<T>,
    ) {
        let nq = self.waves();
        let nx = rows.len() / (waves.len() / nq);
        let RowScratch { row, pair, fft } = scratch;
        match self {
            Self::Single { forward, .. } => {
                for (values, wave) in rows.chunks_exact(nx).zip(waves.chunks_exact_mut(nq)) {
                    row[..nx].copy_from_slice(values);
                    row[nx..].fill(T::zero()); // the transform used it as scratch
                    forward.process_with_scratch(row, wave, fft).expect("lengths are as planned");
                }
            }
            Self::Paired { forward, .. } => {
                for (values, waves) in rows.chunks(2 * nx).zip(waves.chunks_mut(2 * nq)) {
                    let (first, second) = values.split_at(nx);
                    for (i, (to, &re)) in pair.iter_mut().zip(first).enumerate() {
                        *to = Complex::new(re, second.get(i).copied().unwrap_or(T::zero()));
                    }
                    pair[nx..].fill(Complex::new(T::zero(), T::zero()));
                    forward.process_with_scratch(pair, fft);
                    separate(pair, waves);
                }
            }
        }
    }

    /// The rows whose half spectra these are, each cut off after its first values. The waves are used as scratch.
    pub(crate) fn inverse(
        &self,
        waves: &mut [Complex<T>],
        rows: &mut [T],
        scratch: &mut RowScratch<T>,
    ) {
        let nq = self.waves();
        let nx = rows.len() / (waves.len() / nq);
        let RowScratch { row, pair, fft } = scratch;
        match self {
            Self::Single { inverse, .. } => {
                for (wave, values) in waves.chunks_exact_mut(nq).zip(rows.chunks_exact_mut(nx)) {
                    // The coefficients that a real row makes real; rounding left a trace of imaginary part.
                    wave[0].im = T::zero();
                    wave[nq - 1].im = T::zero();
                    let whole = nx == row.len();
                    let out = if whole { &mut *values } else { row.as_mut_slice() };
                    inverse
                        .process_with_scratch(wave, out, fft)
                        .expect("lengths are as planned and the ends are real");
                    if !whole {
                        values.copy_from_slice(&row[..nx]);
                    }
                }
            }
            Self::Paired { inverse, .. } => {
                for (waves, values) in waves.chunks(2 * nq).zip(rows.chunks_mut(2 * nx)) {
                    combine(waves, pair);
                    inverse.process_with_scratch(pair, fft);
                    let (first, second) = values.split_at_mut(nx);
                    for (to, from) in first.iter_mut().zip(&*pair) {
                        *to = from.re;
                    }
                    for (to, from) in second.iter_mut().zip(&*pair) {
                        *to = from.im;
                    }
                }
            }
        }
    }
}

/// From the spectrum of `a + i b`, of odd length, the half spectra of the real rows `a` and `b`, one after the
/// other; or of `a` alone, if there is room for one.
fn separate<T: FftNum>(both: &[Complex<T>], waves: &mut [Complex<T>]) {
    let nq = both.len() / 2 + 1;
    let half = T::one() / (T::one() + T::one());
    let (first, second) = waves.split_at_mut(nq);
    first[0] = Complex::new(both[0].re, T::zero());
    let mirrored = || both[1..nq].iter().zip(both[nq..].iter().rev());
    for (a, (z, w)) in first[1..].iter_mut().zip(mirrored()) {
        *a = Complex::new(z.re + w.re, z.im - w.im) * half;
    }
    if let Some((b, rest)) = second.split_first_mut() {
        *b = Complex::new(both[0].im, T::zero());
        for (b, (z, w)) in rest.iter_mut().zip(mirrored()) {
            *b = Complex::new(z.im + w.im, w.re - z.re) * half;
        }
    }
}

/// The spectrum of `a + i b`, of odd length, from the half spectra of the real rows `a` and `b`, one after the
/// other; or from that of `a` alone, where `b` is 0.
fn combine<T: FftNum>(waves: &[Complex<T>], both: &mut [Complex<T>]) {
    let nq = both.len() / 2 + 1;
    let (first, second) = waves.split_at(nq);
    let (rising, falling) = both.split_at_mut(nq);
    let falling = falling.iter_mut().rev();
    // The wave 0 of a real row is real; rounding left a trace of imaginary part.
    rising[0] = Complex::new(first[0].re, second.first().map_or(T::zero(), |b| b.re));
    let pairs = rising[1..].iter_mut().zip(falling).zip(&first[1..]);
    if second.is_empty() {
        for ((z, w), a) in pairs {
            (*z, *w) = (*a, a.conj());
        }
        return;
    }
    for (((z, w), a), b) in pairs.zip(&second[1..]) {
        *z = Complex::new(a.re - b.im, a.im + b.re);
        *w = Complex::new(a.re + b.im, b.re - a.im);
    }
}
