//! What a spectrum says of the scales of a map: noise, cut-off, roll-off, Hurst exponent, and D and G of a profile.

use crate::StatsError;
use crate::noise::NoiseFloor;
use crate::spectrum::{ProfileBin, Ring};
use contact_types::{FractalParameters, Grid};
use std::f64::consts::TAU;

/// Ratio of frequencies in the Weierstrass–Mandelbrot function that defines G.
const GAMMA: f64 = 1.5;

/// Logarithmic bins per octave.
const PER_OCTAVE: f64 = 6.0;

/// Bins a fit needs, and the ratio of wavelengths they must span.
const MIN_BINS: usize = 4;
const MIN_SPAN: f64 = 2.0;

/// Share of the gradient variance at wavelengths longer than the cut-off.
const CUTOFF_SHARE: f64 = 0.999;

/// Scales and power law of a PSD.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpectralScales {
    /// Noise at the level where the PSD stops falling; absent if it falls to the end.
    pub(crate) noise: Option<NoiseFloor>,
    /// 99.9 % of the gradient variance that stands out of the noise is at longer wavelengths (m);
    /// two pixels at least.
    pub(crate) cutoff: Option<f64>,
    /// Wavelength beyond which the PSD is flat (m); absent if the map shows none.
    pub(crate) rolloff: Option<f64>,
    /// Power law between the wavelengths of `fractal_range`; absent if they hold less than four
    /// bins or an octave.
    pub(crate) power_law: Option<PowerLaw>,
    /// Shortest and longest wavelength of the power law (m).
    pub(crate) fractal_range: Option<[f64; 2]>,
}

impl SpectralScales {
    /// From the radial PSD of a map of known rms height (m).
    pub(crate) fn of_map(
        rings: &[Ring],
        grid: Grid,
        rms_height: f64,
        fractal_range: Option<[f64; 2]>,
    ) -> Self {
        let ([dy, dx], [ly, lx]) = (grid.pixel(), grid.size());
        // A floor at the rounding of the transform is no noise.
        let noise = NoiseFloor::of(rings, [dy, dx]).filter(|n| n.rms > 1e-9 * rms_height);
        let limits = [2.0 * dy.min(dx), 0.5 * ly.min(lx)];
        let fit = |range| PowerLaw::of(&radial_points(rings, range));
        Self::of_rings(rings, noise, limits, fractal_range, fit)
    }

    /// From a PSD with this noise. `limits` are the shortest cut-off and, without a roll-off, the
    /// longest wavelength of the power law (m).
    pub(crate) fn of_rings(
        rings: &[Ring],
        noise: Option<NoiseFloor>,
        [shortest, longest]: [f64; 2],
        fractal_range: Option<[f64; 2]>,
        fit: impl Fn([f64; 2]) -> Option<PowerLaw>,
    ) -> Self {
        // The wave at which the reliable ones end is one of them, whatever its last digit says.
        let reliable = noise.and_then(|n| n.reliable).unwrap_or(0.0) * (1.0 - 1e-12);
        let end = rings.partition_point(|r| TAU / r.wavenumber >= reliable);
        let cutoff = cutoff(&rings[..end], shortest);
        let rolloff = cutoff.and_then(|short| rolloff(rings, short));
        let found = cutoff.map(|short| [short, rolloff.unwrap_or(longest)]);
        let range = fractal_range.or(found);
        let power_law = range.and_then(fit);
        Self { noise, cutoff, rolloff, power_law, fractal_range: power_law.and(range) }
    }
}

/// Whether the wavelengths of a fit make a range.
pub(crate) fn check_range(range: Option<[f64; 2]>) -> Result<(), StatsError> {
    let Some([short, long]) = range else { return Ok(()) };
    let requirement = "wavelengths must be finite and greater than 0, the shorter one first";
    let positive = short.is_finite() && short > 0.0;
    StatsError::require("shortest wavelength of the fractal fit", short, positive, requirement)?;
    let longer = long.is_finite() && long > short;
    StatsError::require("longest wavelength of the fractal fit", long, longer, requirement)
}

/// A power law fitted to a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PowerLaw {
    /// d ln(PSD) / d ln(frequency) (-).
    slope: f64,
    /// ln of the PSD at frequency 1.
    intercept: f64,
    /// Shortest and longest wavelength used (m).
    pub(crate) range: [f64; 2],
}

/// A point of a spectrum in logarithms, with the number of waves averaged.
#[derive(Debug, Clone, Copy)]
struct LogBin {
    ln_frequency: f64,
    ln_psd: f64,
    waves: f64,
}

impl LogBin {
    /// ln of a mean of n exponential variables scatters by 1/n; real spectra stray from a power law by some 20 % anyway.
    fn weight(&self) -> f64 {
        1.0 / (1.0 / self.waves + 0.04)
    }
}

impl PowerLaw {
    /// Hurst exponent if this is the slope of an isotropic two-dimensional PSD, `-2 (1 + H)`.
    pub(crate) fn hurst(&self) -> f64 {
        -0.5 * self.slope - 1.0
    }

    /// D and G if this is the one-sided PSD of a profile, in m³ against cycles per metre:
    ///
    /// ```math
    /// S(f) = \frac{G^{2(D-1)}}{2\ln\gamma} f^{-(5-2D)}, \qquad \gamma = 1.5
    /// ```
    ///
    /// `D = (5 + slope)/2`; `None` for G unless 1 < D < 2, where the formula has a meaning.
    ///
    /// # Source
    /// Majumdar & Bhushan (1990), doi:10.1115/1.2920243.
    pub(crate) fn fractal_of_profile(&self) -> (f64, Option<FractalParameters>) {
        let dimension = 0.5 * (5.0 + self.slope);
        let ln_roughness = ((2.0 * GAMMA.ln()).ln() + self.intercept) / (2.0 * (dimension - 1.0));
        let roughness = ln_roughness.exp();
        let defined = dimension > 1.0 && dimension < 2.0 && roughness.is_normal();
        (dimension, defined.then_some(FractalParameters { dimension, roughness }))
    }

    /// D and G of the profiles of an isotropic surface, if this is its radial PSD: that of a
    /// profile is the integral across it,
    ///
    /// ```math
    /// S(f) = 4\pi \int_{-\infty}^{\infty} C\big(\sqrt{(2\pi f)^2 + q_y^2}\big) \, dq_y
    ///      = 4\pi\, C_0\, (2\pi f)^{-1-2H} \int_{-\infty}^{\infty} (\cosh u)^{-1-2H} du,
    ///      \qquad D = 2 - H
    /// ```
    ///
    /// for `C = C0 q^(-2-2H)` at all wavelengths.
    pub(crate) fn fractal_of_surface(&self) -> (f64, Option<FractalParameters>) {
        let exponent = -1.0 - 2.0 * self.hurst();
        // Trapezoidal rule: exact to rounding for this integrand (analytic, decaying both ways).
        let (step, reach) = (0.25, 40.0 / -exponent.min(-0.1));
        let points = (reach / step) as i32;
        let integral: f64 =
            (-points..=points).map(|k| step * (step * f64::from(k)).cosh().powf(exponent)).sum();
        // The fit is against f: C = exp(intercept) f^slope = C0 (2 pi f)^slope.
        let ln_c0 = self.intercept - self.slope * TAU.ln();
        let intercept = (2.0 * TAU * integral).ln() + ln_c0 + exponent * TAU.ln();
        Self { slope: exponent, intercept, ..*self }.fractal_of_profile()
    }

    /// `None` of less than four bins or one octave with waves.
    fn of(points: &[LogBin]) -> Option<Self> {
        let (first, last) = (points.first()?, points.last()?);
        let span = (last.ln_frequency - first.ln_frequency).exp();
        if points.len() < MIN_BINS || span < MIN_SPAN {
            return None;
        }
        let (slope, intercept, _) = line(points, |p| p.ln_frequency)?;
        let range = [(-last.ln_frequency).exp(), (-first.ln_frequency).exp()];
        Some(Self { slope, intercept, range })
    }
}

/// Fits a power law to a profile spectrum between two wavelengths (m).
pub(crate) fn fit_profile(bins: &[ProfileBin], [short, long]: [f64; 2]) -> Option<PowerLaw> {
    let bins = bins.iter().filter(|b| {
        let wavelength = 1.0 / b.frequency;
        wavelength >= short && wavelength <= long
    });
    PowerLaw::of(&log_bins(bins.map(|b| (b.frequency, b.psd, 1.0))))
}

/// Shortest wavelength that matters: 99.9 % of the gradient variance belongs to longer ones (m).
/// Never shorter than `shortest`. `None` for a flat map.
fn cutoff(rings: &[Ring], shortest: f64) -> Option<f64> {
    let gradient = |r: &Ring| r.variance * r.wavenumber * r.wavenumber;
    let total: f64 = rings.iter().map(gradient).sum();
    let mut below = 0.0;
    let reaches = |ring: &&Ring| {
        below += gradient(ring);
        total > 0.0 && below >= CUTOFF_SHARE * total
    };
    rings.iter().find(reaches).map(|ring| (TAU / ring.wavenumber).max(shortest))
}

/// Roll-off wavelength (m), beyond which the PSD is flat: least squares of
/// `ln C = c - 2 (1 + H) max(0, ln q/q0)` over c, H and q0, down to the wavelength `shortest`. `None` unless
/// the bend improves the fit by more than three standard deviations and leaves three bins on its flat side.
fn rolloff(rings: &[Ring], shortest: f64) -> Option<f64> {
    let points = radial_points(rings, [shortest, f64::INFINITY]);
    let (first, last) = (points.first()?.ln_frequency, points.last()?.ln_frequency);
    if points.len() < 2 * MIN_BINS {
        return None;
    }
    let (.., straight) = line(&points, |p| p.ln_frequency)?;
    let step = 0.25 * 2f64.ln() / PER_OCTAVE;
    let steps = ((last - first) / step) as usize;
    let bend = |ln_q0: f64| {
        let (slope, _, misfit) = line(&points, |p| (p.ln_frequency - ln_q0).max(0.0))?;
        Some((misfit, slope, ln_q0))
    };
    let (misfit, slope, ln_q0) = (1..steps)
        .filter_map(|i| bend(first + i as f64 * step))
        .min_by(|a, b| a.0.total_cmp(&b.0))?;
    let flat = points.iter().filter(|p| p.ln_frequency < ln_q0).count();
    let steep = points.len() - flat;
    let found = straight - misfit > 9.0 && slope < -1.0 && flat >= 3 && steep >= MIN_BINS;
    found.then(|| (-ln_q0).exp())
}

/// Rings that lie within two wavelengths with all their waves, in logarithmic bins.
fn radial_points(rings: &[Ring], [short, long]: [f64; 2]) -> Vec<LogBin> {
    let inside = |r: &&Ring| {
        let (low, high) = (r.wavenumber - 0.5 * r.width, r.wavenumber + 0.5 * r.width);
        TAU >= short * high && TAU <= long * low.max(0.5 * r.width)
    };
    let rings = rings.iter().filter(inside);
    log_bins(rings.map(|r| (r.wavenumber / TAU, r.psd, r.waves as f64 / 2.0)))
}

/// Averages over logarithmic bins, counted from the first frequency, so that they are the same in any unit; bins without
/// waves, or with nothing but rounding, are left out.
fn log_bins(spectrum: impl Iterator<Item = (f64, f64, f64)>) -> Vec<LogBin> {
    let mut bins = std::collections::BTreeMap::<i64, [f64; 3]>::new();
    let mut first = None;
    for (frequency, psd, waves) in spectrum {
        let ln = frequency.ln();
        let octaves = (frequency / *first.get_or_insert(frequency)).log2();
        let sums = bins.entry((octaves * PER_OCTAVE).round() as i64).or_default();
        for (sum, part) in sums.iter_mut().zip([waves, waves * psd, waves * ln]) {
            *sum += part;
        }
    }
    let largest = bins.values().map(|s| s[1] / s[0]).fold(0.0, f64::max);
    bins.values()
        .filter(|[waves, power, _]| power / waves > 1e-24 * largest)
        .map(|&[waves, power, ln]| LogBin {
            ln_frequency: ln / waves,
            ln_psd: (power / waves).ln(),
            waves,
        })
        .collect()
}

/// Weighted least squares `ln C = intercept + slope x`: (slope, intercept, weighted misfit).
fn line(points: &[LogBin], x: impl Fn(&LogBin) -> f64) -> Option<(f64, f64, f64)> {
    let mean = |f: &dyn Fn(&LogBin) -> f64| {
        points.iter().map(|p| p.weight() * f(p)).sum::<f64>()
            / points.iter().map(LogBin::weight).sum::<f64>()
    };
    let (mx, my) = (mean(&x), mean(&|p| p.ln_psd));
    let (sxx, sxy) =
        (mean(&|p| (x(p) - mx) * (x(p) - mx)), mean(&|p| (x(p) - mx) * (p.ln_psd - my)));
    if sxx <= 0.0 {
        return None;
    }
    let slope = sxy / sxx;
    let misfit = |p: &LogBin| (p.ln_psd - my - slope * (x(p) - mx)).powi(2);
    Some((slope, my - slope * mx, points.iter().map(|p| p.weight() * misfit(p)).sum()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    /// An exact Weierstrass–Mandelbrot spectrum gives back D and G.
    #[test]
    fn d_and_g_of_the_spectrum_that_defines_them() {
        for (d, g) in [(1.2, 3e-11), (1.5, 1e-12), (1.9, 7e-9f64)] {
            let s = |f: f64| g.powf(2.0 * (d - 1.0)) / (2.0 * GAMMA.ln()) * f.powf(2.0 * d - 5.0);
            let bins: Vec<ProfileBin> = (0..200)
                .map(|i| 1e4 * 1.03f64.powi(i))
                .map(|frequency| ProfileBin { frequency, psd: s(frequency) })
                .collect();
            let fit = fit_profile(&bins, [0.0, 1.0]).unwrap();
            let (dimension, parameters) = fit.fractal_of_profile();
            assert_relative_eq!(dimension, d, epsilon = 1e-4); // bins average over a sixth octave
            close(parameters.unwrap().roughness, g, 0.05);
        }
    }

    /// H = 1/2: the integral of sech² is 2, so that S = 8 pi C0 (2 pi f)^-2; G follows with
    /// D = 3/2 from S = G f^-2 / (2 ln 1.5).
    #[test]
    fn profile_of_an_isotropic_surface() {
        let c0 = 1e-8; // m, as C = C0 q^-3 is in m⁴
        let intercept = (c0 * TAU.powi(-3)).ln();
        let law = PowerLaw { slope: -3.0, intercept, range: [1e-6, 1e-4] };
        let (dimension, parameters) = law.fractal_of_surface();
        close(dimension, 1.5, 1e-15);
        let roughness = 2.0 * 1.5f64.ln() * 8.0 * PI * c0 / TAU.powi(2);
        close(parameters.unwrap().roughness, roughness, 1e-12);
    }

    #[test]
    fn outside_its_domain_there_is_no_g() {
        for slope in [-3.1, -0.9] {
            let law = PowerLaw { slope, intercept: -30.0, range: [1e-6, 1e-4] };
            assert!(law.fractal_of_profile().1.is_none());
        }
    }
}
