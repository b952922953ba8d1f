//! Surfaces that are made, not stored: the recipes of `data/surfaces.toml`.

use crate::StudyError;
use contact_types::{Grid, HeightMap};
use serde::{Deserialize, Serialize};
use surface_stats::StatsError;
use surface_stats::synthesis::{Scale, SelfAffine};

/// A random self-affine surface: everything its heights depend on. SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// Short name.
    pub name: String,
    /// What real surface it stands for.
    #[serde(default)]
    pub description: String,
    /// `[ny, nx]` points.
    pub shape: [usize; 2],
    /// `[dy, dx]` in metres.
    pub pixel: [f64; 2],
    /// Hurst exponent H, above 0 and at most 1.
    pub hurst: f64,
    /// Wavelength above which the spectrum is flat (m).
    pub rolloff: f64,
    /// Shortest wavelength (m).
    pub cutoff: f64,
    /// Rms height (m); exactly one of this and `rms_gradient`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rms_height: Option<f64>,
    /// Rms gradient [-].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rms_gradient: Option<f64>,
    /// Seed of the random phases.
    pub seed: u64,
    /// Height step to round to (m); absent: not rounded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantise: Option<f64>,
}

impl Recipe {
    pub(crate) fn heights(&self) -> Result<HeightMap, StudyError> {
        let name = || self.name.clone();
        let scale = match (self.rms_height, self.rms_gradient) {
            (Some(height), None) => Scale::RmsHeight(height),
            (None, Some(gradient)) => Scale::RmsGradient(gradient),
            (height, _) => {
                let found = if height.is_some() { 2 } else { 0 };
                return Err(StudyError::Scale { name: name(), found });
            }
        };
        let impossible = |source| StudyError::Impossible { name: name(), source };
        let grid =
            Grid::new(self.shape, self.pixel).map_err(|e| impossible(StatsError::from(e)))?;
        let Self { hurst, rolloff, cutoff, seed, quantise, .. } = *self;
        SelfAffine { grid, hurst, rolloff, cutoff, scale, seed, quantise }
            .generate()
            .map_err(impossible)
    }
}

/// The surfaces a study takes when none is given: three finishes of steel.
///
/// # Panics
/// Not with the recipes that this program was built with, which a test reads.
pub fn built_in_recipes() -> Vec<Recipe> {
    #[derive(Deserialize)]
    struct RecipeFile {
        surface: Vec<Recipe>,
    }
    let file: Result<RecipeFile, _> = toml::from_str(include_str!("../data/surfaces.toml"));
    file.expect("a test reads the committed recipes").surface
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn built_in_recipes_can_be_made_and_what_is_ambiguous_or_impossible_not() {
        let all = built_in_recipes();
        for (i, recipe) in all.iter().enumerate() {
            assert!(!all[..i].iter().any(|other| other.name == recipe.name), "{}", recipe.name);
            let small = Recipe { shape: [96, 80], ..recipe.clone() };
            assert_eq!(small.heights().unwrap().grid().shape(), [96, 80]);
            let refused = Recipe { hurst: -1.0, ..small.clone() }.heights();
            assert!(matches!(refused, Err(StudyError::Impossible { .. })));
            for (found, given) in [(0, None), (2, Some(0.1))] {
                let (rms_height, rms_gradient) = (given, given);
                let refused = Recipe { rms_height, rms_gradient, ..small.clone() }.heights();
                let is_told = |e: &StudyError| matches!(e, StudyError::Scale { name, found: n } if *n == found && *name == small.name);
                assert!(refused.is_err_and(|e| is_told(&e)), "{found}");
            }
        }
    }
}
