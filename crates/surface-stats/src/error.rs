//! What can be wrong with a request for statistics.

use contact_types::SurfaceError;
use std::ops::RangeInclusive;

/// Why there is no number.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StatsError {
    /// The map has too few pixels along an axis for what was asked.
    #[error(
        "{what} needs at least {} x {} pixels; this map has {} x {}",
        needed[0], needed[1], shape[0], shape[1]
    )]
    TooSmall {
        /// What was asked for.
        what: &'static str,
        /// `[ny, nx]` of the map.
        shape: [usize; 2],
        /// The smallest `[ny, nx]` that has an answer.
        needed: [usize; 2],
    },
    /// A length of the surface whose moments leave the range of a double.
    #[error(
        "{quantity} = {value:e} m is outside {:e} to {:e} m, where moments can be computed: \
         check the unit of heights and pixels",
        domain.start(),
        domain.end()
    )]
    OutOfRange {
        /// Which length.
        quantity: &'static str,
        /// Its value (m).
        value: f64,
        /// What can be computed.
        domain: RangeInclusive<f64>,
    },
    /// A setting makes no sense.
    #[error("{setting} = {value:e}: {requirement}")]
    BadSetting {
        /// Its name.
        setting: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// A text names no form.
    #[error("'{text}' {why}")]
    UnknownForm {
        /// The text.
        text: String,
        /// What is wrong with it, and what there is.
        why: &'static str,
    },
    /// A range of wavelengths holds no waves of the map.
    #[error(
        "0 waves between {:e} m and {:e} m, at least 1 are needed: the map resolves wavelengths from \
         {:e} m to {:e} m",
        range[0], range[1], resolved[0], resolved[1]
    )]
    EmptyBand {
        /// The wavelengths asked for (m).
        range: [f64; 2],
        /// The wavelengths the map has (m).
        resolved: [f64; 2],
    },
    /// Fields that belong together differ in size, or one does not fit its grid.
    #[error("{what}: expected {expected} values, found {found}")]
    Shape {
        /// Which fields.
        what: &'static str,
        /// Values needed.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// Too few valid points to determine what was asked.
    #[error("{what} needs at least {needed} valid points; {found} are valid")]
    TooFewPoints {
        /// What was asked for.
        what: &'static str,
        /// Points needed.
        needed: usize,
        /// Points found.
        found: usize,
    },
    /// A trace is too short for a section length of roughness.
    #[error(
        "the trace is {} mm long; a section length of {} mm, with half of it at each end for the \
         filter, needs {} mm: take a shorter cut-off, or measure a longer trace",
        millimetres(*length), millimetres(*cutoff), millimetres(*needed)
    )]
    ShortTrace {
        /// Its length (m).
        length: f64,
        /// The cut-off λc (m), which is the section length.
        cutoff: f64,
        /// The shortest trace for it (m).
        needed: f64,
    },
    /// A fit did not settle.
    #[error(
        "the fit of a {form} did not settle in {iterations} iterations: the points do not lie near \
         one; remove a polynomial instead"
    )]
    NotConverged {
        /// The form fitted.
        form: &'static str,
        /// Iterations spent.
        iterations: usize,
    },
    /// Two maps hardly meet.
    #[error(
        "with the second map moved by {shift:e} m, {found} rows or columns of the two lie on each other, \
         and at least 2 must; shift less"
    )]
    TooLittle {
        /// How far the second was moved (m).
        shift: f64,
        /// Points in common along the axis.
        found: f64,
    },
    /// The coarser of two maps has too few points where the other lies.
    #[error(
        "the points are {:e} m apart in the first map and {:e} m in the second, so that the part in \
         common has {own:.1} points of the {}, and at least 4 are needed; measure the two at like \
         point spacings",
        pixels[0], pixels[1], ["first", "second"][*which]
    )]
    TooCoarse {
        /// Which map is the coarser, 0 or 1.
        which: usize,
        /// Its points in the common part along the axis.
        own: f64,
        /// Point spacing of both along that axis (m).
        pixels: [f64; 2],
    },
    /// The surface itself cannot be built.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
}

impl StatsError {
    /// Refuses a setting that does not hold.
    pub(crate) fn require(
        setting: &'static str,
        value: f64,
        holds: bool,
        requirement: &'static str,
    ) -> Result<(), Self> {
        if holds { Ok(()) } else { Err(Self::BadSetting { setting, value, requirement }) }
    }

    /// Refuses a map with fewer rows or columns than needed.
    pub(crate) fn require_shape(
        what: &'static str,
        shape: [usize; 2],
        needed: [usize; 2],
    ) -> Result<(), Self> {
        let is_large_enough = shape[0] >= needed[0] && shape[1] >= needed[1];
        if is_large_enough { Ok(()) } else { Err(Self::TooSmall { what, shape, needed }) }
    }
}

/// Four digits at most, as people write millimetres.
fn millimetres(metres: f64) -> f64 {
    format!("{:.3e}", 1e3 * metres).parse().unwrap_or(f64::NAN)
}
