//! Whether the bodies stick, of one map.

use contact_compare::{Adhesion, Level, Rough, WorkOfAdhesion};
use contact_types::{AsperityStatistics, ContactModulus, HeightMap};
use surface_stats::{
    DirectionalMoments, Edges, HeightStatistics, SpectralScales, StatsError, StatsOptions,
};

/// Of a levelled map, and of the contacts that were solved on it, `[mean pressure (Pa), area fraction]`.
///
/// # Errors
/// [`StatsError`] of a map that is too small.
pub fn of_map(
    given: WorkOfAdhesion,
    map: &HeightMap,
    modulus: ContactModulus,
    contacts: &[[f64; 2]],
) -> Result<Adhesion, StatsError> {
    let rms_height = HeightStatistics::of(map).rms_height;
    let moments = DirectionalMoments::of(map, Edges::Open)?.isotropic(rms_height * rms_height);
    let as_it_is = StatsOptions { level: Level::None, ..StatsOptions::default() };
    let rough = Rough {
        modulus: modulus.pascals(),
        gradient: moments.rms_gradient(),
        m4: moments.m4,
        asperities: AsperityStatistics::from_moments(moments).ok(),
        shortest: SpectralScales::of(map, &as_it_is)?.cutoff,
    };
    let spectrum = surface_stats::spectrum::radial(map).ok();
    Ok(Adhesion::of(given, &rough, spectrum.as_ref(), contacts))
}
