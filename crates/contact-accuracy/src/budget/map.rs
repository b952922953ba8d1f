//! What a map says about the accuracy of answers on it, before anything is solved.

use super::area::AreaAccuracy;
use super::sample;
use crate::continuation::window_for;
use contact_types::{Grid, HeightMap};
use grid_fft::parallel::join;
use surface_stats::spectrum::PowerSpectrum;
use surface_stats::{StatsError, height_step, repeats, seam_height};

/// What a map says about the accuracy of answers on it, whatever the load. Made once per surface.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Map {
    /// The gate, and the bar of the area inside it.
    pub accuracy: AreaAccuracy,
    /// Whether its edges match; if not, answers know less about its gap.
    pub repeats: bool,
    /// Mean jump between opposite edges over the points across ([`seam_height`]) if they do not match, else 0 (m).
    pub seam: f64,
    /// Rms height (m).
    pub rms_height: f64,
    /// Relative standard error of the rms height over maps of the same surface.
    pub height_scatter: f64,
    /// The same of the rms gradient.
    pub gradient_scatter: f64,
    /// What the summits of its highest blocks differ by (m); see [`sample::highest`].
    pub highest: f64,
    /// How well its slopes repeat at another place \[-\]; see [`PowerSpectrum::slopes_repeat`].
    pub regular: f64,
}

/// From where on a map is a pattern of like cells.
const REGULAR: f64 = 0.5;

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
        let power = PowerSpectrum::of(surface, window_for(repeats))?;
        Ok(Self::known(surface, &power, step, repeats))
    }

    /// Whether it is a pattern of like cells. The points along its contact lines come in together, cell by
    /// cell, so that what is left of the correction does not even out over many edges.
    pub fn is_regular(&self) -> bool {
        self.regular >= REGULAR
    }

    /// The same map on another grid: its accuracy there comes from elsewhere.
    #[must_use]
    pub fn on(self, grid: Grid) -> Self {
        Self { accuracy: self.accuracy.on(grid), ..self }
    }

    /// The same from a spectrum (under a window unless the map `repeats`) and a height step (m)
    /// that are known already.
    pub fn known(
        surface: &HeightMap,
        power: &PowerSpectrum,
        step: Option<f64>,
        repeats: bool,
    ) -> Self {
        let ([height_scatter, gradient_scatter], (regular, accuracy)) = join(
            || sample::height_and_gradient(surface, power),
            || (power.slopes_repeat(), AreaAccuracy::of_waves(surface.grid(), power, step)),
        );
        Self {
            accuracy,
            repeats,
            seam: if repeats { 0.0 } else { seam_height(surface) },
            rms_height: power.moments().0.rms_height(),
            height_scatter,
            gradient_scatter,
            highest: sample::highest(surface, sample::PARTS),
            regular,
        }
    }
}
