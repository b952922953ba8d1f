//! From a power spectral density, as measured or as a formula, to a spectrum in shells.

use crate::{RoughnessSpectrum, Shell, SurfaceError};
use std::f64::consts::{LN_2, TAU};

/// What the integral of a two-dimensional PSD `C(q)` over wave vectors gives. `C` is in m⁴ in both,
/// and the two differ by `(2π)² = 39.5`: a PSD read with the wrong one gives heights wrong by 6.3.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum PsdConvention {
    /// `m0 = ∫ C d²q`, the one of this workspace and of Persson (2001).
    Angular,
    /// `m0 = ∫ C d²q / (2π)²`, of Jacobs, Junge & Pastewka (2017), doi:10.1088/2051-672X/aa51f8.
    /// It has the numbers of a PSD against cycles per metre, `m0 = ∫ C d²f` with `q = 2πf`.
    PerCycle,
}

/// Positive nodes and weights of the Gauss–Legendre rule of 10 points on -1 to 1.
const GAUSS: [[f64; 2]; 5] = [
    [0.148_874_338_981_631_21, 0.295_524_224_714_752_87],
    [0.433_395_394_129_247_19, 0.269_266_719_309_996_36],
    [0.679_409_568_299_024_41, 0.219_086_362_515_982_04],
    [0.865_063_366_688_984_51, 0.149_451_349_150_580_59],
    [0.973_906_528_517_171_72, 0.066_671_344_308_688_14],
];

impl RoughnessSpectrum {
    /// From an isotropic two-dimensional PSD, a function of the angular wavenumber (rad/m) that
    /// gives m⁴, between the first and the last of `limits` (rad/m, rising). Wavenumbers at which
    /// the PSD bends (roll-off) belong among the limits: between them it should be smooth.
    ///
    /// The shells are the nodes of Gauss's rule in `ln q`, ten for every octave. The moments of a
    /// power law come out to rounding; what depends on the order of the waves (Persson's gap, the
    /// area at a magnification) sees steps of a tenth of an octave.
    ///
    /// # Errors
    /// [`SurfaceError::Spectrum`] for limits that are not at least two finite, positive and rising
    /// wavenumbers, and for a PSD that is negative or not finite, or whose variance is not.
    ///
    /// ```
    /// use contact_types::{PsdConvention, RoughnessSpectrum};
    /// // H = 0.8 between wavelengths of 100 µm and 1 µm.
    /// let [long, short] = [100e-6, 1e-6].map(|wavelength| std::f64::consts::TAU / wavelength);
    /// let psd = |q: f64| 1e-24 * (q / long).powf(-3.6);
    /// let spectrum = RoughnessSpectrum::from_psd(PsdConvention::Angular, psd, &[long, short])?;
    /// let m0 = std::f64::consts::TAU * 1e-24 * long * long * (1.0 - 100f64.powf(-1.6)) / 1.6;
    /// assert!((spectrum.moments().m0 / m0 - 1.0).abs() < 1e-14);
    /// # Ok::<(), contact_types::SurfaceError>(())
    /// ```
    pub fn from_psd(
        convention: PsdConvention,
        psd: impl Fn(f64) -> f64,
        limits: &[f64],
    ) -> Result<Self, SurfaceError> {
        check(limits)?;
        let ring = match convention {
            PsdConvention::Angular => TAU,          // d²q = 2π q dq = 2π q² d ln q
            PsdConvention::PerCycle => TAU.recip(), // the same over (2π)²
        };
        let mut shells = Vec::new();
        for pair in limits.windows(2) {
            let span = (pair[1] / pair[0]).ln();
            let panels = (span / LN_2).ceil().max(1.0) as usize;
            let half = 0.5 * span / panels as f64;
            for panel in 0..panels {
                let middle = (2 * panel + 1) as f64 * half;
                for (node, weight) in nodes() {
                    let wavenumber = pair[0] * (middle + half * node).exp();
                    let density = psd(wavenumber);
                    if !(density.is_finite() && density >= 0.0) {
                        return Err(SurfaceError::Spectrum {
                            index: shells.len(),
                            what: "PSD",
                            value: density,
                            limit: "must be finite and not negative between the limits",
                        });
                    }
                    let variance = ring * density * wavenumber * wavenumber * half * weight;
                    shells.push(Shell { wavenumber, variance });
                }
            }
        }
        // Two nodes of a narrow band may round to one wavenumber.
        shells.dedup_by(|next, shell| {
            let same = next.wavenumber <= shell.wavenumber;
            if same {
                shell.variance += next.variance;
            }
            same
        });
        Self::new(shells)
    }
}

/// Nodes and weights from -1 to 1, rising.
fn nodes() -> impl Iterator<Item = (f64, f64)> {
    let negative = GAUSS.iter().rev().map(|&[node, weight]| (-node, weight));
    negative.chain(GAUSS.iter().map(|&[node, weight]| (node, weight)))
}

fn check(limits: &[f64]) -> Result<(), SurfaceError> {
    let fault = |index, what, value, limit| SurfaceError::Spectrum { index, what, value, limit };
    if limits.len() < 2 {
        let limit = "a PSD needs at least the two ends of its band";
        return Err(fault(0, "number of limits", limits.len() as f64, limit));
    }
    let mut last = 0.0;
    for (index, &q) in limits.iter().enumerate() {
        if !((1e-150..=1e150).contains(&q) && q > last) {
            let limit = "must be positive, rising and within 1e-150 to 1e150 rad/m";
            return Err(fault(index, "wavenumber", q, limit));
        }
        last = q;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use proptest::prelude::*;

    /// `∫ q^(n+1) C dq` of `C = C0` up to the roll-off and `C0 (q/q_r)^(-2-2H)` beyond, by the two
    /// elementary integrals.
    fn exact(n: f64, hurst: f64, [lower, rolloff, cutoff]: [f64; 3]) -> f64 {
        let flat = (rolloff.powf(n + 2.0) - lower.powf(n + 2.0)) / (n + 2.0);
        let e = n - 2.0 * hurst;
        flat + rolloff.powf(n + 2.0) * (e * (cutoff / rolloff).ln()).exp_m1() / e
    }

    proptest! {
        #[test]
        fn moments_of_a_self_affine_psd(
            hurst in 0.05..0.95, roll in 1.5..50.0, cut in 1.5..1e4, c0 in 1e-30..1e-20,
        ) {
            let q = [1e4, 1e4 * roll, 1e4 * roll * cut];
            let psd = |x: f64| if x < q[1] { c0 } else { c0 * (x / q[1]).powf(-2.0 - 2.0 * hurst) };
            let found = RoughnessSpectrum::from_psd(PsdConvention::Angular, psd, &q).unwrap();
            let found = found.moments();
            // m0 = 2π ∫ q C, m2 = π ∫ q³ C, m4 = (3π/4) ∫ q⁵ C.
            close(found.m0, TAU * c0 * exact(0.0, hurst, q), 1e-13);
            close(found.m2, TAU / 2.0 * c0 * exact(2.0, hurst, q), 1e-13);
            close(found.m4, 0.375 * TAU * c0 * exact(4.0, hurst, q), 1e-13);
            // The same surface by the other convention.
            let square = |x: f64| TAU * TAU * psd(x);
            let other = RoughnessSpectrum::from_psd(PsdConvention::PerCycle, square, &q).unwrap();
            close(other.moments().m0, found.m0, 1e-13);
        }
    }

    #[test]
    fn refuses_what_is_no_psd() {
        let of = |limits: &[f64], value: f64| {
            RoughnessSpectrum::from_psd(PsdConvention::Angular, |_| value, limits)
        };
        for limits in [&[1.0][..], &[], &[1.0, 1.0], &[0.0, 1.0], &[1.0, f64::INFINITY]] {
            assert!(of(limits, 1.0).is_err(), "{limits:?}");
        }
        for value in [-1.0, f64::NAN, f64::INFINITY, f64::MAX] {
            assert!(of(&[1e5, 1e6], value).is_err(), "{value}");
        }
        // A band of one rounding and one of 300 decades.
        assert!(of(&[1.0, 1.0 + f64::EPSILON], 1.0).unwrap().moments().m0 > 0.0);
        assert!(of(&[1e-150, 1e150], 0.0).is_ok());
    }
}
