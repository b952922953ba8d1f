//! The stacked multiscale model, by its largest amplitude over wavelength.

use super::row::{Build, Row, amplitudes};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::ContactModel;
use multiscale_models::Stacked;

pub(super) fn theory() -> Row {
    Row {
        name: "stacked",
        label: "Stacked",
        title: "Stacked multiscale",
        needs: "amplitudes of the rows (B_max)",
        domain: "depends on the record length and on the direction of the rows",
        from_map: true,
        yields: false,
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    if let Some(ratio) = inputs.max_amplitude_ratio {
        return Ok(Box::new(Stacked::new(ratio, inputs.modulus)?));
    }
    let amplitudes = amplitudes(inputs, "Stacked multiscale")?;
    Ok(Box::new(Stacked::from_amplitudes(amplitudes, inputs.modulus)?))
}
