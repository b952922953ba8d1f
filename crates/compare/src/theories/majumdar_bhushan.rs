//! Majumdar and Bhushan, the elastic part.

use super::row::{Build, Row, missing};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::ContactModel;
use multiscale_models::MajumdarBhushan;

pub(super) fn theory() -> Row {
    Row {
        name: "majumdar-bhushan",
        label: "MB",
        title: "Majumdar–Bhushan, elastic part",
        needs: "dimension D, roughness G, nominal area; a critical area for D of 1.5 and more",
        domain: "1 < D < 1.5 without a critical area",
        from_map: true,
        yields: false,
        assumes: Assumes::Fractal,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    const MODEL: &str = "Majumdar-Bhushan";
    let fractal =
        missing(inputs.fractal, MODEL, "a fractal fit with 1 < D < 2 over at least an octave")?;
    let area = missing(inputs.nominal_area, MODEL, "the nominal area")?;
    let model = MajumdarBhushan::new(fractal, area, inputs.modulus)?;
    Ok(match inputs.critical_area {
        Some(critical) => Box::new(model.with_critical_area(critical)?),
        None => Box::new(model),
    })
}
