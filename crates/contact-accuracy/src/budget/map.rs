//! What a map says about the accuracy of answers on it, before anything is solved.

use super::sample;
use crate::continuation::repeats;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::AreaAccuracy;
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::{StatsError, height_step};

/// What a map says about the accuracy of answers on it, whatever the load. Made once per surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Map {
    /// The gate, and the bar of the area inside it.
    pub accuracy: AreaAccuracy,
    /// Whether its edges match; if not, answers know less about its gap.
    pub repeats: bool,
    /// Rms height (m).
    pub rms_height: f64,
    /// Relative standard error of the rms height over maps of the same surface.
    pub height_scatter: f64,
    pub(super) grid: Grid,
}

impl Map {
    /// Looks at edges, gradients, steps and spectrum of `surface`. If the edges do not match, the
    /// spectrum is taken under a Hann window.
    ///
    /// # Errors
    /// [`StatsError::OutOfRange`].
    pub fn of(surface: &HeightMap) -> Result<Self, StatsError> {
        Self::with_step(surface, height_step(surface.heights()))
    }

    /// The same of a map whose heights came in steps of `step` (m), if in any, before it was
    /// levelled or cleaned: afterwards the heights do not show them.
    ///
    /// # Errors
    /// [`StatsError::OutOfRange`].
    pub fn with_step(surface: &HeightMap, step: Option<f64>) -> Result<Self, StatsError> {
        let repeats = repeats(surface);
        let window = if repeats { Window::None } else { Window::Hann };
        let power = PowerSpectrum::of(surface, window)?;
        Ok(Self::known(surface, &power, step.unwrap_or(0.0), repeats))
    }

    /// The same map on another grid: its accuracy there comes from elsewhere.
    #[must_use]
    pub fn on(self, grid: Grid) -> Self {
        Self { grid, ..self }
    }

    /// The same from a spectrum (under a window unless the map `repeats`) and a height step (m, 0
    /// for none) that are known already.
    pub fn known(surface: &HeightMap, power: &PowerSpectrum, step: f64, repeats: bool) -> Self {
        let grid = surface.grid();
        let (moments, [x, y]) = power.moments();
        let [dy, dx] = grid.pixel();
        let relief = moments.rms_gradient() * dy.min(dx);
        let step_ratio = if relief > 0.0 { step / relief } else { 0.0 };
        let resolution = power.resolved_gradient().unwrap_or(1.0);
        let height_scatter = sample::height_scatter(surface, power);
        Self {
            accuracy: AreaAccuracy::known(grid, resolution, step_ratio)
                .with_slopes([y, x])
                .with_waves(waves(power)),
            repeats,
            rms_height: moments.rms_height(),
            height_scatter,
            grid,
        }
    }
}

/// Independent waves of equal weight that would carry the gradient as this spectrum does, for
/// [`AreaAccuracy::waves`](fft_bem_solver::AreaAccuracy). Waves q and -q are one.
pub fn waves(power: &PowerSpectrum) -> f64 {
    let (mut sum, mut squares) = (0.0, 0.0);
    power.for_each(|[qy, qx], weight, variance| {
        let slope = variance * (qy * qy + qx * qx);
        sum += weight * slope;
        squares += weight * slope * slope;
    });
    if squares > 0.0 { 0.5 * sum * sum / squares } else { f64::INFINITY }
}
