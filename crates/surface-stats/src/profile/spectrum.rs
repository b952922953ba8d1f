//! Spectrum of traces: PSD, moments by waves, noise, scales, amplitudes.

use super::Trace;
use crate::StatsError;
use crate::fractal::{SpectralScales, fit_profile};
use crate::noise::{NoiseFloor, SIGNAL, last_octave};
use crate::spectrum::{ProfileBin, Ring, psd_1d};
use contact_types::{AmplitudeSpectrum, SpectralMoments, Wave};
use std::f64::consts::{PI, TAU};

/// Half the width of the running mean over frequencies, as a factor: a third of an octave in all.
const SMOOTHING: f64 = 1.122_462_048_309_373; // 2^(1/6)

/// A one-sided PSD falls as f^-(1 + 2H); flatter than this in the last octave is noise.
const FLAT_SLOPE: f64 = -0.5;

/// One-sided PSD of traces under a Hann window, averaged over the traces.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceSpectrum {
    /// Frequency (1/m) and PSD (m³), rising.
    bins: Vec<ProfileBin>,
    /// Spacing of the points (m).
    spacing: f64,
    /// Traces averaged.
    traces: usize,
}

impl TraceSpectrum {
    /// Of levelled traces, one at least, of the same length and spacing.
    pub(crate) fn of(traces: &[Trace]) -> Self {
        let first = &traces[0];
        let mut bins = psd_1d(first);
        for trace in &traces[1..] {
            for (sum, bin) in bins.iter_mut().zip(psd_1d(trace)) {
                sum.psd += bin.psd;
            }
        }
        for bin in &mut bins {
            bin.psd /= traces.len() as f64;
        }
        Self { bins, spacing: first.spacing(), traces: traces.len() }
    }

    /// Distance of neighbouring frequencies (1/m).
    fn step(&self) -> f64 {
        self.bins.first().map_or(0.0, |bin| bin.frequency)
    }

    /// `∫ S df`, `∫ S q² df`, `∫ S q⁴ df` with q = 2πf.
    pub(crate) fn moments(&self) -> SpectralMoments {
        let sum = |weight: &dyn Fn(f64) -> f64| -> f64 {
            self.bins.iter().map(|b| b.psd * weight(TAU * b.frequency)).sum::<f64>() * self.step()
        };
        SpectralMoments { m0: sum(&|_| 1.0), m2: sum(&|q| q * q), m4: sum(&|q| (q * q) * (q * q)) }
    }

    /// Shares of m2 and m4 of these waves that finite differences of neighbouring points see: they read a wave as
    /// `[2 sin(qΔ/2)/Δ]²` instead of q², and as its square instead of q⁴. `None` for flat traces.
    pub(crate) fn seen(&self) -> Option<[f64; 2]> {
        let all = self.moments();
        let read = |q: f64| (2.0 * (0.5 * q * self.spacing).sin() / self.spacing).powi(2);
        let sum = |power: i32| -> f64 {
            let part = |b: &ProfileBin| b.psd * read(TAU * b.frequency).powi(power);
            self.bins.iter().map(part).sum::<f64>() * self.step()
        };
        (all.m2 > 0.0 && all.m4 > 0.0).then(|| [sum(1) / all.m2, sum(2) / all.m4])
    }

    /// Frequency (1/m) and PSD (m³) as a running mean over a third of an octave: one trace has one wave per frequency, and
    /// each scatters by 100 %.
    pub fn smoothed(&self) -> Vec<[f64; 2]> {
        let mut sums = Vec::with_capacity(self.bins.len() + 1);
        sums.push(0.0);
        for bin in &self.bins {
            sums.push(sums[sums.len() - 1] + bin.psd);
        }
        (1..=self.bins.len())
            .map(|k| {
                let [low, high] = self.band(k);
                let psd = (sums[high] - sums[low - 1]) / (high + 1 - low) as f64;
                [self.bins[k - 1].frequency, psd.max(0.0)]
            })
            .collect()
    }

    /// First and last number of the bins within a third of an octave around number `k`; the first of all is 1.
    fn band(&self, k: usize) -> [usize; 2] {
        let low = (k as f64 / SMOOTHING).ceil() as usize;
        let high = (k as f64 * SMOOTHING).floor() as usize;
        [low.clamp(1, k), high.clamp(k, self.bins.len())]
    }

    /// Expected amplitudes of the waves of a trace of this length, for the stacked models: those of a Gaussian profile have the
    /// mean square 2 S Δf and are Rayleigh distributed, with the mean `√(π S Δf / 2)`, S the smoothed PSD.
    ///
    /// # Errors
    /// [`StatsError::Surface`] if there are no waves.
    pub fn amplitudes(&self) -> Result<AmplitudeSpectrum, StatsError> {
        let step = self.step();
        let amplitude = |psd: f64| (0.5 * PI * psd * step).sqrt();
        let wave = |[frequency, psd]: [f64; 2]| Wave { frequency, amplitude: amplitude(psd) };
        Ok(AmplitudeSpectrum::new(self.smoothed().into_iter().map(wave).collect(), 1.0 / step)?)
    }

    /// Noise, cut-off, roll-off and power law. `rms_height` (m) tells noise from rounding.
    pub(crate) fn scales(&self, rms_height: f64, range: Option<[f64; 2]>) -> SpectralScales {
        let noise = self.noise().filter(|noise| noise.rms > 1e-9 * rms_height);
        let ring = |bin: &ProfileBin| Ring {
            wavenumber: TAU * bin.frequency,
            variance: bin.psd * self.step(),
            psd: bin.psd,
            waves: 2 * self.traces,
            width: 0.0,
        };
        let rings: Vec<Ring> = self.bins.iter().map(ring).collect();
        let limits = [2.0 * self.spacing, 0.5 / self.step()];
        let fit = |range| fit_profile(&self.bins, range);
        SpectralScales::of_rings(&rings, noise, limits, range, fit)
    }

    /// The floor in the last octave; `None` if the PSD still falls there.
    fn noise(&self) -> Option<NoiseFloor> {
        let nyquist = 0.5 / self.spacing;
        let last = self.bins.iter().filter(|bin| bin.frequency > 0.5 * nyquist);
        let psd = last_octave(&last.map(|bin| [bin.psd, 1.0]).collect::<Vec<_>>(), FLAT_SLOPE)?;
        // A running mean; in the flat octave most bins of its band: a line there, as where every second point is off, is no
        // surface.
        let mut above = vec![0];
        above.extend(self.bins.iter().scan(0, |count, bin| {
            *count += usize::from(bin.psd >= SIGNAL * psd);
            Some(*count)
        }));
        let smoothed = self.smoothed();
        let is_signal = |&k: &usize| {
            let [low, high] = self.band(k);
            let [frequency, smooth] = smoothed[k - 1];
            smooth >= SIGNAL * psd
                && (frequency <= 0.5 * nyquist
                    || 2 * (above[high] - above[low - 1]) > high + 1 - low)
        };
        let shortest = (1..=smoothed.len()).rev().find(is_signal);
        let reliable = shortest.map(|k| 1.0 / smoothed[k - 1][0]);
        Some(NoiseFloor { rms: (psd * nyquist).sqrt(), reliable })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use approx::assert_relative_eq;
    use rand_pcg::Pcg64;
    use rand_pcg::rand_core::Rng;

    fn uniform(random: &mut Pcg64) -> f64 {
        (f64::from(random.next_u32()) + 0.5) / 4_294_967_296.0 - 0.5
    }

    /// Of a wave all m2 and m4 sit at its frequency; differences of points an eighth of it apart see
    /// (sin(π/8)/(π/8))² and the square of that.
    #[test]
    fn what_differences_see_of_a_wave() {
        let z = |i: usize| 1e-7 * (TAU * i as f64 / 8.0 + 0.2).cos();
        let trace = Trace::new(1e-6, (0..8000).map(z).collect()).unwrap();
        let spectrum = TraceSpectrum::of(&[trace]);
        let [m2, m4] = spectrum.seen().unwrap();
        let share = ((PI / 8.0).sin() / (PI / 8.0)).powi(2);
        close(m2, share, 1e-3);
        close(m4, share * share, 1e-3);
        let q = TAU / 8e-6;
        close(spectrum.moments().m0, 0.5e-14, 1e-3);
        close(spectrum.moments().m2, 0.5e-14 * q * q, 1e-3);
    }

    /// Under a wave of 1 µm, which stands out; a line at the shortest wave is no surface.
    #[test]
    fn a_floor_of_white_noise_is_found() {
        for line in [0.0, 3e-9] {
            let (mut random, noise) = (Pcg64::new(4, 1), 3e-9 * 12f64.sqrt());
            let z = |i: usize| {
                let line = if i.is_multiple_of(2) { line } else { -line };
                1e-6 * (TAU * i as f64 / 500.0).sin() + noise * uniform(&mut random) + line
            };
            let trace = Trace::new(1e-6, (0..20_000).map(z).collect()).unwrap();
            let found = TraceSpectrum::of(&[trace]).scales(0.7e-6, None).noise.unwrap();
            assert!((300e-6..700e-6).contains(&found.reliable.unwrap()), "{found:?}");
            if line <= 0.0 {
                close(found.rms, 3e-9, 0.05);
            }
        }
    }

    /// A random walk has S ~ f^-2, H = 1/2: the fit over its middle decades finds it, and the
    /// amplitudes keep the variance: mean square 4/π of the mean squared.
    #[test]
    fn a_random_walk_has_a_hurst_exponent_of_one_half() {
        let mut random = Pcg64::new(9, 1);
        let mut walk = || {
            let mut height = 0.0;
            let step = |_| {
                height += 1e-9 * uniform(&mut random);
                height
            };
            Trace::new(1e-6, (0..16_384).map(step).collect()).unwrap()
        };
        let traces = [walk(), walk(), walk(), walk()];
        let spectrum = TraceSpectrum::of(&traces);
        let law = spectrum.scales(1e-8, Some([30e-6, 3e-3])).power_law.unwrap();
        let (dimension, _) = law.fractal_of_profile();
        assert_relative_eq!(2.0 - dimension, 0.5, epsilon = 0.05);
        let amplitudes = spectrum.amplitudes().unwrap();
        let variance: f64 = amplitudes.waves().iter().map(|w| w.amplitude.powi(2) * 2.0 / PI).sum();
        close(variance, spectrum.moments().m0, 0.2);
    }
}
