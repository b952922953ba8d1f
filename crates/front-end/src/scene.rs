//! What is asked of elasticity, and whether the bodies stick, of one map.

use contact_compare::{Adhesion, Inputs, Scene, WorkOfAdhesion};
use contact_types::{AsperityStatistics, ContactModulus, HeightMap};
use surface_stats::clean::row_offsets;
use surface_stats::profile::{self, Trace};
use surface_stats::{Edges, HeightStatistics, StatsError, moments, spectral_scales};

/// The scene of a map, or of the section of ridges.
pub(crate) fn of(
    map: &HeightMap,
    modulus: ContactModulus,
    plane_strain: bool,
) -> Result<Scene, StatsError> {
    let scene = Scene {
        modulus: modulus.pascals(),
        rms_height: Some(HeightStatistics::of(map).rms_height),
        ..Scene::default()
    };
    if plane_strain {
        // Of ridges the slope of the section is the gradient.
        let trace = Trace::new(map.grid().pixel()[1], map.heights().to_vec())?;
        return Ok(Scene { gradient: Some(profile::moments(&trace).m2.sqrt()), ..scene });
    }
    let moments = moments(map, Edges::Open)?;
    Ok(Scene {
        gradient: Some(moments.rms_gradient()),
        radius: AsperityStatistics::from_moments(moments).ok().map(|a| a.radius),
        rows: row_offsets(map.grid(), map.heights()).ok().and_then(|rows| rows.warning),
        ..scene
    })
}

/// Whether the bodies stick, of a levelled map and of the contacts that were solved on it, `[mean pressure (Pa), area
/// fraction]`.
pub(crate) fn adhesion(
    given: WorkOfAdhesion,
    map: &HeightMap,
    modulus: ContactModulus,
    contacts: &[[f64; 2]],
) -> Result<Adhesion, StatsError> {
    let moments = moments(map, Edges::Open)?;
    let inputs = Inputs {
        moments: Some(moments),
        spectrum: surface_stats::spectrum::radial(map).ok(),
        ..Inputs::new(modulus)
    };
    let ([cutoff, _], _) = spectral_scales(map, Edges::Open)?;
    Ok(Adhesion::of(given, &inputs, cutoff, contacts))
}
