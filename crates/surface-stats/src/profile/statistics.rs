//! The one call most users of profiles need.

use super::moments::moments_by_spacing;
use super::parameters::means;
use super::roughness::{choose_setting, roughness};
use super::scatter::MomentScatter;
use super::trace::LEAST_POINTS;
use super::{ParameterMean, Roughness, Setting, Trace, TraceSpectrum, moments};
use crate::fractal::{SpectralScales, check_range};
use crate::noise::NoiseFloor;
use crate::{HeightStatistics, StatsError, Warning, height_step, scale};
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

/// Everything a contact model can ask of traces of one surface. SI units; absent where undefined.
///
/// ```
/// use std::f64::consts::{PI, TAU};
/// use surface_stats::profile::{ProfileOptions, ProfileStatistics, Trace};
///
/// // A sine of 1 µm and 50 µm over 6 mm: Ra = 2A/π.
/// let height = |i: i32| 1e-6 * (TAU * f64::from(i) * 0.5e-6 / 50e-6).sin();
/// let trace = Trace::new(0.5e-6, (0..=12_000).map(height).collect())?;
/// let (statistics, ..) = ProfileStatistics::of(&[trace], &ProfileOptions::default())?;
/// let roughness = statistics.roughness?;
/// assert_eq!((roughness.setting.cutoff, roughness.sections), (0.8e-3, 5));
/// let ra = &roughness.parameters[0];
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
    /// P parameters, of the primary profile: the whole traces, short of λs.
    pub primary: Vec<ParameterMean>,
    /// R parameters, or why there are none.
    pub roughness: Result<Roughness, StatsError>,
    /// m0, m2, m4 by finite differences: means over the traces.
    pub moments: SpectralMoments,
    /// Those of each trace.
    pub each: Vec<SpectralMoments>,
    /// Relative standard deviations of m0, m2, m4 from trace to trace, of two or more.
    pub between: Option<[f64; 3]>,
    /// 95 % intervals of m0, m2, m4 over traces like these; absent where these hold too few independent waves to tell.
    pub intervals: [Option<[f64; 2]>; 3],
    scatter: MomentScatter,
    /// Distances (m) of 1, 2, 4, … points, and the moments of the first trace with m2 and m4 by differences over them.
    pub by_spacing: Vec<(f64, SpectralMoments)>,
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
    /// Takes all statistics of traces of one surface, of the same length and spacing; with the traces as they were used and
    /// their spectrum.
    ///
    /// # Errors
    /// [`StatsError::ShortTrace`] if `cutoff` is more than half of a trace, [`StatsError::Shape`] for
    /// traces of different lengths, [`StatsError::OutOfRange`], [`StatsError::BadSetting`].
    pub fn of(
        traces: &[Trace],
        options: &ProfileOptions,
    ) -> Result<(Self, Vec<Trace>, TraceSpectrum), StatsError> {
        check_range(options.fractal_range)?;
        let Some(first) = traces.first() else {
            let (what, needed) = ("statistics of profiles", LEAST_POINTS);
            return Err(StatsError::TooFewPoints { what, needed, found: 0 });
        };
        let points = |trace: &Trace| trace.heights().len();
        if let Some(other) = traces.iter().find(|trace| points(trace) != points(first)) {
            let (expected, found) = (points(first), points(other));
            return Err(StatsError::Shape { what: "traces of one surface", expected, found });
        }
        let height_step = options.height_step.or_else(|| height_step(first.heights()));
        let mut levelled = Vec::with_capacity(traces.len());
        for trace in traces {
            scale::check(trace)?;
            levelled.push(trace.levelled(options.degree)?);
        }
        let setting = match options.cutoff {
            Some(cutoff) => Ok(Setting::asked(cutoff, options.short, first.spacing())),
            None => choose_setting(&levelled, options.short),
        };
        // The primary profile is short of λs, whichever is taken, and of nothing else.
        let short = setting.as_ref().map_or(options.short, |setting| setting.short);
        let roughness = setting.and_then(|setting| roughness(&levelled, setting));
        if let (Some(_), Err(refused)) = (options.cutoff, &roughness) {
            return Err(refused.clone()); // what was asked for must be possible
        }
        // The profile whose moments count is filtered if that was asked for.
        let filtered = |short, cutoff| -> Result<Vec<Trace>, StatsError> {
            levelled.iter().map(|trace| trace.filtered(short, cutoff)).collect()
        };
        let used = filtered(options.short, options.cutoff)?;
        let (first, spectrum) = (&used[0], TraceSpectrum::of(&used));
        let each: Vec<SpectralMoments> = used.iter().map(moments).collect();
        let mean =
            |of: fn(&SpectralMoments) -> f64| each.iter().map(of).sum::<f64>() / each.len() as f64;
        let mean = SpectralMoments { m0: mean(|m| m.m0), m2: mean(|m| m.m2), m4: mean(|m| m.m4) };
        let heights: Vec<HeightStatistics> =
            used.iter().map(|trace| HeightStatistics::of(trace)).collect();
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
        let scatter = MomentScatter::of(&used, &each);
        let interval = |k: usize| scatter.interval(k, [mean.m0, mean.m2, mean.m4][k]);
        let mut statistics = Self {
            traces: used.len(),
            points: first.heights().len(),
            spacing: first.spacing(),
            length: first.length(),
            options: *options,
            primary: means(&filtered(short, None)?, 1, 'P')?,
            roughness,
            moments: mean,
            between: scatter.between,
            intervals: [0, 1, 2].map(interval),
            scatter,
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
        Ok((statistics, used, spectrum))
    }

    /// The 95 % factor by which a quantity may be wrong whose logarithm changes by `exponents[k]` times that of the k-th
    /// of m0, m2, m4; `None` where the traces hold too few independent waves to tell.
    pub fn factor_of(&self, exponents: [f64; 3]) -> Option<f64> {
        self.scatter.factor_of(exponents)
    }

    /// Warnings, by the limits of those of maps.
    fn judge(&self, noise: Option<NoiseFloor>) -> Vec<Warning> {
        if let Some(flat) = Warning::flat(self.moments.rms_height(), 0.0) {
            return vec![flat];
        }
        // A filter that took the steps' waves away took their noise too.
        let step = self.height_step.filter(|_| self.options.short.is_none());
        let noisy = Warning::of_noise(self.moments, [self.spacing; 2], step, noise);
        let unresolved = self.seen.and_then(|[m2, _]| Warning::of_resolution(m2.sqrt()));
        let [not_gaussian, narrow] =
            Warning::of_distribution(self.skewness, self.kurtosis, self.bandwidth);
        let hurst = Warning::of_hurst(self.hurst);
        [noisy, unresolved, not_gaussian, narrow, hurst].into_iter().flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use crate::synthesis::rough;
    use crate::{Edges, StatsOptions, SurfaceStatistics};
    use contact_types::Grid;

    /// Also its Hurst exponent and scales, within their scatter.
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
        let (of_lines, ..) = ProfileStatistics::of(&traces, &ProfileOptions::default()).unwrap();
        close(of_lines.moments.m2, surface.m2, 0.1);
        close(of_lines.moments.m4, surface.m4, 0.1);
        let [low, high] = of_lines.intervals[0].unwrap();
        assert!(low < surface.m0 && surface.m0 < high, "{low:e} {high:e} {:e}", surface.m0);
        close(of_lines.rolloff.unwrap(), 128e-6, 0.5);
        close(of_lines.cutoff.unwrap(), 8e-6, 0.1);
        // The profile PSD bends near both ends (the book says how much): fit between them.
        let fractal_range = Some([20e-6, 80e-6]);
        let inner = ProfileOptions { fractal_range, ..ProfileOptions::default() };
        let hurst = ProfileStatistics::of(&traces, &inner).unwrap().0.hurst.unwrap();
        assert!((0.5..1.0).contains(&hurst), "{hurst}");
    }

    #[test]
    fn several_traces_average() {
        let trace = |a: f64, n: i32| {
            let z = |i: i32| a * (f64::from(i) * 0.3).sin();
            Trace::new(1e-6, (0..n).map(z).collect()).unwrap()
        };
        let of = |traces: [Trace; 2]| ProfileStatistics::of(&traces, &ProfileOptions::default());
        let (both, ..) = of([trace(1e-7, 4000), trace(3e-7, 4000)]).unwrap();
        close(both.moments.m0, 2.5e-14, 1e-2);
        let rq = &both.primary[1];
        assert_eq!(rq.symbol, "Pq");
        close(rq.mean.unwrap(), 2e-7 / 2f64.sqrt(), 1e-2);
        // Two values 2e-7/√2 apart: 1e-7.
        close(rq.deviation.unwrap(), 1e-7, 2e-2);
        // λc is none of the primary profile's.
        let primary = |cutoff| {
            let (cutoff, short) = (Some(cutoff), Some(8e-6));
            let options = ProfileOptions { short, cutoff, ..ProfileOptions::default() };
            ProfileStatistics::of(&[trace(1e-7, 4000)], &options).unwrap().0.primary
        };
        assert_eq!(primary(0.08e-3), primary(0.8e-3));
        let different = of([trace(1e-7, 4000), trace(1e-7, 3000)]);
        assert!(matches!(different, Err(StatsError::Shape { .. })));
    }
}
