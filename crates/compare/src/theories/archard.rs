//! Archard, spheres on spheres.

use super::row::{Build, Row, missing};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::ContactModel;
use multiscale_models::Archard;

pub(super) fn theory() -> Row {
    Row {
        name: "archard",
        label: "Archard",
        title: "Archard, spheres on spheres",
        needs: "radius and density of the spheres of each level",
        domain: "many spheres per contact of the level above, and far apart",
        from_map: false,
        yields: false,
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    let spheres = Some(&inputs.spheres).filter(|spheres| !spheres.is_empty());
    let spheres = missing(spheres, "Archard", "the radius and density of its spheres")?;
    Ok(Box::new(Archard::new(spheres, inputs.modulus)?))
}
