//! Persson's theory.

use super::row::{Build, Row, missing};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::{ContactModel, ModelError};
use multiscale_models::Persson;

pub(super) fn theory() -> Row {
    Row {
        name: "persson",
        label: "Persson",
        title: "Persson",
        needs: "m2; a spectrum for the mean gap",
        domain: "isotropic Gaussian surface, any load; reads low at light load",
        from_map: true,
        assumes: Assumes::Gaussian,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    if let Some(spectrum) = &inputs.spectrum {
        let model = Persson::from_spectrum(spectrum, inputs.modulus)?;
        return Ok(Box::new(with_gamma(model, inputs)?));
    }
    if let Some(spectrum) = inputs.self_affine {
        let model = Persson::from_self_affine(spectrum, inputs.modulus)?;
        return Ok(Box::new(with_gamma(model, inputs)?));
    }
    let moments = missing(inputs.moments, "Persson", "a spectrum or the moment m2")?;
    Ok(Box::new(Persson::from_moments(moments, inputs.modulus)?))
}

fn with_gamma(model: Persson, inputs: &Inputs) -> Result<Persson, ModelError> {
    match inputs.gamma {
        Some(gamma) => model.with_gamma(gamma),
        None => Ok(model),
    }
}
