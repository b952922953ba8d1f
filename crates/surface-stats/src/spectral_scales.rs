//! What the spectrum of a map says of its scales: noise, cut-off, roll-off, power law.

use crate::fractal::{self, PowerLaw};
use crate::noise::NoiseFloor;
use crate::spectrum::Ring;
use contact_types::{FractalParameters, Grid};
use std::f64::consts::TAU;

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
        Self::of_rings(rings, noise, limits, fractal_range, |r| fractal::fit_radial(rings, r))
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
        let cutoff = fractal::cutoff(&rings[..end], shortest);
        let rolloff = cutoff.and_then(|short| fractal::rolloff(rings, short));
        let found = cutoff.map(|short| [short, rolloff.unwrap_or(longest)]);
        let range = fractal_range.or(found);
        let power_law = range.and_then(fit);
        Self { noise, cutoff, rolloff, power_law, fractal_range: power_law.and(range) }
    }

    /// D and G of the profiles of an isotropic surface with this radial PSD; G is absent unless 1 <
    /// D < 2.
    pub(crate) fn fractal_of_surface(&self) -> (Option<f64>, Option<FractalParameters>) {
        let fractal = self.power_law.map(|law| law.fractal_of_surface());
        (fractal.map(|(dimension, _)| dimension), fractal.and_then(|(_, found)| found))
    }
}
