//! Greenwood's simplified elliptical model.

use super::row::{Build, Row, moments};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use asperity_models::GreenwoodElliptical;
use contact_types::SeparationModel;

pub(super) fn theory() -> Row {
    Row {
        name: "greenwood-elliptical",
        label: "Elliptical",
        title: "Greenwood simplified elliptical",
        needs: "m0, m2, m4",
        domain: "isotropic Gaussian surface with bandwidth of at least 1.5, light contact",
        from_map: true,
        yields: false,
        assumes: Assumes::Summits,
        build: Build::Separation(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn SeparationModel>, BuildError> {
    let moments = moments(inputs, "Greenwood simplified elliptical")?;
    Ok(Box::new(GreenwoodElliptical::new(moments, inputs.modulus)?))
}
