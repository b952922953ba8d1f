//! Spectra of a surface in the two forms models take.

use crate::{SpectralMoments, SurfaceError};

/// All waves of one wavenumber.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Shell {
    /// Angular wavenumber |q| \[rad/m\].
    pub wavenumber: f64,
    /// Height variance carried by these waves \[m²\].
    pub variance: f64,
}

/// Height variance by wavenumber: the discrete two-dimensional PSD, summed over shells of equal
/// |q|. Sorted by rising wavenumber, without the mean. Of a PSD `C(q)` \[m⁴\] with `m0 = ∫ C d²q` a shell has `2π ∫ C q dq`;
/// one against cycles per metre is (2π)² as large.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RoughnessSpectrum {
    shells: Vec<Shell>,
}

impl RoughnessSpectrum {
    /// Takes shells in order of strictly rising wavenumber.
    ///
    /// # Errors
    /// [`SurfaceError::Spectrum`] for a wavenumber that is not finite, positive and rising, or a
    /// variance that is negative or not finite.
    pub fn new(shells: Vec<Shell>) -> Result<Self, SurfaceError> {
        let entries = shells.iter().map(|shell| [shell.wavenumber, shell.variance]);
        check(["wavenumber", "variance"], entries)?;
        Ok(Self { shells })
    }

    /// The shells, by rising wavenumber.
    pub fn shells(&self) -> &[Shell] {
        &self.shells
    }

    /// Moments by the spectrum: `m0 = sum S`, `m2 = sum S q^2 / 2`, `m4 = 3 sum S q^4 / 8`.
    pub fn moments(&self) -> SpectralMoments {
        let mut moments = SpectralMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
        for shell in &self.shells {
            let q2 = shell.wavenumber * shell.wavenumber;
            moments.m0 += shell.variance;
            moments.m2 += 0.5 * shell.variance * q2;
            moments.m4 += 0.375 * shell.variance * q2 * q2;
        }
        moments
    }
}

/// One sinusoid of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Wave {
    /// Frequency f = 1/wavelength \[1/m\].
    pub frequency: f64,
    /// Amplitude Δ of the sinusoid \[m\].
    pub amplitude: f64,
}

/// Amplitude of a profile's sinusoids by frequency, averaged over profiles: what the stacked
/// multiscale models take. It depends on the record length, which therefore comes with it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AmplitudeSpectrum {
    waves: Vec<Wave>,
    record_length: f64,
}

impl AmplitudeSpectrum {
    /// Takes waves in order of strictly rising frequency, and the length of the profiles in
    /// metres.
    ///
    /// # Errors
    /// [`SurfaceError::Spectrum`] for a frequency that is not finite, positive and rising, an
    /// amplitude that is negative or not finite, or a record length that is not positive.
    pub fn new(waves: Vec<Wave>, record_length: f64) -> Result<Self, SurfaceError> {
        let entries = waves.iter().map(|wave| [wave.frequency, wave.amplitude]);
        check(["frequency", "amplitude"], entries)?;
        if !(record_length.is_finite() && record_length > 0.0) {
            return Err(SurfaceError::Spectrum {
                index: 0,
                what: "record length",
                value: record_length,
                limit: "must be finite and positive",
            });
        }
        Ok(Self { waves, record_length })
    }

    /// The waves, by rising frequency.
    pub fn waves(&self) -> &[Wave] {
        &self.waves
    }

    /// Length of the profiles \[m\].
    pub fn record_length(&self) -> f64 {
        self.record_length
    }

    /// B_max = max Δ f, the largest ratio of amplitude to wavelength \[-\]; 0 if there is no wave.
    pub fn max_amplitude_ratio(&self) -> f64 {
        self.waves.iter().map(|w| w.amplitude * w.frequency).fold(0.0, f64::max)
    }
}

/// Each entry is finite, its first number rises from above 0, and its second is not negative.
fn check(
    names: [&'static str; 2],
    entries: impl Iterator<Item = [f64; 2]>,
) -> Result<(), SurfaceError> {
    let mut last = 0.0;
    for (index, [place, amount]) in entries.enumerate() {
        let fault = |what, value, limit| SurfaceError::Spectrum { index, what, value, limit };
        if !(place.is_finite() && place > last) {
            return Err(fault(names[0], place, "must be finite, positive and rising"));
        }
        if !(amount.is_finite() && amount >= 0.0) {
            return Err(fault(names[1], amount, "must be finite and not negative"));
        }
        last = place;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_unsorted_or_negative_shells() {
        let shell = |wavenumber, variance| Shell { wavenumber, variance };
        for bad in [
            vec![shell(2.0, 1.0), shell(1.0, 1.0)],
            vec![shell(0.0, 1.0)],
            vec![shell(1.0, -1.0)],
            vec![shell(f64::NAN, 1.0)],
        ] {
            assert!(RoughnessSpectrum::new(bad).is_err());
        }
    }

    #[test]
    fn one_wave_has_bandwidth_three_halves() {
        // All waves of one |q|, isotropic: alpha = 3/2, the smallest possible (Nayak 1971).
        let one = RoughnessSpectrum::new(vec![Shell { wavenumber: 3e5, variance: 2e-14 }]).unwrap();
        assert!((one.moments().bandwidth() - 1.5).abs() < 1e-15);
    }
}
