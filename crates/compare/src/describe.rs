//! From a surface to what models and the report need of it, each computed once.

use crate::inputs::Inputs;
use crate::result::Spectral;
use crate::theory::Assumes;
use crate::{Origin, Registry, Settings, poisson};
use contact_types::{AmplitudeSpectrum, ContactModulus, HeightMap};
use std::f64::consts::TAU;
use surface_stats::spectrum::{Ring, radial};
use surface_stats::{Edges, Spectra, StatsError, StatsOptions, SurfaceStatistics, level};

/// Removes the form and takes the statistics. A map made from a recipe repeats; a measured one
/// does not; one that was given, only if who gave it says so.
pub(crate) fn describe(
    heights: &HeightMap,
    origin: &Origin,
    settings: &Settings,
) -> Result<(HeightMap, SurfaceStatistics, Spectra), StatsError> {
    let fractal_range = settings.fractal_range;
    let options = StatsOptions { fractal_range, ..origin.options(heights, settings.level)? };
    // From the heights as given, so that a tilt that is removed is still reported.
    let (statistics, spectra) = SurfaceStatistics::with_spectra(heights, &options)?;
    Ok((level(heights, statistics.level)?, statistics, spectra))
}

/// One set of moments for all models, by finite differences: they stay inside the map, so that a
/// map that does not repeat brings no jump at its edges, and they see less of the noise near two
/// points than the spectrum does. Amplitudes are kept if a
/// model that is asked needs them, or may need them.
pub(crate) fn model_inputs(
    map: &HeightMap,
    statistics: &SurfaceStatistics,
    amplitudes: AmplitudeSpectrum,
    modulus: ContactModulus,
    (settings, registry): (&Settings, &Registry),
) -> Inputs {
    let has_use = settings
        .asked_models(registry)
        .any(|t| matches!(t.card().assumes, Assumes::Amplitudes | Assumes::Unstated));
    Inputs {
        moments: Some(statistics.moments()).filter(|m| m.m2 > 0.0 && m.m4 > 0.0),
        is_measured: true,
        amplitudes: Some(amplitudes).filter(|_| has_use),
        fractal: statistics.fractal(),
        dimension: statistics.dimension,
        nominal_area: Some(map.grid().area()),
        hardness: settings.hardness,
        gamma: settings.gamma,
        // The mean gap is told where its weight was asked for.
        spectrum: settings.gamma.and_then(|_| radial(map).ok()),
        poisson: poisson(&settings.bodies),
        ..Inputs::new(modulus)
    }
}

/// Moments and radial PSD by the spectrum: of the map as it repeats if it does, under a Hann
/// window otherwise, or the jump at the edges would count as roughness.
pub(crate) fn spectral(found: &Spectra, edges: Edges) -> Spectral {
    let Spectra { moments, resolved, rings, .. } = found;
    let (moments, resolved, windowed) = (*moments, *resolved, edges == Edges::Open);
    Spectral { moments, resolved, windowed, psd: thinned(rings) }
}

/// The PSD in about 12 bins per octave of wavenumber, `[wavelength, C]`: what a figure can show.
fn thinned(rings: &[Ring]) -> Vec<[f64; 2]> {
    let rings: Vec<&Ring> = rings.iter().filter(|r| r.wavenumber > 0.0).collect();
    let bin = |ring: &Ring| (12.0 * ring.wavenumber.log2()).floor() as i64;
    let mean = |rings: &[&Ring]| {
        let waves: f64 = rings.iter().map(|r| r.waves as f64).sum();
        let of = |part: fn(&Ring) -> f64| -> f64 {
            rings.iter().map(|r| r.waves as f64 * part(r)).sum::<f64>() / waves
        };
        [TAU / of(|r| r.wavenumber.ln()).exp(), of(|r| r.psd)]
    };
    rings.chunk_by(|a, b| bin(a) == bin(b)).map(mean).collect()
}
