//! Chang, Etsion and Bogy: summits that yield.

use super::row::{Build, Row, missing};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use asperity_models::ChangEtsionBogy;
use contact_types::SeparationModel;

pub(super) fn theory() -> Row {
    Row {
        name: "ceb",
        label: "CEB",
        title: "Chang–Etsion–Bogy",
        needs: "m0, m2, m4, or density, radius, height deviation and mean offset of asperities; hardness \
                and Poisson's ratio",
        domain: "isotropic Gaussian surface whose summits yield, contact below about 10 % of it",
        from_map: false,
        yields: true,
        assumes: Assumes::Summits,
        build: Build::Separation(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn SeparationModel>, BuildError> {
    const NAME: &str = "Chang-Etsion-Bogy";
    let asperities =
        missing(inputs.asperities(), NAME, "asperities, or the spectral moments m0, m2 and m4")?;
    let hardness = missing(inputs.hardness, NAME, "a hardness")?;
    let model = ChangEtsionBogy::new(asperities, inputs.modulus, hardness, inputs.poisson)?;
    Ok(Box::new(model))
}
