//! Jackson and Streator, level by level.

use super::row::{Build, Row, amplitudes};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::ContactModel;
use multiscale_models::JacksonStreator;

pub(super) fn theory() -> Row {
    Row {
        name: "multiscale",
        label: "Multiscale",
        title: "Jackson–Streator multiscale",
        needs: "amplitudes of the rows, at every frequency",
        domain: "depends on the record length and on the direction of the rows",
        from_map: true,
        yields: false,
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    let amplitudes = amplitudes(inputs, "Jackson-Streator multiscale")?;
    Ok(Box::new(JacksonStreator::new(amplitudes.clone(), inputs.modulus)?))
}
