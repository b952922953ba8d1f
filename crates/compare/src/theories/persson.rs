//! Persson's theory.

use super::row::{Build, Row, missing};
use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError};
use contact_types::{Citation, ContactModel, ContactState, ModelError};
use multiscale_models::Persson;

pub(super) fn theory() -> Row {
    Row {
        name: "persson",
        label: "Persson",
        title: "Persson",
        needs: "m2; a spectrum for the mean gap",
        domain: "isotropic Gaussian surface, any load; reads low at light load",
        from_map: true,
        yields: false,
        assumes: Assumes::Gaussian,
        build: Build::Pressure(build),
    }
}

fn build(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    if let Some(spectrum) = &inputs.spectrum {
        let whole = with_gamma(Persson::from_spectrum(spectrum, inputs.modulus)?, inputs)?;
        return Ok(match inputs.moments {
            Some(moments) => Box::new(AreaAndGap {
                area: Persson::from_moments(moments, inputs.modulus)?,
                gap: whole,
            }),
            None => Box::new(whole),
        });
    }
    if let Some(spectrum) = inputs.self_affine {
        let model = Persson::from_self_affine(spectrum, inputs.modulus)?;
        return Ok(Box::new(with_gamma(model, inputs)?));
    }
    let moments = missing(inputs.moments, "Persson", "a spectrum or the moment m2")?;
    Ok(Box::new(Persson::from_moments(moments, inputs.modulus)?))
}

/// The area by the moments that every model is given, the mean gap by the spectrum, which has
/// another m2: it sees the waves near two points in full.
struct AreaAndGap {
    area: Persson,
    gap: Persson,
}

impl ContactModel for AreaAndGap {
    fn citation(&self) -> Citation {
        self.area.citation()
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let gap = self.gap.at_pressure(mean_pressure)?;
        let area = self.area.at_pressure(mean_pressure)?;
        Ok(ContactState { separation: gap.separation, mean_gap: gap.mean_gap, ..area })
    }
}

fn with_gamma(model: Persson, inputs: &Inputs) -> Result<Persson, ModelError> {
    match inputs.gamma {
        Some(gamma) => model.with_gamma(gamma),
        None => Ok(model),
    }
}
