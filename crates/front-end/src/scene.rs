//! What is asked of elasticity, of one map.

use contact_compare::Scene;
use contact_types::{AsperityStatistics, ContactModulus, HeightMap};
use surface_stats::clean::row_offsets;
use surface_stats::profile::{Trace, moments};
use surface_stats::{DirectionalMoments, Edges, HeightStatistics, StatsError};

/// The scene of a map, or of the section of ridges.
///
/// # Errors
/// [`StatsError`] of a map that is too small.
pub fn of(
    map: &HeightMap,
    modulus: ContactModulus,
    plane_strain: bool,
) -> Result<Scene, StatsError> {
    let rms_height = HeightStatistics::of(map).rms_height;
    if plane_strain {
        // Of ridges the slope of the section is the gradient.
        let trace = Trace::new(map.grid().pixel()[1], map.heights().to_vec())?;
        return Ok(Scene {
            modulus: modulus.pascals(),
            gradient: Some(moments(&trace).m2.sqrt()),
            rms_height: Some(rms_height),
            ..Scene::default()
        });
    }
    let slopes = DirectionalMoments::of(map, Edges::Open)?;
    let moments = slopes.isotropic(rms_height * rms_height);
    Ok(Scene {
        modulus: modulus.pascals(),
        gradient: Some(moments.rms_gradient()),
        rms_height: Some(rms_height),
        radius: AsperityStatistics::from_moments(moments).ok().map(|a| a.radius),
        rows: row_offsets(map.grid(), map.heights()).ok(),
        ..Scene::default()
    })
}
