//! `run.toml`: all settings, versions and surfaces of a run, from which it can be repeated.

use crate::{Origin, Settings, StudyError};
use serde::{Deserialize, Serialize};

/// The content of `run.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunFile {
    /// Version of the program that wrote it.
    pub program: String,
    /// Settings of the study.
    pub settings: Settings,
    /// The surfaces in order.
    #[serde(rename = "surface")]
    pub surfaces: Vec<RunSurface>,
}

/// One surface of `run.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RunSurface {
    /// Name in the report.
    pub name: String,
    /// Where it comes from.
    pub origin: Origin,
}

impl RunFile {
    /// Reads a run file.
    ///
    /// # Errors
    /// [`StudyError::Syntax`], [`StudyError::Given`] and [`StudyError::NoSurface`].
    pub fn parse(text: &str) -> Result<Self, StudyError> {
        let file: Self = toml::from_str(text)?;
        if file.surfaces.is_empty() {
            return Err(StudyError::NoSurface);
        }
        let is_given = |s: &&RunSurface| s.origin.is_given();
        if let Some(given) = file.surfaces.iter().find(is_given) {
            return Err(StudyError::Given(given.name.clone()));
        }
        Ok(file)
    }

    /// The file as text.
    ///
    /// # Errors
    /// If a value has no TOML form, as an integer beyond 2^63 - 1 for a seed.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        toml::to_string(self)
    }
}
