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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cleaning, FileOrigin, built_in_recipes};

    /// Heights that were handed over are refused in the tests of pairs.
    #[test]
    fn a_run_file_reads_back_as_it_was_written() {
        let file = FileOrigin {
            path: "a \"b\".x3p".into(),
            fill: "refuse".into(),
            cleaning: Cleaning {
                align_rows: true,
                outliers: Some(8.0),
                form: "polynomial:3".parse().ok(),
                s_filter: Some(0.1e-4 / 3.0),
                l_filter: None,
            },
            ..FileOrigin::default()
        };
        let recipe = built_in_recipes().remove(0);
        let run = RunFile {
            program: "0.1.0".into(),
            settings: Settings { pressures: Some(vec![1e6, 0.1e7 / 3.0]), ..Settings::default() },
            surfaces: vec![
                RunSurface { name: "a".into(), origin: Origin::File(file) },
                RunSurface { name: "ground".into(), origin: Origin::Recipe(recipe) },
            ],
        };
        let text = run.to_toml().unwrap();
        assert_eq!(RunFile::parse(&text).unwrap(), run, "{text}");
        assert!(RunFile::parse("program = 1").is_err());
    }
}
