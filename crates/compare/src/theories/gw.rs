//! Greenwood and Williamson, with exact Gaussian integrals.

use super::row::{Build, Row, moments};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::SeparationModel;
use gw_closed_form::GreenwoodWilliamson;

pub(super) fn theory() -> Row {
    Row {
        name: "gw",
        label: "GW",
        title: "Greenwood–Williamson, exact",
        needs: "m0, m2, m4, or density, radius, height deviation and mean offset of asperities",
        domain: "isotropic Gaussian surface, contact below about 10 % of it",
        from_map: true,
        yields: false,
        assumes: Assumes::Summits,
        build: Build::Separation(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn SeparationModel>, BuildError> {
    if let Some(asperities) = inputs.asperities {
        return Ok(Box::new(GreenwoodWilliamson::new(asperities, inputs.modulus)?));
    }
    let moments = moments(inputs, "Greenwood-Williamson")?;
    Ok(Box::new(GreenwoodWilliamson::from_moments(moments, inputs.modulus)?))
}
