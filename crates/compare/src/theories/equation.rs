//! The fitted closed form: for a map if its slopes are known, for numbers otherwise.

use super::row::{Build, Row, moments};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::ContactModel;
use multiscale_models::{Equation, MapEquation};

pub(super) fn theory() -> Row {
    Row {
        name: "equation",
        label: "Equation",
        title: "The equation (fitted)",
        needs: "m0, m2, m4; from a map also how steep its highest part is",
        domain: "any area from 0.1 %; off by about 4 % on Gaussian maps, 3 to 25 % on others it was fitted on, more with cracks, cliffs, coarse height steps or smooth parts among rough ones; measured maps 2 to 30 %, with many filled points 100 %",
        from_map: true,
        yields: false,
        assumes: Assumes::Fitted,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    let moments = moments(inputs, "The equation")?;
    Ok(match &inputs.curves {
        Some(curves) => Box::new(MapEquation::new(moments, curves, inputs.modulus)?),
        None => Box::new(Equation::from_moments(moments, inputs.modulus)?),
    })
}
