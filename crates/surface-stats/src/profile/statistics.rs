//! The one call most users of profiles need.

use super::moments::moments_by_spacing;
use super::parameters::{ProfileParameters, parameters};
use super::roughness::{choose_setting, roughness};
use super::{
    AtSpacing, LEAST_POINTS, MomentScatter, Roughness, Setting, Trace, TraceSpectrum, moments,
};
use crate::noise::NoiseFloor;
use crate::options::check_range;
use crate::{HeightStatistics, SpectralScales, StatsError, Warning, height_step, scale};
use contact_types::{AsperityStatistics, FractalParameters, SpectralMoments};

/// How statistics of profiles are taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfileOptions {
    /// Degree of the polynomial taken off every trace by least squares; 1 is the line.
    pub degree: usize,
    /// λs (m): waves shorter than this are taken off, for the moments too.
    pub short: Option<f64>,
    /// λc (m): waves longer than this are taken off, for the moments too; without it the moments are
    /// those of all waves, and only the roughness parameters have a cut-off, chosen by their Ra.
    pub cutoff: Option<f64>,
    /// Shortest and longest wavelength of the fit of the Hurst exponent (m).
    pub fractal_range: Option<[f64; 2]>,
    /// Height step of the data as measured (m), if cleaning has hidden it.
    pub height_step: Option<f64>,
}

impl Default for ProfileOptions {
    fn default() -> Self {
        Self { degree: 1, short: None, cutoff: None, fractal_range: None, height_step: None }
    }
}

/// A parameter of ISO 21920-2 over several traces.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterMean {
    /// Its symbol, `Ra`.
    pub symbol: String,
    /// Its mean (m, or a number); absent where a trace does not have it.
    pub mean: Option<f64>,
    /// Its standard deviation from trace to trace, of two or more.
    pub deviation: Option<f64>,
}

/// Everything a contact model can ask of traces of one surface. SI units; absent where undefined.
///
/// ```
/// use std::f64::consts::{PI, TAU};
/// use surface_stats::profile::{ProfileOptions, ProfileStatistics, Trace};
///
/// // A sine of 1 µm and 50 µm over 6 mm: Ra = 2A/π.
/// let height = |i: i32| 1e-6 * (TAU * f64::from(i) * 0.5e-6 / 50e-6).sin();
/// let trace = Trace::new(0.5e-6, (0..=12_000).map(height).collect())?;
/// let statistics = ProfileStatistics::of(&[trace], &ProfileOptions::default())?;
/// let roughness = statistics.roughness.as_ref().unwrap();
/// assert_eq!((roughness[0].setting.cutoff, roughness[0].sections), (0.8e-3, 5));
/// let ra = &statistics.roughness_mean().unwrap()[0];
/// assert_eq!(ra.symbol, "Ra");
/// assert!((ra.mean.unwrap() / (2e-6 / PI) - 1.0).abs() < 0.01);
/// # Ok::<(), surface_stats::StatsError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ProfileStatistics {
    /// How many traces.
    pub traces: usize,
    /// Points of each.
    pub points: usize,
    /// Their spacing (m).
    pub spacing: f64,
    /// From the first to the last point (m).
    pub length: f64,
    /// What was taken off first.
    pub options: ProfileOptions,
    /// Of the primary profile: of the whole traces as they are used, one per trace.
    pub(super) primary: Vec<ProfileParameters>,
    /// Roughness parameters, one per trace, or why there are none.
    pub roughness: Result<Vec<Roughness>, StatsError>,
    /// m0, m2, m4 by finite differences: means over the traces.
    pub moments: SpectralMoments,
    /// Those of each trace.
    pub each: Vec<SpectralMoments>,
    /// How far another set of traces would scatter.
    pub scatter: MomentScatter,
    /// m2 and m4 over longer distances, of the first trace.
    pub by_spacing: Vec<AtSpacing>,
    /// m0, m2, m4 by waves, under a Hann window.
    pub spectral: SpectralMoments,
    /// Shares of m2 and m4 of these waves that finite differences see; absent for flat traces.
    pub seen: Option<[f64; 2]>,
    /// Skewness of all heights (-).
    pub skewness: Option<f64>,
    /// Kurtosis of all heights (-).
    pub kurtosis: Option<f64>,
    /// Nayak's m0 m4 / m2² (-).
    pub bandwidth: Option<f64>,
    /// Summits of the isotropic Gaussian surface with these moments.
    pub asperities: Option<AsperityStatistics>,
    /// H from the slope -(1 + 2H) of the PSD over `fractal_range` (-).
    pub hurst: Option<f64>,
    /// D and G of that power law; absent unless 1 < D < 2.
    pub fractal: Option<FractalParameters>,
    /// Wavelengths of the fit (m).
    pub fractal_range: Option<[f64; 2]>,
    /// Roll-off wavelength (m); absent if the traces show none.
    pub rolloff: Option<f64>,
    /// 99.9 % of the slope variance that stands out of the noise is at longer wavelengths (m).
    pub cutoff: Option<f64>,
    /// Rms of white noise at the level where the PSD stops falling (m).
    pub noise_rms: Option<f64>,
    /// Waves shorter than this cannot be told from that noise (m).
    pub reliable_wavelength: Option<f64>,
    /// Step of the heights given (m); absent if they are continuous.
    pub height_step: Option<f64>,
    /// What to know before using these numbers, worst first.
    pub warnings: Vec<Warning>,
}

impl ProfileStatistics {
    /// Takes all statistics of traces of one surface, of the same length and spacing.
    ///
    /// # Errors
    /// [`StatsError::ShortTrace`] if `cutoff` is more than half of a trace, [`StatsError::Shape`] for
    /// traces of different lengths, [`StatsError::OutOfRange`], [`StatsError::BadSetting`].
    pub fn of(traces: &[Trace], options: &ProfileOptions) -> Result<Self, StatsError> {
        Self::with_spectrum(traces, options).map(|(statistics, ..)| statistics)
    }

    /// The same, with the traces as they were used and their spectrum.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn with_spectrum(
        traces: &[Trace],
        options: &ProfileOptions,
    ) -> Result<(Self, Vec<Trace>, TraceSpectrum), StatsError> {
        check_range(options.fractal_range)?;
        let Some(first) = traces.first() else {
            let (what, needed) = ("statistics of profiles", LEAST_POINTS);
            return Err(StatsError::TooFewPoints { what, needed, found: 0 });
        };
        if let Some(other) = traces.iter().find(|t| t.len() != first.len()) {
            let (expected, found) = (first.len(), other.len());
            return Err(StatsError::Shape { what: "traces of one surface", expected, found });
        }
        let step = options.height_step.or_else(|| height_step(first.heights()));
        let mut levelled = Vec::with_capacity(traces.len());
        for trace in traces {
            scale::check(trace.as_map())?;
            levelled.push(trace.levelled(options.degree)?);
        }
        let setting = match options.cutoff {
            Some(cutoff) => Ok(Setting::of_cutoff(cutoff, options.short, first.spacing())),
            None => choose_setting(&levelled, options.short),
        };
        let of_all = |setting: Setting| -> Result<Vec<Roughness>, StatsError> {
            levelled.iter().map(|trace| roughness(trace, &setting)).collect()
        };
        let roughness = setting.and_then(of_all);
        if options.cutoff.is_some()
            && let Err(refused) = roughness
        {
            return Err(refused); // what was asked for must be possible
        }
        // The profile whose moments count is filtered if that was asked for.
        let used = if options.short.is_none() && options.cutoff.is_none() {
            levelled
        } else {
            let filtered = levelled.iter().map(|t| t.filtered(options.short, options.cutoff));
            filtered.collect::<Result<Vec<Trace>, _>>()?
        };
        let spectrum = TraceSpectrum::of(&used);
        let statistics = Self::of_used(&used, &spectrum, roughness, step, options)?;
        Ok((statistics, used, spectrum))
    }

    fn of_used(
        used: &[Trace],
        spectrum: &TraceSpectrum,
        roughness: Result<Vec<Roughness>, StatsError>,
        height_step: Option<f64>,
        options: &ProfileOptions,
    ) -> Result<Self, StatsError> {
        let first = &used[0];
        let each: Vec<SpectralMoments> = used.iter().map(moments).collect();
        let mean =
            |of: fn(&SpectralMoments) -> f64| each.iter().map(of).sum::<f64>() / each.len() as f64;
        let mean = SpectralMoments { m0: mean(|m| m.m0), m2: mean(|m| m.m2), m4: mean(|m| m.m4) };
        let heights: Vec<HeightStatistics> =
            used.iter().map(|t| HeightStatistics::of(t.as_map())).collect();
        // Third and fourth moments of all heights about the mean of their own trace.
        let shape = |of: fn(&HeightStatistics) -> Option<f64>, power: i32| {
            let sum: Option<f64> =
                heights.iter().map(|h| Some(of(h)? * h.rms_height.powi(power))).sum();
            let shape = sum? / heights.len() as f64 / mean.m0.sqrt().powi(power);
            Some(shape).filter(|s| s.is_finite())
        };
        let SpectralScales { noise, cutoff, rolloff, power_law, .. } =
            spectrum.scales(mean.m0.sqrt(), options.fractal_range);
        let fractal = power_law.map(|law| law.fractal_of_profile());
        let mut statistics = Self {
            traces: used.len(),
            points: first.len(),
            spacing: first.spacing(),
            length: first.length(),
            options: *options,
            primary: used.iter().map(|trace| parameters(trace, 1)).collect::<Result<_, _>>()?,
            roughness,
            moments: mean,
            scatter: MomentScatter::of(used),
            by_spacing: moments_by_spacing(first),
            spectral: spectrum.moments(),
            seen: spectrum.seen(),
            skewness: shape(|h| h.skewness, 3),
            kurtosis: shape(|h| h.kurtosis, 4),
            bandwidth: Some(mean.bandwidth()).filter(|b| b.is_finite()),
            asperities: AsperityStatistics::from_moments(mean).ok(),
            hurst: fractal.map(|(dimension, _)| 2.0 - dimension),
            fractal: fractal.and_then(|(_, parameters)| parameters),
            fractal_range: power_law.map(|law| law.range),
            rolloff,
            cutoff,
            noise_rms: noise.map(|n| n.rms),
            reliable_wavelength: noise.and_then(|n| n.reliable),
            height_step,
            each,
            warnings: Vec::new(),
        };
        statistics.warnings = statistics.judge(noise);
        Ok(statistics)
    }

    /// 95 % interval of a moment over traces like these: 0 for m0, 1 for m2, 2 for m4.
    pub fn interval(&self, moment: usize) -> Option<[f64; 2]> {
        let SpectralMoments { m0, m2, m4 } = self.moments;
        self.scatter.interval(moment, [m0, m2, m4][moment])
    }

    /// Mean over the traces and, of two or more, the standard deviation of each roughness
    /// parameter.
    pub fn roughness_mean(&self) -> Option<Vec<ParameterMean>> {
        let all = self.roughness.as_ref().ok()?;
        Some(mean_of(&all.iter().map(|r| r.parameters).collect::<Vec<_>>(), 'R'))
    }

    /// The same of the primary profile.
    pub fn primary_mean(&self) -> Vec<ParameterMean> {
        mean_of(&self.primary, 'P')
    }

    /// Warnings, by the limits of those of maps.
    fn judge(&self, noise: Option<NoiseFloor>) -> Vec<Warning> {
        let mut warnings = Vec::new();
        if self.moments.m0 <= 0.0 {
            return vec![Warning::Flat];
        }
        // A filter that took the steps' waves away took their noise too.
        let step = self.height_step.filter(|_| self.options.short.is_none());
        warnings.extend(Warning::of_noise(self.moments, [self.spacing; 2], step, noise));
        warnings.extend(self.seen.and_then(|[m2, _]| Warning::of_resolution(m2.sqrt())));
        warnings.extend(Warning::of_distribution(self.skewness, self.kurtosis, self.bandwidth));
        warnings.extend(Warning::of_hurst(self.hurst));
        warnings
    }
}

fn mean_of(all: &[ProfileParameters], letter: char) -> Vec<ParameterMean> {
    let n = all.len() as f64;
    let one = |k: usize| {
        let values: Option<Vec<f64>> = all.iter().map(|p| p[k].1).collect();
        let mean = values.as_ref().map(|v| v.iter().sum::<f64>() / n);
        let deviation = values.zip(mean).filter(|_| all.len() > 1).map(|(values, mean)| {
            let squares = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>();
            (squares / (n - 1.0)).sqrt()
        });
        ParameterMean { symbol: format!("{letter}{}", all[0][k].0), mean, deviation }
    };
    (0..all.first().map_or(0, |p| p.len())).map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::rough;
    use crate::{Edges, StatsOptions, SurfaceStatistics};
    use approx::assert_relative_eq;
    use contact_types::Grid;

    /// Rows of an isotropic map: their moments, Hurst exponent and scales are those that the map's own
    /// statistics give, within their scatter.
    #[test]
    fn rows_of_an_isotropic_map_have_its_moments() {
        let grid = Grid::new([256, 2048], [1e-6, 1e-6]).unwrap();
        let map = rough(grid, 0.7, [128e-6, 8e-6], 0.4e-6, 11);
        let options = StatsOptions { edges: Edges::Periodic, ..StatsOptions::default() };
        let surface = SurfaceStatistics::of(&map, &options).unwrap();
        let traces: Vec<Trace> = map
            .heights()
            .chunks_exact(2048)
            .step_by(16)
            .map(|row| Trace::new(1e-6, row.to_vec()).unwrap())
            .collect();
        let of_lines = ProfileStatistics::of(&traces, &ProfileOptions::default()).unwrap();
        assert_relative_eq!(of_lines.moments.m2, surface.m2, max_relative = 0.1);
        assert_relative_eq!(of_lines.moments.m4, surface.m4, max_relative = 0.1);
        let [low, high] = of_lines.interval(0).unwrap();
        assert!(low < surface.m0 && surface.m0 < high, "{low:e} {high:e} {:e}", surface.m0);
        assert_relative_eq!(of_lines.rolloff.unwrap(), 128e-6, max_relative = 0.5);
        assert_relative_eq!(of_lines.cutoff.unwrap(), 8e-6, max_relative = 0.1);
        // The profile PSD bends near both ends (the book says how much): fit between them.
        let fractal_range = Some([20e-6, 80e-6]);
        let inner = ProfileOptions { fractal_range, ..ProfileOptions::default() };
        let hurst = ProfileStatistics::of(&traces, &inner).unwrap().hurst.unwrap();
        assert!((0.5..1.0).contains(&hurst), "{hurst}");
    }

    /// What is asked for and cannot be is an error; what was chosen and cannot be is said.
    #[test]
    fn a_cut_off_that_was_asked_for_must_fit() {
        let trace = Trace::new(1e-6, (0..100).map(|i| f64::from(i % 7) * 1e-8).collect()).unwrap();
        let asked = ProfileOptions { cutoff: Some(0.8e-3), ..ProfileOptions::default() };
        let refused = ProfileStatistics::of(std::slice::from_ref(&trace), &asked);
        assert!(matches!(refused, Err(StatsError::ShortTrace { .. })));
        let statistics = ProfileStatistics::of(&[trace], &ProfileOptions::default()).unwrap();
        assert!(matches!(statistics.roughness, Err(StatsError::ShortTrace { .. })));
        assert!(statistics.moments.m2 > 0.0);
    }

    /// Several traces: means and standard deviations of what each has.
    #[test]
    fn several_traces_average() {
        let trace = |a: f64| {
            let z = |i: i32| a * (f64::from(i) * 0.3).sin();
            Trace::new(1e-6, (0..4000).map(z).collect()).unwrap()
        };
        let of =
            |traces: &[Trace]| ProfileStatistics::of(traces, &ProfileOptions::default()).unwrap();
        let both = of(&[trace(1e-7), trace(3e-7)]);
        assert_relative_eq!(both.moments.m0, 2.5e-14, max_relative = 1e-2);
        let rq = both.primary_mean().swap_remove(1);
        assert_eq!(rq.symbol, "Pq");
        assert_relative_eq!(rq.mean.unwrap(), 2e-7 / 2f64.sqrt(), max_relative = 1e-2);
        // Two values 2e-7/√2 apart: 1e-7.
        assert_relative_eq!(rq.deviation.unwrap(), 1e-7, max_relative = 2e-2);
        let different = ProfileStatistics::of(
            &[trace(1e-7), trace(1e-7).part(0, 3000).unwrap()],
            &ProfileOptions::default(),
        );
        assert!(matches!(different, Err(StatsError::Shape { .. })));
    }
}
