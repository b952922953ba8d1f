//! Persson's theory of bodies that yield.

use super::row::{Build, Row, missing, moments};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::ContactModel;
use multiscale_models::PerssonWithYield;

pub(super) fn theory() -> Row {
    Row {
        name: "persson-yield",
        label: "Persson, H",
        title: "Persson with yield",
        needs: "m2; hardness",
        domain: "isotropic Gaussian surface that yields, any load below the hardness; reads low",
        from_map: false,
        yields: true,
        assumes: Assumes::Gaussian,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    const NAME: &str = "Persson with yield";
    let gradient = moments(inputs, NAME)?.rms_gradient();
    let hardness = missing(inputs.hardness, NAME, "a hardness")?;
    Ok(Box::new(PerssonWithYield::new(gradient, inputs.modulus, hardness)?))
}
