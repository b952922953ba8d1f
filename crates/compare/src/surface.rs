//! A height map with a name and where it came from: a file, a program, or one of the recipes of `data/surfaces.toml`.

use crate::StudyError;
use contact_types::{Grid, HeightMap};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use surface_stats::clean::{Form, Record, Step};
use surface_stats::pair::{Composite, Independence, Placed, Placing};
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, StatsError, StatsOptions};

/// One surface of a study.
#[derive(Debug, Clone)]
pub struct Surface {
    /// What the report calls it: a file name without folder, or the name of a recipe.
    pub name: String,
    /// Where it came from, in enough detail to make it again.
    pub origin: Origin,
    /// The heights as made, or as read, cleaned and filled; before they are levelled.
    pub heights: HeightMap,
}

/// Where a surface came from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[allow(clippy::large_enum_variant, reason = "one for each surface, beside its whole map")]
pub enum Origin {
    /// A file that was read.
    File(FileOrigin),
    /// A random surface made from a recipe and a seed.
    Recipe(Recipe),
    /// Heights that a program handed over.
    Given(GivenOrigin),
    /// Two bodies pressed together.
    Pair(PairOrigin),
}

/// Two bodies pressed together, as one surface: the sum of their heights.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct PairOrigin {
    /// Names of the first body and of the second, which lies on it.
    pub names: [String; 2],
    /// How the second was laid on the first.
    pub placing: Placing,
    /// Where the two came from.
    pub bodies: Box<[Origin; 2]>,
    /// How they came to lie, and the moments of both and of the sum of their heights. Not part of a run file, which repeats it.
    #[serde(skip)]
    pub found: Option<(Placed, Independence)>,
}

/// Heights that a program handed over, of which no file and no recipe tells.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct GivenOrigin {
    /// What they are, in the words of who gave them.
    pub note: String,
    /// SHA-256 of the heights (m) as little-endian doubles row by row, in hexadecimal.
    pub sha256: String,
    /// Whether the map is one cell of a surface that repeats; absent: its edges tell.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeats: Option<bool>,
    /// Missing points that were filled before it was given.
    #[serde(default)]
    pub missing: usize,
    /// Height step the data came in (m), if any and if it is still in the heights.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height_step: Option<f64>,
}

impl GivenOrigin {
    /// Of these heights, described by `note`; nothing filled, no height step, edges as they are.
    pub fn of(heights: &HeightMap, note: impl Into<String>) -> Self {
        let mut hash = Sha256::new();
        for height in heights.heights() {
            hash.update(height.to_le_bytes());
        }
        Self {
            note: note.into(),
            sha256: hexadecimal(&hash.finalize()),
            repeats: None,
            missing: 0,
            height_step: None,
        }
    }
}

/// How a file became a height map: every choice that changes a height.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileOrigin {
    /// Path as given; in a run file from the folder it lies in.
    pub path: String,
    /// SHA-256 of the bytes, in hexadecimal.
    pub sha256: String,
    /// Name of the format found.
    pub format: String,
    /// Channel chosen, if one was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub channel: Option<String>,
    /// Pixel `[dy, dx]` in metres, if given by the user and not by the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pixel: Option<[f64; 2]>,
    /// Metres per unit of x and y, if given by the user for a file that does not say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_unit: Option<f64>,
    /// Metres per height unit, if given by the user for a file that does not say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height_unit: Option<f64>,
    /// Metres per height unit, if given by the user whatever the file says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub override_height_unit: Option<f64>,
    /// What the columns of a text file are, if given by the user: `matrix`, `list` or
    /// `traces`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<String>,
    /// The decimal mark of a text file, if given by the user: `point` or `comma`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub decimal: Option<String>,
    /// Marks of missing points, if given by the user.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing_marks: Vec<String>,
    /// Crop `[y0, x0, ny, nx]` in pixels, if asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crop: Option<[usize; 4]>,
    /// How missing points were filled: `refuse`, `harmonic` or `nearest`.
    pub fill: String,
    /// Missing points that were filled, after the crop; spikes that were removed are among them.
    pub missing: usize,
    /// Cleaning asked for.
    #[serde(default, skip_serializing_if = "Cleaning::is_empty")]
    pub cleaning: Cleaning,
    /// What each step of it did. Not part of a run file, which repeats it.
    #[serde(skip)]
    pub cleaned: Vec<Record>,
    /// Height step of the data before cleaning and filling (m), if they have one and it is still
    /// in the heights. Not part of a run file either.
    #[serde(skip)]
    pub height_step: Option<f64>,
}

impl FileOrigin {
    /// The name of the file, without the folders it lies in.
    pub fn name(&self) -> &str {
        self.path.rsplit(['/', '\\']).next().unwrap_or_default()
    }
}

impl Origin {
    /// The same with the names of its files alone: what lists an origin and reads nothing from it.
    #[must_use]
    pub fn without_folders(&self) -> Self {
        let mut shown = self.clone();
        match &mut shown {
            Self::File(file) => file.path = file.name().to_owned(),
            Self::Pair(pair) => {
                pair.bodies.iter_mut().for_each(|body| *body = body.without_folders());
            }
            Self::Given(_) | Self::Recipe(_) => {}
        }
        shown
    }

    /// The file, if it is one.
    pub(crate) fn file(&self) -> Option<&FileOrigin> {
        if let Self::File(file) = self { Some(file) } else { None }
    }

    /// What cleaning did, step by step; nothing where no file was read, or two were.
    pub fn cleaned(&self) -> &[Record] {
        self.file().map_or(&[], |file| &file.cleaned)
    }

    /// The pair, if it is one.
    pub fn pair(&self) -> Option<&PairOrigin> {
        if let Self::Pair(pair) = self { Some(pair) } else { None }
    }

    /// Points that were filled; of a pair those of both whole maps.
    pub fn missing(&self) -> usize {
        match self {
            Self::File(file) => file.missing,
            Self::Recipe(_) => 0,
            Self::Given(given) => given.missing,
            Self::Pair(pair) => pair.bodies.iter().map(Self::missing).sum(),
        }
    }

    /// What lies beyond the edges: the map again if it was made so, else nothing that is known.
    pub fn edges(&self) -> Edges {
        let repeats = match self {
            Self::File(_) => false,
            Self::Recipe(_) => true,
            Self::Given(given) => given.repeats == Some(true),
            Self::Pair(pair) => {
                let is_cell = pair.found.as_ref().is_some_and(|(placed, _)| placed.is_rolled);
                is_cell && pair.bodies.iter().all(|body| body.edges() == Edges::Periodic)
            }
        };
        if repeats { Edges::Periodic } else { Edges::Open }
    }

    /// The form that is taken off: [`Level::Auto`] follows what is known of the edges.
    pub fn level(&self, asked: Level) -> Level {
        match (self, asked) {
            (Self::Given(GivenOrigin { repeats: Some(false), .. }), Level::Auto) => Level::Plane,
            (_, Level::Auto) if self.edges() == Edges::Periodic => Level::Mean,
            _ => asked,
        }
    }

    /// How statistics of the heights are taken with this form asked for.
    pub fn options(&self, asked: Level) -> StatsOptions {
        StatsOptions {
            level: self.level(asked),
            edges: self.edges(),
            fractal_range: None,
            missing: self.missing(),
            height_step: self.height_step(),
        }
    }

    /// Height step that is still in the heights (m). Rounding errors of two bodies are independent, so
    /// that the squares of their steps add.
    pub fn height_step(&self) -> Option<f64> {
        match self {
            Self::File(file) => file.height_step,
            Self::Recipe(_) => None,
            Self::Given(given) => given.height_step,
            Self::Pair(pair) => pair.bodies.iter().filter_map(Self::height_step).reduce(f64::hypot),
        }
    }

    /// Whether the heights were handed over by a program, all of them or those of one body.
    pub(crate) fn is_given(&self) -> bool {
        match self {
            Self::File(_) | Self::Recipe(_) => false,
            Self::Given(_) => true,
            Self::Pair(pair) => pair.bodies.iter().any(Self::is_given),
        }
    }
}

impl Surface {
    /// Heights that a program made or read by itself, described by `note`.
    pub fn given(name: impl Into<String>, heights: HeightMap, note: impl Into<String>) -> Self {
        let origin = Origin::Given(GivenOrigin::of(&heights, note));
        Self { name: name.into(), origin, heights }
    }

    /// This surface with another pressed on it, as one: the sum of their heights
    /// ([`Composite`]). `level` is the form that the study takes off, without which the moments
    /// of both are compared; taking a plane off the sum is taking one off each.
    ///
    /// # Errors
    /// [`StudyError::Statistics`] of two surfaces that make no pair.
    pub fn against(
        &self,
        second: &Self,
        placing: &Placing,
        level: Level,
    ) -> Result<Self, StudyError> {
        let names = [self.name.clone(), second.name.clone()];
        let name = format!("{} against {}", names[0], names[1]);
        let refused = |source| StudyError::Statistics { surface: name.clone(), source };
        let pair = Composite::of(&self.heights, &second.heights, placing).map_err(refused)?;
        let repeats = |body: &Self| body.origin.edges() == Edges::Periodic;
        let is_cell = pair.placed.is_rolled && repeats(self) && repeats(second);
        let edges = if is_cell { Edges::Periodic } else { Edges::Open };
        let independence = Independence::of(&pair, level, edges).map_err(refused)?;
        let origin = Origin::Pair(PairOrigin {
            names,
            placing: *placing,
            bodies: Box::new([self.origin.clone(), second.origin.clone()]),
            found: Some((pair.placed, independence)),
        });
        Ok(Self { name, origin, heights: pair.map })
    }
}

/// SHA-256 of `bytes` in lower-case hexadecimal.
pub fn sha256_hex(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

fn hexadecimal(digest: &[u8]) -> String {
    digest.iter().fold(String::with_capacity(64), |mut text, byte| {
        // Writing to a String cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

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
    /// Makes the surface.
    ///
    /// # Errors
    /// [`StudyError::Scale`] unless exactly one of rms height and rms gradient is given;
    /// [`StudyError::Impossible`] if a value is out of its range.
    pub fn make(&self) -> Result<Surface, StudyError> {
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
        let recipe = SelfAffine { grid, hurst, rolloff, cutoff, scale, seed, quantise };
        let heights = recipe.generate().map_err(impossible)?;
        Ok(Surface { name: name(), origin: Origin::Recipe(self.clone()), heights })
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

/// Cleaning asked for. The order is fixed and is that of the fields: rows first, whose
/// jumps hide spikes and form, then spikes, because they
/// pull every fit and every mean; form before the filters, whose end effects grow with the slope
/// at the edges.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cleaning {
    /// Rows that stand at heights of their own put in line.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub align_rows: bool,
    /// Robust standard deviations beyond which a point is a spike and becomes a missing point.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outliers: Option<f64>,
    /// Form taken off by least squares.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub form: Option<Form>,
    /// Nesting index of the S-filter (m): shorter waves are taken off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s_filter: Option<f64>,
    /// Nesting index of the L-filter (m): longer waves are taken off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub l_filter: Option<f64>,
}

impl Cleaning {
    /// True if nothing is asked for.
    pub(crate) fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// The steps in the order in which they are done, on `grid`.
    ///
    /// # Errors
    /// [`StudyError::CutoffTooShort`] and [`StudyError::NothingLeft`] of filters that make no sense there.
    pub fn steps(&self, grid: Grid) -> Result<Vec<Step>, StudyError> {
        let [dy, dx] = grid.pixel();
        let pixel = dy.max(dx);
        for cutoff in self.s_filter.into_iter().chain(self.l_filter) {
            if !(cutoff.is_finite() && cutoff >= 2.0 * pixel) {
                return Err(StudyError::CutoffTooShort { cutoff, pixel });
            }
        }
        if let (Some(s_filter), Some(l_filter)) = (self.s_filter, self.l_filter)
            && s_filter >= l_filter
        {
            return Err(StudyError::NothingLeft { s_filter, l_filter });
        }
        let steps = [
            self.align_rows.then_some(Step::Rows),
            self.outliers.map(Step::Outliers),
            self.form.map(Step::Form),
            self.s_filter.map(Step::SFilter),
            self.l_filter.map(Step::LFilter),
        ];
        Ok(steps.into_iter().flatten().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hash_of_the_nist_example() {
        // FIPS 180-4, appendix: "abc".
        let digest = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256_hex(b"abc"), digest);
    }

    /// The bytes of two heights, 1 and -2: 3ff0… and c000… as doubles, low byte first.
    #[test]
    fn given_heights_are_known_by_their_bytes() {
        let grid = contact_types::Grid::new([1, 2], [1.0, 1.0]).unwrap();
        let heights = HeightMap::new(grid, vec![1.0, -2.0]).unwrap();
        let bytes = [0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 0, 0xc0];
        let Origin::Given(given) = Surface::given("a", heights, "two points").origin else {
            panic!("not given")
        };
        assert_eq!(given.sha256, sha256_hex(&bytes));
        assert_eq!(given.note, "two points");
    }

    #[test]
    fn built_in_recipes_can_be_made_and_what_is_ambiguous_or_impossible_not() {
        let all = built_in_recipes();
        for (i, recipe) in all.iter().enumerate() {
            assert!(!all[..i].iter().any(|other| other.name == recipe.name), "{}", recipe.name);
            let small = Recipe { shape: [96, 80], ..recipe.clone() };
            assert_eq!(small.make().unwrap().heights.grid().shape(), [96, 80]);
            let refused = Recipe { hurst: -1.0, ..small.clone() }.make();
            assert!(matches!(refused, Err(StudyError::Impossible { .. })));
            for (found, given) in [(0, None), (2, Some(0.1))] {
                let (rms_height, rms_gradient) = (given, given);
                let refused = Recipe { rms_height, rms_gradient, ..small.clone() }.make();
                let is_told = |e: &StudyError| matches!(e, StudyError::Scale { name, found: n } if *n == found && *name == small.name);
                assert!(refused.is_err_and(|e| is_told(&e)), "{found}");
            }
        }
    }
}
