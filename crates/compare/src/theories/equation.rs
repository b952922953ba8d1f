//! The fitted closed form.

use super::row::{Build, Row, moments};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::ContactModel;
use multiscale_models::Equation;

pub(super) fn theory() -> Row {
    Row {
        name: "equation",
        label: "Equation",
        title: "The equation (fitted)",
        needs: "m0, m2, m4",
        domain: "isotropic Gaussian surface, area from 0.1 %: within 15 % at light load, 5 % at heavy load",
        from_map: true,
        yields: false,
        assumes: Assumes::Gaussian,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    let moments = moments(inputs, "The equation")?;
    Ok(Box::new(Equation::from_moments(moments, inputs.modulus)?))
}
