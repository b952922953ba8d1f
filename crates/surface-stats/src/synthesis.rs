//! Random self-affine surfaces from a recipe and a seed.

use crate::StatsError;
use crate::spectrum::PowerSpectrum;
use contact_types::{Grid, HeightMap};
use grid_fft::GridFft;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use std::f64::consts::TAU;

/// What fixes the height of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scale {
    /// Rms height of the map (m).
    RmsHeight(f64),
    /// Rms gradient of the map by its spectrum (-).
    RmsGradient(f64),
}

/// Recipe of a periodic Gaussian surface with the isotropic PSD
///
/// ```math
/// C(q) \propto \begin{cases} 1 & q \le q_0 \\ (q/q_0)^{-2(1+H)} & q_0 < q \le q_1 \\
/// 0 & q > q_1 \end{cases} \qquad q_0 = \frac{2\pi}{\text{rolloff}}, \quad
/// q_1 = \frac{2\pi}{\text{cutoff}}
/// ```
///
/// White Gaussian noise is filtered, then scaled to have exactly the rms height or gradient asked for. The same recipe
/// gives the same map with every version and on every machine up to the last digits of `sin`, `cos` and `ln`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SelfAffine {
    /// Pixels of the map.
    pub grid: Grid,
    /// Hurst exponent H, above 0 and at most 1 (-).
    pub hurst: f64,
    /// Wavelength beyond which the PSD is flat (m); longer than the map: a power law throughout.
    pub rolloff: f64,
    /// Shortest wavelength (m), at least two pixels.
    pub cutoff: f64,
    /// What fixes the height.
    pub scale: Scale,
    /// Another seed, another map.
    pub seed: u64,
    /// Step the heights are rounded to (m) in the end, as instruments do.
    pub quantise: Option<f64>,
}

/// A map for tests, by its Hurst exponent, roll-off and cut-off (m), rms height (m) and seed.
#[cfg(test)]
pub(crate) fn rough(
    grid: Grid,
    hurst: f64,
    [rolloff, cutoff]: [f64; 2],
    rms_height: f64,
    seed: u64,
) -> HeightMap {
    let scale = Scale::RmsHeight(rms_height);
    SelfAffine { grid, hurst, rolloff, cutoff, scale, seed, quantise: None }.generate().unwrap()
}

impl SelfAffine {
    /// Makes the map. Its mean is zero before rounding to steps.
    ///
    /// # Errors
    /// [`StatsError::BadSetting`] for a setting out of its range, [`StatsError::EmptyBand`] if no
    /// wave of the map is longer than the cut-off.
    pub fn generate(&self) -> Result<HeightMap, StatsError> {
        self.check()?;
        let mut heights = self.white_noise();
        let mut fft = GridFft::new(self.grid.shape());
        let mut waves = fft.new_spectrum();
        fft.forward(&heights, &mut waves);
        let nq = self.grid.shape()[1] / 2 + 1;
        for (i, wave) in waves.iter_mut().enumerate() {
            *wave *= self.filter(self.grid.wavenumber(i / nq, i % nq));
        }
        fft.inverse(&mut waves, &mut heights);
        drop(waves);

        let moments = PowerSpectrum::of_field(self.grid, &heights).moments();
        if moments.m0 <= 0.0 {
            let [dy, dx] = self.grid.pixel();
            let [ly, lx] = self.grid.size();
            return Err(StatsError::EmptyBand {
                range: [self.cutoff, f64::INFINITY],
                resolved: [2.0 * dy.min(dx), ly.max(lx)],
            });
        }
        let factor = match self.scale {
            Scale::RmsHeight(rms) => rms / moments.rms_height(),
            Scale::RmsGradient(gradient) => gradient / moments.rms_gradient(),
        };
        for h in &mut heights {
            *h *= factor;
        }
        if let Some(step) = self.quantise {
            for h in &mut heights {
                *h = (*h / step).round() * step;
            }
            let is_rough = heights.iter().any(|h| h.abs() > 0.0);
            let requirement = "rounds every height to 0; take a smaller step";
            StatsError::require("height step", step, is_rough, requirement)?;
        }
        Ok(HeightMap::new(self.grid, heights)?)
    }

    /// The recipe of a surface that has this rms gradient (-) beside its rms height: the roll-off is found that gives both.
    ///
    /// # Errors
    /// [`StatsError::BadSetting`] if no roll-off from the cut-off to the longer side of the map does, or if the scale of the
    /// recipe is no rms height.
    pub fn with_gradient(self, gradient: f64) -> Result<Self, StatsError> {
        let refused = |requirement| {
            Err(StatsError::BadSetting { setting: "rms gradient", value: gradient, requirement })
        };
        let Scale::RmsHeight(height) = self.scale else {
            return refused("is given beside an rms height only");
        };
        self.check()?;
        if !(gradient.is_normal() && gradient > 0.0) {
            return refused("must be finite and greater than 0");
        }
        let mut noise: Vec<[f64; 2]> = Vec::new(); // |q| and the power of all waves of that kind
        let spectrum = PowerSpectrum::of_field(self.grid, &self.white_noise());
        spectrum.for_each(|[qy, qx], weight, s| noise.push([qy.hypot(qx), weight * s]));
        drop(spectrum);
        // How many times too steep, as a logarithm: it rises with a shorter roll-off.
        let excess = |ln_rolloff: f64| {
            let trial = Self { rolloff: ln_rolloff.exp(), ..self };
            let [m0, m2] = noise.iter().fold([0.0; 2], |[m0, m2], [q, power]| {
                let power = power * trial.filter(*q).powi(2);
                [m0 + power, m2 + power * q * q]
            });
            0.5 * (m2 / m0).ln() - (gradient / height).ln()
        };
        let [ly, lx] = self.grid.size();
        let (mut low, mut high) = (self.cutoff.ln(), ly.max(lx).ln());
        let [mut at_low, mut at_high] = [low, high].map(excess);
        if !(at_low > 0.0 && at_high < 0.0) {
            return refused(
                "with this rms height, no roll-off from the cut-off to the side of the map gives both: take a longer \
                 cut-off for a smaller gradient, a shorter one or a shorter side for a larger",
            );
        }
        // The secant; an end that stays twice counts half (Illinois). Each step sees the whole spectrum.
        let (mut middle, mut was_low) = (low, None);
        for _ in 0..60 {
            middle = (low * at_high - high * at_low) / (at_high - at_low);
            let at = excess(middle);
            let is_low = at > 0.0;
            let half = if was_low == Some(is_low) { 0.5 } else { 1.0 };
            if is_low {
                (low, at_low, at_high) = (middle, at, half * at_high);
            } else {
                (high, at_high, at_low) = (middle, at, half * at_low);
            }
            if at.abs() < 1e-12 {
                break;
            }
            was_low = Some(is_low);
        }
        Ok(Self { rolloff: middle.exp(), ..self })
    }

    /// Square root of the PSD, 1 on its plateau.
    fn filter(&self, q: f64) -> f64 {
        let (q0, q1) = (TAU / self.rolloff, TAU / self.cutoff);
        // A wave exactly at the cut-off belongs to the surface whatever its last digit says.
        if q <= 0.0 || q > q1 * (1.0 + 1e-12) {
            0.0
        } else {
            (q / q0).max(1.0).powf(-(1.0 + self.hurst))
        }
    }

    /// Independent normal deviates by Box and Muller's transform of a PCG generator (O'Neill 2014).
    fn white_noise(&self) -> Vec<f64> {
        let mut generator = Pcg64::new(u128::from(self.seed), 0x0073_7572_6661_6365);
        // (0, 1]: the 53 leading bits, plus one so that the logarithm exists.
        let mut uniform =
            || ((generator.next_u64() >> 11) + 1) as f64 * (0.5 / (1u64 << 52) as f64);
        let mut noise = Vec::with_capacity(self.grid.len() + 1);
        while noise.len() < self.grid.len() {
            let radius = (-2.0 * uniform().ln()).sqrt();
            let (sin, cos) = (TAU * uniform()).sin_cos();
            noise.push(radius * cos);
            noise.push(radius * sin);
        }
        noise.truncate(self.grid.len());
        noise
    }

    fn check(&self) -> Result<(), StatsError> {
        let [dy, dx] = self.grid.pixel();
        let (scale, value) = match self.scale {
            Scale::RmsHeight(rms) => ("rms height", rms),
            Scale::RmsGradient(gradient) => ("rms gradient", gradient),
        };
        let Self { hurst, rolloff, cutoff, .. } = *self;
        let step = self.quantise.unwrap_or(1.0);
        let positive = "must be finite and greater than 0";
        let resolved = "must be at least two pixels along both axes: take smaller pixels or a longer \
                        cut-off";
        let ordered = "must not be shorter than the cut-off wavelength";
        let few = "must be at most 2^28, as in a file: make a smaller map, or larger pixels";
        let usable = |x: f64| x.is_normal() && x > 0.0;
        let rules = [
            ("points of the map", self.grid.len() as f64, self.grid.len() <= 1 << 28, few),
            ("Hurst exponent", hurst, hurst > 0.0 && hurst <= 1.0, "must be above 0 and at most 1"),
            ("roll-off wavelength", rolloff, usable(rolloff), positive),
            ("cut-off wavelength", cutoff, usable(cutoff), positive),
            ("cut-off wavelength", cutoff, cutoff >= 2.0 * dy.max(dx) * (1.0 - 1e-12), resolved),
            ("roll-off wavelength", rolloff, rolloff >= cutoff, ordered),
            (scale, value, usable(value), positive),
            ("height step", step, usable(step), positive),
        ];
        let require =
            |(setting, value, holds, why)| StatsError::require(setting, value, holds, why);
        rules.into_iter().try_for_each(require)
    }
}
