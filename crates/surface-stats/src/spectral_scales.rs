//! What the spectrum of a map says of its scales: noise, cut-off, roll-off, power law.

use crate::fractal::{self, PowerLaw};
use crate::level::without_form;
use crate::noise::NoiseFloor;
use crate::options::{StatsOptions, check_range};
use crate::spectrum::{PowerSpectrum, Ring, Window};
use crate::{Edges, HeightStatistics, StatsError, scale};
use contact_types::{FractalParameters, Grid, HeightMap};
use std::f64::consts::TAU;

/// Scales and power law of a PSD.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SpectralScales {
    /// Noise at the level where the PSD stops falling; absent if it falls to the end.
    pub(crate) noise: Option<NoiseFloor>,
    /// 99.9 % of the gradient variance that stands out of the noise is at longer wavelengths (m);
    /// two pixels at least.
    pub cutoff: Option<f64>,
    /// Wavelength beyond which the PSD is flat (m); absent if the map shows none.
    pub(crate) rolloff: Option<f64>,
    /// Power law between the wavelengths of `fractal_range`; absent if they hold less than four
    /// bins or an octave.
    pub(crate) power_law: Option<PowerLaw>,
    /// Shortest and longest wavelength of the power law (m).
    pub(crate) fractal_range: Option<[f64; 2]>,
}

impl SpectralScales {
    /// Levels and transforms a map for these scales alone, the same as in [`SurfaceStatistics`](crate::SurfaceStatistics):
    /// all that the model of Majumdar and Bhushan needs. Needs the memory of two further copies of the map.
    ///
    /// # Errors
    /// As [`SurfaceStatistics::of`](crate::SurfaceStatistics::of), but no map is too small.
    pub fn of(map: &HeightMap, options: &StatsOptions) -> Result<Self, StatsError> {
        scale::check(map)?;
        check_range(options.fractal_range)?;
        let degree = options.level_on(map)?.degree().unwrap_or(0);
        let levelled = without_form(map, degree)?;
        let rms_height = HeightStatistics::of(&levelled).rms_height;
        let mut heights = levelled.into_heights();
        if options.edges == Edges::Open {
            Window::Hann.apply(map.grid(), &mut heights);
        }
        let rings = PowerSpectrum::of_field(map.grid(), &heights).rings();
        Ok(Self::of_map(&rings, map.grid(), rms_height, options.fractal_range))
    }

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
    pub fn fractal_of_surface(&self) -> (Option<f64>, Option<FractalParameters>) {
        let fractal = self.power_law.map(|law| law.fractal_of_surface());
        (fractal.map(|(dimension, _)| dimension), fractal.and_then(|(_, found)| found))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SurfaceStatistics;
    use crate::synthesis::rough;

    /// Alone or among all statistics: the same numbers, on a crop, with every level.
    #[test]
    fn the_scales_alone_are_those_of_all_statistics() {
        let grid = Grid::new([90, 128], [1.5e-6, 1e-6]).unwrap();
        let map = rough(grid, 0.7, [30e-6, 4e-6], 1e-6, 3);
        for edges in [Edges::Open, Edges::Periodic] {
            for level in [crate::Level::None, crate::Level::Quadratic] {
                let options = StatsOptions { level, edges, ..StatsOptions::default() };
                let all = SurfaceStatistics::of(&map, &options).unwrap();
                let some = SpectralScales::of(&map, &options).unwrap();
                assert_eq!((all.dimension, all.fractal()), some.fractal_of_surface());
                assert_eq!((all.cutoff, all.rolloff), (some.cutoff, some.rolloff));
                assert!(all.dimension.is_some());
            }
        }
    }
}
