//! What a study asks of a model: a card that says what it is, and a way to make it.

use crate::needs::{Input, InputSet, Inputs, OfMap};
use contact_types::{Citation, ContactModel, ModelError, SeparationModel};
use serde::Serialize;
use std::borrow::Cow;

/// A theory of rough contact that can stand in a study: one row of the [`Registry`](crate::Registry).
pub trait Theory: Send + Sync {
    /// What it is.
    fn card(&self) -> &Card;

    /// Makes the model for one surface and modulus.
    ///
    /// # Errors
    /// [`BuildError::Missing`] if an input is absent, [`BuildError::Model`] if the theory has no
    /// meaning for it.
    fn build(&self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError>;

    /// Makes the model for questions at a separation; `None` if the theory has none.
    fn build_separation(
        &self,
        _inputs: &Inputs,
    ) -> Option<Result<Box<dyn SeparationModel>, BuildError>> {
        None
    }
}

/// What a theory is, in words that a report shows and a file keeps.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
#[expect(
    clippy::struct_excessive_bools,
    reason = "one for each thing that is true of a theory or not"
)]
pub struct Card {
    /// Name for commands and files, `gw`: the key of the theory everywhere.
    pub name: Cow<'static, str>,
    /// Short label in figures.
    pub label: Cow<'static, str>,
    /// Name in full.
    pub title: Cow<'static, str>,
    /// What it needs, in words.
    pub needs: Cow<'static, str>,
    /// Sets of numbers that it can be made from, the usual one first.
    pub inputs: Vec<InputSet>,
    /// What a map is read for, beside the moments.
    pub of_map: OfMap,
    /// Where the theory holds.
    pub domain: Cow<'static, str>,
    /// The paper.
    pub citation: Citation,
    /// Its formula, if that fits on a line; empty otherwise.
    pub formula: Cow<'static, str>,
    /// What it assumes of a surface, for the verdict.
    pub assumes: Assumes,
    /// True if a height map gives all it needs.
    pub from_map: bool,
    /// True if its bodies yield: it needs a hardness beside the map.
    pub yields: bool,
    /// True if it answers at a separation of the undeformed planes too.
    pub has_separation: bool,
    /// True if its bodies have no elasticity: it is made without a modulus.
    pub is_rigid: bool,
}

impl Card {
    /// The card of a theory that a height map gives all it needs, and of whose assumptions nothing
    /// is known but what its answers say. What is not said here can be set afterwards.
    ///
    /// `name` is its key: lower-case letters, digits and hyphens.
    pub fn new(
        name: impl Into<Cow<'static, str>>,
        title: impl Into<Cow<'static, str>>,
        citation: Citation,
    ) -> Self {
        let title = title.into();
        Self {
            name: name.into(),
            label: title.clone(),
            title,
            needs: "the statistics of a height map".into(),
            inputs: Vec::new(),
            of_map: OfMap::Moments,
            domain: "".into(),
            citation,
            formula: "".into(),
            assumes: Assumes::Unstated,
            from_map: true,
            yields: false,
            has_separation: false,
            is_rigid: false,
        }
    }

    /// Whether any of its sets of numbers holds `input`.
    pub fn takes(&self, input: Input) -> bool {
        self.inputs.iter().any(|set| set.takes(input))
    }
}

/// What a theory assumes of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Assumes {
    /// Isotropic Gaussian surface, summits that do not feel each other: light contact only.
    Summits,
    /// Isotropic Gaussian surface, any load.
    Gaussian,
    /// One dominant amplitude over wavelength, from rows of a given length.
    Amplitudes,
    /// A fractal profile over the fit range.
    Fractal,
    /// Not known: only what the model itself says of its answers counts.
    Unstated,
}

/// Why a model could not be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum BuildError {
    /// An input it needs is absent.
    #[error("{model} needs {needs}")]
    Missing {
        /// The model.
        model: Cow<'static, str>,
        /// What is absent.
        needs: Cow<'static, str>,
    },
    /// The theory refuses it.
    #[error(transparent)]
    Model(#[from] ModelError),
}
