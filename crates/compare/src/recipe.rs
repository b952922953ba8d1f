//! Surfaces that are made, not stored: the recipes of `data/surfaces.toml`.

use contact_types::{Grid, HeightMap};
use serde::{Deserialize, Serialize};
use surface_stats::StatsError;
use surface_stats::synthesis::{Scale, SelfAffine};

/// The recipes of the built-in surfaces.
const BUILT_IN: &str = include_str!("../data/surfaces.toml");

/// A random self-affine surface: everything its heights depend on. SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// Short name, unique in its file.
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
    /// Makes the heights.
    ///
    /// # Errors
    /// [`RecipeError::Scale`] unless exactly one of rms height and rms gradient is given;
    /// [`RecipeError::Impossible`] if a value is out of its range.
    pub fn heights(&self) -> Result<HeightMap, RecipeError> {
        let name = || self.name.clone();
        let scale = match (self.rms_height, self.rms_gradient) {
            (Some(height), None) => Scale::RmsHeight(height),
            (None, Some(gradient)) => Scale::RmsGradient(gradient),
            (height, _) => {
                let found = if height.is_some() { 2 } else { 0 };
                return Err(RecipeError::Scale { name: name(), found });
            }
        };
        let impossible = |source| RecipeError::Impossible { name: name(), source };
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
/// # Errors
/// None for the recipes this program was built with; a test reads them.
pub fn built_in_recipes() -> Result<Vec<Recipe>, RecipeError> {
    parse_recipes(BUILT_IN)
}

/// What is wrong with a file of recipes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RecipeError {
    /// It is not TOML, or a key is missing, unknown or of the wrong type.
    #[error("the recipes cannot be read: {0}")]
    Syntax(#[from] toml::de::Error),
    /// Both or neither of the two ways to scale a surface are given.
    #[error(
        "recipe {name:?}: give exactly one of rms_height (m) and rms_gradient, found {found} of \
         them"
    )]
    Scale {
        /// Name of the recipe.
        name: String,
        /// How many were given.
        found: usize,
    },
    /// A value is out of its range.
    #[error("recipe {name:?}: {source}")]
    Impossible {
        /// Name of the recipe.
        name: String,
        /// Which value and why.
        source: StatsError,
    },
    /// Two recipes share a name.
    #[error("two recipes are called {name:?}; names must be unique")]
    Duplicate {
        /// The name.
        name: String,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RecipeFile {
    surface: Vec<Recipe>,
}

/// Reads recipes: an array of tables `[[surface]]` with the fields of [`Recipe`].
///
/// # Errors
/// [`RecipeError`]; the message names the recipe or the line.
pub(crate) fn parse_recipes(text: &str) -> Result<Vec<Recipe>, RecipeError> {
    let file: RecipeFile = toml::from_str(text)?;
    for (index, recipe) in file.surface.iter().enumerate() {
        let found =
            usize::from(recipe.rms_height.is_some()) + usize::from(recipe.rms_gradient.is_some());
        if found != 1 {
            return Err(RecipeError::Scale { name: recipe.name.clone(), found });
        }
        if file.surface[..index].iter().any(|other| other.name == recipe.name) {
            return Err(RecipeError::Duplicate { name: recipe.name.clone() });
        }
    }
    Ok(file.surface)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GROUND: &str = r#"
        [[surface]]
        name = "ground"
        shape = [64, 48]
        pixel = [1e-6, 2e-6]
        hurst = 0.8
        rolloff = 2e-5
        cutoff = 4e-6
        rms_height = 4e-7
        seed = 7
        quantise = 1e-8
    "#;

    #[test]
    fn built_in_recipes_can_be_made() {
        for mut recipe in built_in_recipes().unwrap() {
            recipe.shape = [96, 80];
            assert_eq!(recipe.heights().unwrap().grid().shape(), [96, 80]);
            recipe.hurst = -1.0;
            assert!(matches!(recipe.heights(), Err(RecipeError::Impossible { .. })));
        }
    }

    #[test]
    fn reads_a_recipe_and_refuses_what_is_ambiguous() {
        let recipes = parse_recipes(GROUND).unwrap();
        assert_eq!(recipes[0].shape, [64, 48]);
        assert_eq!(recipes[0].quantise, Some(1e-8));

        let both = GROUND.replace("seed = 7", "seed = 7\nrms_gradient = 0.1");
        assert!(matches!(parse_recipes(&both), Err(RecipeError::Scale { found: 2, .. })));
        let neither = GROUND.replace("rms_height = 4e-7", "");
        assert!(matches!(parse_recipes(&neither), Err(RecipeError::Scale { found: 0, .. })));
        let twice = GROUND.repeat(2);
        assert!(matches!(parse_recipes(&twice), Err(RecipeError::Duplicate { .. })));
        let unknown = GROUND.replace("hurst", "hrust");
        assert!(matches!(parse_recipes(&unknown), Err(RecipeError::Syntax(_))));
    }
}
