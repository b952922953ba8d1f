//! The one call most users need.

use crate::fractal::{SpectralScales, check_range};
use crate::level::tilted;
use crate::seam::{MOST_SEAM_JUMP, seam_jump};
use crate::spectrum::{PowerSpectrum, Ring, amplitudes};
use crate::{
    DirectionalMoments, Edges, HeightStatistics, Level, StatsError, Summits, Warning, scale, steps,
};
use contact_types::{
    AmplitudeSpectrum, AsperityStatistics, Clock, FractalParameters, HeightMap, SpectralMoments,
};
use grid_fft::parallel::join;

/// How statistics are taken.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StatsOptions {
    /// What is removed by least squares first. The mean is always taken off: `None` is the same as `Mean` here, and so
    /// is `Auto` where `edges` say that the map repeats.
    pub level: Level,
    /// What lies beyond the edges.
    pub edges: Edges,
    /// Shortest and longest wavelength of the fractal fit (m); by default from the cut-off to the
    /// roll-off, as found among the waves that stand out of the noise.
    pub fractal_range: Option<[f64; 2]>,
    /// Points of the map that were filled in, as its reader counted; passed through.
    pub missing: usize,
    /// Height step of the data as measured (m), where filling or removing a form has hidden it;
    /// by default it is looked for in the map.
    pub height_step: Option<f64>,
}

/// Everything a contact model can ask of a surface. SI units; absent where undefined.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SurfaceStatistics {
    /// `[ny, nx]` of the map.
    pub shape: [usize; 2],
    /// `[dy, dx]` (m).
    pub pixel: [f64; 2],
    /// What was removed first.
    pub level: Level,
    /// What lies beyond the edges.
    #[cfg_attr(feature = "serde", serde(rename = "boundary"))]
    pub edges: Edges,
    /// Points that were filled in.
    pub missing: usize,
    /// Sq (m).
    pub rms_height: f64,
    /// Sa (m).
    pub mean_abs_height: f64,
    /// Ssk (-); absent for a flat map.
    pub skewness: Option<f64>,
    /// Sku (-); absent for a flat map.
    pub kurtosis: Option<f64>,
    /// Sp, highest point above the mean (m).
    pub peak_height: f64,
    /// Sv, deepest point below the mean (m).
    pub pit_depth: f64,
    /// √(2 m2) by finite differences (-).
    pub rms_gradient: f64,
    /// Mean square height (m²).
    pub m0: f64,
    /// Mean of `m2_x` and `m2_y` (-).
    pub m2: f64,
    /// Mean of `m4_x` and `m4_y` (m⁻²): of a lay or a pattern it depends on how it lies on the axes.
    pub m4: f64,
    /// Mean square forward slope along x (-).
    pub m2_x: f64,
    /// Mean square forward slope along y (-).
    pub m2_y: f64,
    /// Mean square second difference along x (m⁻²).
    pub m4_x: f64,
    /// Mean square second difference along y (m⁻²).
    pub m4_y: f64,
    /// `Σ S` over the waves of the map as it repeats (m²).
    pub m0_spectral: f64,
    /// `½ Σ S q²` over the waves of the map as it repeats (-).
    pub m2_spectral: f64,
    /// `½ Σ S (qx⁴ + qy⁴)` over the waves of the map as it repeats (m⁻²).
    pub m4_spectral: f64,
    /// Nayak's αN = m0 m4 / m2² by finite differences (-); absent for a flat map.
    pub bandwidth: Option<f64>,
    /// Largest over smallest mean square slope over all directions (-); absent for a flat map
    /// and where one direction has no slope at all.
    pub anisotropy: Option<f64>,
    /// Summits of an isotropic Gaussian surface with these m0, m2, m4.
    pub asperities: Option<AsperityStatistics>,
    /// Summits counted on the map.
    pub summits: Summits,
    /// Hurst exponent H from the slope -2 (1 + H) of the radial PSD over `fractal_range` (-).
    pub hurst: Option<f64>,
    /// Fractal dimension of a profile D = 2 - H (-).
    pub dimension: Option<f64>,
    /// Fractal roughness G of a profile, γ = 1.5 (m); absent unless 1 < D < 2.
    pub roughness: Option<f64>,
    /// Wavelengths of the fractal fit, as used (m).
    pub fractal_range: Option<[f64; 2]>,
    /// Wavelength beyond which the PSD is flat (m); absent if the map shows none.
    pub rolloff: Option<f64>,
    /// 99.9 % of the gradient variance that stands out of the noise is at longer wavelengths (m);
    /// two pixels at least.
    pub cutoff: Option<f64>,
    /// B_max of the rows: largest mean amplitude over wavelength (-).
    pub max_amplitude_ratio: f64,
    /// Length of the rows, which B_max depends on (m).
    pub record_length: f64,
    /// Step of the heights given (m); absent if they are continuous.
    pub height_step: Option<f64>,
    /// Rms of white noise at the level where the PSD stops falling (m); absent if it falls to the
    /// end.
    pub noise_rms: Option<f64>,
    /// Waves shorter than this cannot be told from that noise (m); absent without noise, and if
    /// nothing stands out of it.
    pub reliable_wavelength: Option<f64>,
    /// What to know before using these numbers, worst first.
    pub warnings: Vec<Warning>,
}

/// A number of [`SurfaceStatistics`]: all that CSV, the terminal and Python know of it.
#[derive(Debug)]
pub struct Statistic {
    /// In JSON, CSV and Python.
    pub key: &'static str,
    /// In standards and papers, if it has one.
    pub symbol: &'static str,
    /// For people; neighbours of one name share a line.
    pub name: &'static str,
    /// SI; empty for a pure number.
    pub unit: &'static str,
    value: fn(&SurfaceStatistics) -> Option<f64>,
}

impl Statistic {
    /// The number of a surface, if it has one.
    pub fn of(&self, statistics: &SurfaceStatistics) -> Option<f64> {
        (self.value)(statistics)
    }
}

const fn number(
    key: &'static str,
    symbol: &'static str,
    name: &'static str,
    unit: &'static str,
    value: fn(&SurfaceStatistics) -> Option<f64>,
) -> Statistic {
    Statistic { key, symbol, name, unit, value }
}

/// The numbers of [`SurfaceStatistics`], in its order. `cargo xtask study tables` writes those of Python from here.
pub const STATISTICS: [Statistic; 29] = [
    number("rms_height", "Sq", "rms height", "m", |s| Some(s.rms_height)),
    number("mean_abs_height", "Sa", "mean absolute height", "m", |s| Some(s.mean_abs_height)),
    number("skewness", "Ssk", "skewness", "", |s| s.skewness),
    number("kurtosis", "Sku", "kurtosis", "", |s| s.kurtosis),
    number("peak_height", "Sp", "highest peak", "m", |s| Some(s.peak_height)),
    number("pit_depth", "Sv", "deepest pit", "m", |s| Some(s.pit_depth)),
    number("rms_gradient", "Sdq", "rms gradient", "", |s| Some(s.rms_gradient)),
    number("m0", "m0", "height variance", "m²", |s| Some(s.m0)),
    number("m2", "m2", "slope variance", "", |s| Some(s.m2)),
    number("m4", "m4", "curvature variance", "m⁻²", |s| Some(s.m4)),
    number("m2_x", "m2x", "slope variance by axis", "", |s| Some(s.m2_x)),
    number("m2_y", "m2y", "slope variance by axis", "", |s| Some(s.m2_y)),
    number("m4_x", "m4x", "curvature variance by axis", "m⁻²", |s| Some(s.m4_x)),
    number("m4_y", "m4y", "curvature variance by axis", "m⁻²", |s| Some(s.m4_y)),
    number("m0_spectral", "m0", "by spectrum", "m²", |s| Some(s.m0_spectral)),
    number("m2_spectral", "m2", "by spectrum", "", |s| Some(s.m2_spectral)),
    number("m4_spectral", "m4", "by spectrum", "m⁻²", |s| Some(s.m4_spectral)),
    number("bandwidth", "m0 m4/m2²", "bandwidth", "", |s| s.bandwidth),
    number("anisotropy", "a2", "slope anisotropy", "", |s| s.anisotropy),
    number("hurst", "H", "Hurst exponent", "", |s| s.hurst),
    number("dimension", "D", "profile dimension", "", |s| s.dimension),
    number("roughness", "G", "fractal roughness", "m", |s| s.roughness),
    number("rolloff", "λr", "roll-off", "m", |s| s.rolloff),
    number("cutoff", "λs", "cut-off", "m", |s| s.cutoff),
    number("max_amplitude_ratio", "B_max", "amplitude / length", "", |s| {
        Some(s.max_amplitude_ratio)
    }),
    number("record_length", "", "length of the rows", "m", |s| Some(s.record_length)),
    number("height_step", "", "height step", "m", |s| s.height_step),
    number("noise_rms", "", "noise rms", "m", |s| s.noise_rms),
    number("reliable_wavelength", "", "reliable wavelength", "m", |s| s.reliable_wavelength),
];

/// `[cut-off (m), fractal dimension]`, and D with G (absent unless 1 < D < 2), of a levelled map, as among all its statistics.
///
/// # Errors
/// [`StatsError`] of a map without a spectrum.
pub fn spectral_scales(
    map: &HeightMap,
    edges: Edges,
) -> Result<([Option<f64>; 2], Option<FractalParameters>), StatsError> {
    let rings = PowerSpectrum::of(map, edges)?.rings();
    let rms_height = HeightStatistics::of(map).rms_height;
    let scales = SpectralScales::of_map(&rings, map.grid(), rms_height, None);
    let fractal = scales.power_law.map(|law| law.fractal_of_surface());
    let dimension = fractal.map(|(dimension, _)| dimension);
    Ok(([scales.cutoff, dimension], fractal.and_then(|(_, found)| found)))
}

/// The levelled map that [`SurfaceStatistics`] are taken from, and its spectra.
#[derive(Debug)]
#[non_exhaustive]
pub struct Spectra {
    /// The map, about its mean at least.
    pub surface: HeightMap,
    /// Moments by all waves: of the map as it repeats, or, with open edges, under a Hann window.
    pub moments: SpectralMoments,
    /// These waves, averaged over directions.
    pub rings: Vec<Ring>,
    /// Rms gradient that finite differences see of these waves over the one they have.
    pub resolved: f64,
    /// Amplitudes of the rows.
    pub amplitudes: AmplitudeSpectrum,
    /// Time of the moments, of the amplitudes and of the power spectrum (s).
    pub seconds: [f64; 3],
}

/// What a computation gives, and its time (s).
fn timed<T>(compute: impl FnOnce() -> T) -> (T, f64) {
    let start = Clock::now();
    let found = compute();
    (found, start.elapsed().as_secs_f64())
}

impl SurfaceStatistics {
    /// Takes all statistics of a map. Needs the memory of two further copies of it.
    ///
    /// # Errors
    /// [`StatsError::TooSmall`] below 3 x 3 pixels, [`StatsError::OutOfRange`] for heights or
    /// pixels beyond what can be squared, [`StatsError::BadSetting`] for an empty fit range.
    pub fn of(map: &HeightMap, options: &StatsOptions) -> Result<Self, StatsError> {
        Self::with_spectra(map, options).map(|(statistics, _)| statistics)
    }

    /// The same, with the spectra it had to compute, for who needs them too.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn with_spectra(
        map: &HeightMap,
        options: &StatsOptions,
    ) -> Result<(Self, Spectra), StatsError> {
        scale::check(map)?;
        check_range(options.fractal_range)?;
        let (grid, periodic) = (map.grid(), options.edges == Edges::Periodic);
        let (level, surface) = match options.level {
            Level::None => (Level::None, Level::Mean.taken_off(map.clone())?.1),
            Level::Auto if periodic => Level::Mean.taken_off(map.clone())?,
            level => level.taken_off(map.clone())?,
        };
        let tilted = if periodic { None } else { tilted(map, options.level)? };
        let height_step = options.height_step.or_else(|| steps::height_step(map.heights()));
        let ((distribution, differences), of_moments) = timed(|| {
            let differences = || DirectionalMoments::of(&surface, options.edges);
            join(|| HeightStatistics::of(&surface), differences)
        });
        let differences = differences?;
        let (of_points, ((edge_jump, uneven), ((spectral, power), of_power))) = join(
            || join(|| Summits::of(&surface, options.edges), || timed(|| amplitudes(&surface))),
            || {
                let waves = || {
                    let power = PowerSpectrum::of_field(grid, surface.heights());
                    (power.moments(), power)
                };
                join(|| (seam_jump(&surface), differences.uneven(&surface)), || timed(waves))
            },
        );
        let (summits, (amplitudes, of_amplitudes)) = of_points;
        let amplitudes = amplitudes?;
        let start = Clock::now();
        let power = if periodic {
            power
        } else {
            drop(power);
            PowerSpectrum::windowed(&surface, Edges::Open)
        };
        let by_waves = || if periodic { spectral } else { power.moments() };
        let (resolved, (rings, by_waves)) =
            join(|| power.resolved_gradient(), || (power.rings(), by_waves()));

        let rms_height = distribution.rms_height;
        let moments = differences.isotropic(rms_height * rms_height);
        let scales = SpectralScales::of_map(&rings, grid, rms_height, options.fractal_range);
        let of_spectrum = start.elapsed().as_secs_f64() + if periodic { of_power } else { 0.0 };
        let fractal = scales.power_law.map(|law| law.fractal_of_surface());

        let mut statistics = Self {
            shape: grid.shape(),
            pixel: grid.pixel(),
            level,
            edges: options.edges,
            missing: options.missing,
            rms_height,
            mean_abs_height: distribution.mean_abs_height,
            skewness: distribution.skewness,
            kurtosis: distribution.kurtosis,
            peak_height: distribution.peak_height,
            pit_depth: distribution.pit_depth,
            rms_gradient: moments.rms_gradient(),
            m0: moments.m0,
            m2: moments.m2,
            m4: moments.m4,
            m2_x: differences.m2_x,
            m2_y: differences.m2_y,
            m4_x: differences.m4_x,
            m4_y: differences.m4_y,
            m0_spectral: spectral.m0,
            m2_spectral: spectral.m2,
            m4_spectral: spectral.m4,
            bandwidth: Some(moments.bandwidth()).filter(|b| b.is_finite()),
            anisotropy: differences.anisotropy().filter(|r| r.is_finite()),
            asperities: AsperityStatistics::from_moments(moments).ok(),
            summits,
            hurst: scales.power_law.map(|fit| fit.hurst()),
            dimension: fractal.map(|(dimension, _)| dimension),
            roughness: fractal.and_then(|(_, found)| Some(found?.roughness)),
            fractal_range: scales.fractal_range,
            rolloff: scales.rolloff,
            cutoff: scales.cutoff,
            max_amplitude_ratio: amplitudes.max_amplitude_ratio(),
            record_length: amplitudes.record_length(),
            height_step,
            noise_rms: scales.noise.map(|n| n.rms),
            reliable_wavelength: scales.noise.and_then(|n| n.reliable),
            warnings: Vec::new(),
        };
        let (low, high) = map.range();
        let spacing = f64::EPSILON * low.abs().max(high.abs());
        // Rows that jump are in the spectrum too: no noise besides is known.
        let noisy = Warning::of_noise(moments, grid.pixel(), height_step, scales.noise)
            .filter(|_| !matches!(uneven, Some(Warning::RowsJump { .. })));
        let jump = (edge_jump > MOST_SEAM_JUMP).then_some(Warning::EdgeJump { ratio: edge_jump });
        let unresolved = Warning::of_resolution(resolved);
        statistics.warnings = statistics.judge([noisy, tilted, unresolved, uneven, jump], spacing);
        let seconds = [of_moments, of_amplitudes, of_spectrum];
        let moments = by_waves;
        Ok((statistics, Spectra { surface, moments, rings, resolved, amplitudes, seconds }))
    }

    /// m0, m2, m4 by finite differences.
    pub fn moments(&self) -> SpectralMoments {
        SpectralMoments { m0: self.m0, m2: self.m2, m4: self.m4 }
    }

    /// D and G for the model of Majumdar and Bhushan; `None` unless 1 < D < 2.
    pub fn fractal(&self) -> Option<FractalParameters> {
        Some(FractalParameters { dimension: self.dimension?, roughness: self.roughness? })
    }

    /// Warnings, worst first. Limits after Nayak (1971) for the bandwidth; the others are choices
    /// explained in the book, chapter "Surface statistics".
    fn judge(
        &self,
        [noisy, tilted, unresolved, uneven, jump]: [Option<Warning>; 5],
        spacing: f64,
    ) -> Vec<Warning> {
        if let Some(flat) = Warning::flat(self.rms_height, spacing) {
            return vec![flat];
        }
        let Summits { plateaus, count: summits, .. } = self.summits;
        let flat_tops = 10 * plateaus > summits;
        let flat_tops = flat_tops.then_some(Warning::FlatTops { plateaus, summits });
        let side = (self.shape[0] as f64 * self.pixel[0]).min(self.record_length);
        let few_waves = match self.rolloff {
            Some(rolloff) => {
                (side < 4.0 * rolloff).then(|| Warning::FewWaves { count: Some(side / rolloff) })
            }
            // A spectrum that does not fall has no long waves to miss.
            None => self.hurst.filter(|h| *h > 0.0).map(|_| Warning::FewWaves { count: None }),
        };
        let [not_gaussian, narrow] =
            Warning::of_distribution(self.skewness, self.kurtosis, self.bandwidth);
        let hurst = Warning::of_hurst(self.hurst);
        let warnings = [noisy, flat_tops, tilted, unresolved, uneven, not_gaussian, narrow];
        warnings.into_iter().chain([jump, few_waves, hurst]).flatten().collect()
    }
}
