//! How a built-in theory is written down: its card in plain words and a function that makes it.

use crate::inputs::Inputs;
use crate::theory::{Assumes, BuildError, Card, Theory};
use contact_types::{AmplitudeSpectrum, ContactModel, SeparationModel, SpectralMoments};
use std::sync::Arc;

/// How a model is made: one whose theory has a separation of the undeformed planes, or one that
/// knows the pressure only.
#[derive(Clone, Copy)]
pub(super) enum Build {
    Separation(fn(&Inputs) -> Result<Box<dyn SeparationModel>, BuildError>),
    Pressure(fn(&Inputs) -> Result<Box<dyn ContactModel>, BuildError>),
}

impl Build {
    fn pressure(self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        match self {
            Self::Separation(build) => Ok(build(inputs)?),
            Self::Pressure(build) => build(inputs),
        }
    }
}

/// One theory; see [`Card`] for the words.
pub(super) struct Row {
    pub(super) name: &'static str,
    pub(super) label: &'static str,
    pub(super) title: &'static str,
    pub(super) needs: &'static str,
    pub(super) domain: &'static str,
    pub(super) from_map: bool,
    pub(super) yields: bool,
    pub(super) assumes: Assumes,
    pub(super) build: Build,
}

impl Row {
    /// Its card says what the model says of its source and formula.
    pub(super) fn theory(self) -> Arc<dyn Theory> {
        let example = self.build.pressure(&Inputs::example());
        let example = example.expect("a test makes every row from these inputs");
        let mut card = Card::new(self.name, self.title, example.citation());
        card.formula = example.formula().unwrap_or_default().into();
        card.label = self.label.into();
        card.needs = self.needs.into();
        card.domain = self.domain.into();
        card.assumes = self.assumes;
        card.from_map = self.from_map;
        card.yields = self.yields;
        card.has_separation = matches!(self.build, Build::Separation(_));
        Arc::new(BuiltIn { card, build: self.build })
    }
}

struct BuiltIn {
    card: Card,
    build: Build,
}

impl Theory for BuiltIn {
    fn card(&self) -> &Card {
        &self.card
    }

    fn build(&self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        self.build.pressure(inputs)
    }

    fn build_separation(
        &self,
        inputs: &Inputs,
    ) -> Option<Result<Box<dyn SeparationModel>, BuildError>> {
        match self.build {
            Build::Separation(build) => Some(build(inputs)),
            Build::Pressure(_) => None,
        }
    }
}

/// An input, or that it is missing.
pub(super) fn missing<T>(
    value: Option<T>,
    model: &'static str,
    needs: &'static str,
) -> Result<T, BuildError> {
    value.ok_or_else(|| BuildError::missing(model, needs))
}

pub(super) fn moments(inputs: &Inputs, model: &'static str) -> Result<SpectralMoments, BuildError> {
    missing(inputs.moments, model, "the spectral moments m0, m2 and m4")
}

pub(super) fn amplitudes<'a>(
    inputs: &'a Inputs,
    model: &'static str,
) -> Result<&'a AmplitudeSpectrum, BuildError> {
    missing(inputs.amplitudes.as_ref(), model, "the amplitudes of profiles")
}
