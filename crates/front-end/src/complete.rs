//! From a measurement to a complete map: cleaned, then filled, with what was done to it.

use crate::failure::Failure;
use contact_compare::{Cleaning, CleaningError};
use contact_types::HeightMap;
use surface_io::{Fill, FillError, Measurement};
use surface_stats::clean::{self, Record};
use surface_stats::{Edges, StatsError, height_step};

/// A surface without missing points, and what was done to it.
#[derive(Debug)]
pub struct Complete {
    /// The heights.
    pub map: HeightMap,
    /// Points that were filled, spikes among them.
    pub missing: usize,
    /// What each step of cleaning did.
    pub cleaned: Vec<Record>,
    /// Height step of the data as measured, if they have one and it is still in the heights (m).
    pub height_step: Option<f64>,
    /// Name of the format it was read from.
    pub format: String,
    /// `[y0, x0, ny, nx]` of the part that was cut out of the file, if one was.
    pub crop: Option<[usize; 4]>,
}

/// Why a measurement gives no complete map. How to mend it is said by who asked: the names of options differ.
#[derive(Debug, Clone, thiserror::Error)]
pub enum Incomplete {
    /// A single line of points, or a single point.
    #[error("{} x {} points are no surface, which needs at least 2 x 2 points", .0[0], .0[1])]
    Line([usize; 2]),
    /// Cleaning that cannot be done.
    #[error(transparent)]
    Cleaning(#[from] CleaningError),
    /// Cleaning that failed.
    #[error(transparent)]
    Clean(#[from] StatsError),
    /// Spikes became missing points, and missing points are refused.
    #[error("{0} points were taken for spikes and made missing points")]
    Spikes(usize),
    /// A profile of too few points.
    #[error(transparent)]
    Short(StatsError),
    /// Missing points.
    #[error(transparent)]
    Fill(#[from] FillError),
}

impl Incomplete {
    /// One word for the kind of trouble.
    pub fn failure(&self) -> Failure {
        match self {
            Self::Line(_) => Failure::refused("profile", self.to_string()),
            Self::Spikes(_) => Failure::refused("missing", self.to_string()),
            Self::Cleaning(e) => Failure::from_error(e),
            Self::Clean(e) | Self::Short(e) => Failure::from_error(e),
            Self::Fill(e) => Failure::from_error(e),
        }
    }
}

/// A complete map of a measurement that is no profile.
///
/// # Errors
/// [`Incomplete`].
pub fn complete(
    measurement: Measurement,
    cleaning: Cleaning,
    fill: Fill,
) -> Result<Complete, Incomplete> {
    let [ny, nx] = measurement.grid().shape();
    if ny < 2 || nx < 2 {
        return Err(Incomplete::Line([ny, nx]));
    }
    let (format, crop) = (measurement.format.name().to_owned(), measurement.cropped);
    // Neither a removed form nor filled points take the steps away; only smoothing does.
    let kept = cleaning.s_filter.is_none();
    let height_step = kept.then(|| height_step(measurement.heights())).flatten();
    let (measurement, cleaned) = clean(measurement, cleaning)?;
    let missing = measurement.missing();
    let spikes = spikes(&cleaned);
    if fill == Fill::Refuse && spikes > 0 && missing == spikes {
        return Err(Incomplete::Spikes(spikes));
    }
    let map = measurement.fill(fill)?;
    Ok(Complete { map, missing, cleaned, height_step, format, crop })
}

/// A measurement after cleaning, with what each step did.
///
/// # Errors
/// [`Incomplete::Cleaning`], [`Incomplete::Clean`].
pub fn clean(
    measurement: Measurement,
    cleaning: Cleaning,
) -> Result<(Measurement, Vec<Record>), Incomplete> {
    if cleaning.is_empty() {
        return Ok((measurement, Vec::new()));
    }
    cleaning.check(measurement.grid())?;
    let steps = cleaning.steps();
    // A measured map ends at its edges, whatever is assumed beyond them later.
    let clean = |grid, heights: &mut Vec<f64>| clean::apply(grid, heights, &steps, Edges::Open);
    Ok(measurement.edit(clean)?)
}

/// Spikes among the points that are missing after cleaning.
fn spikes(records: &[Record]) -> usize {
    let count = |record: &Record| match *record {
        Record::Outliers { count, .. } => count,
        _ => 0,
    };
    records.iter().map(count).sum()
}
