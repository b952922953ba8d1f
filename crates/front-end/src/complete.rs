//! From a measurement to a surface: cleaned, then filled, with what was done to it.

use crate::failure::Failure;
use contact_compare::{
    Cleaning, FileOrigin, Origin, ProfileSurface, StudyError, Surface, Unevenness,
};
use contact_types::Named;
use std::path::Path;
use surface_io::{Fill, FillError, HeightUnit, Measurement, Need, ReadError, ReadOptions};
use surface_stats::clean::{self, Form, Record};
use surface_stats::profile::Trace;
use surface_stats::{StatsError, height_step};

/// A surface that is asked about.
#[derive(Debug)]
pub struct Subject<'a> {
    /// Name in front of what is refused.
    pub path: &'a Path,
    /// Before it is levelled.
    pub surface: Surface,
    /// Steps of cleaning; none of a pair, whose bodies say their own.
    pub cleaned: Vec<Record>,
    /// The rule that missing points were filled by.
    pub fill: &'a str,
}

/// Why a measurement gives no surface. How to mend it is said by who asked: the names of options differ.
#[derive(Debug, Clone, thiserror::Error)]
pub enum Incomplete {
    /// A single line of points, or a single point.
    #[error("{} x {} points are no surface, which needs at least 2 x 2 points", .0[0], .0[1])]
    Line([usize; 2]),
    /// Rows of a profile.
    #[error("rows are put in line on a map, and this is a profile")]
    Rows,
    /// A form of maps, asked of a profile.
    #[error("sphere and cylinder are forms of maps, and this is a profile")]
    Form,
    /// Cleaning that cannot be done.
    #[error(transparent)]
    Cleaning(#[from] StudyError),
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
            Self::Line(_) | Self::Rows | Self::Form => {
                Failure::refused("profile", self.to_string())
            }
            Self::Spikes(_) => Failure::refused("missing", self.to_string()),
            Self::Cleaning(e) => Failure::from(e),
            Self::Clean(e) | Self::Short(e) => Failure::from(e),
            Self::Fill(e) => Failure::from(e),
        }
    }
}

/// How a file is read, and the rule by which its missing points are filled.
///
/// # Errors
/// [`Failure`] of a name that is no choice.
pub fn reading(file: &FileOrigin) -> Result<(ReadOptions, Fill), Failure> {
    let options = ReadOptions {
        channel: file.channel.clone(),
        pixel: file.pixel,
        lateral_unit: file.lateral_unit,
        height_unit: match file.override_height_unit {
            Some(metres) => Some(HeightUnit::Always(metres)),
            None => file.height_unit.map(HeightUnit::IfSilent),
        },
        layout: file.layout.as_deref().map(|name| choice("layout", name)).transpose()?,
        decimal: file.decimal.as_deref().map(|name| choice("decimal", name)).transpose()?,
        missing: file.missing_marks.clone(),
        ..ReadOptions::default()
    };
    Ok((options, choice("fill", &file.fill)?))
}

/// Numbers as they stand in a file that does not say their units, and what it does not say: that is taken for 1.
///
/// # Errors
/// [`ReadError`] of another fault of the file.
pub fn raw(
    mut options: ReadOptions,
    read: impl Fn(&ReadOptions) -> Result<Measurement, ReadError>,
) -> Result<(Measurement, Vec<Need>), ReadError> {
    let mut missing: Vec<Need> = Vec::new();
    loop {
        let needs = match read(&options) {
            // What was said already and is asked for again would be asked for ever.
            Err(ReadError::MissingScale { needs, .. })
                if !needs.iter().any(|need| missing.contains(need)) =>
            {
                needs
            }
            read => return read.map(|measurement| (measurement, missing)),
        };
        for need in &needs {
            match need {
                Need::PixelSize => options.pixel = Some([1.0, 1.0]),
                Need::LateralUnit => options.lateral_unit = Some(1.0),
                Need::HeightUnit => options.height_unit = Some(HeightUnit::IfSilent(1.0)),
                _ => {}
            }
        }
        missing.extend(needs);
    }
}

fn choice<T: Named>(key: &str, name: &str) -> Result<T, Failure> {
    T::of_name(name).ok_or_else(|| {
        let names = T::all().map(T::name).collect::<Vec<_>>().join(", ");
        Failure::refused("setting", format!("{key} = \"{name}\" is none of {names}"))
    })
}

/// A complete map of a measurement that is no profile. `file` says how it was read and is to be cleaned.
///
/// # Errors
/// [`Incomplete`].
pub fn complete(
    measurement: Measurement,
    mut file: FileOrigin,
    fill: Fill,
) -> Result<Surface, Incomplete> {
    let [ny, nx] = measurement.grid().shape();
    if ny < 2 || nx < 2 {
        return Err(Incomplete::Line([ny, nx]));
    }
    measurement.format.clone_into(&mut file.format);
    file.crop = measurement.cropped;
    // Neither a removed form nor filled points take the steps away; only smoothing does.
    let kept = file.cleaning.s_filter.is_none();
    file.height_step = kept.then(|| height_step(measurement.heights())).flatten();
    let (measurement, cleaned) = clean(measurement, file.cleaning)?;
    (file.missing, file.cleaned) = (measurement.missing(), cleaned);
    let count = |record: &Record| match *record {
        Record::Outliers { count, .. } => count,
        _ => 0,
    };
    let spikes = file.cleaned.iter().map(count).sum();
    if fill == Fill::Refuse && spikes > 0 && file.missing == spikes {
        return Err(Incomplete::Spikes(spikes));
    }
    let heights = measurement.fill(fill)?;
    Ok(Surface { name: file.name().to_owned(), origin: Origin::File(file), heights })
}

/// Traces of one surface, complete and evenly spaced; the filters among the cleaning of `file` are still to be applied.
///
/// # Errors
/// [`Incomplete`].
pub fn traces(
    measurements: Vec<Measurement>,
    mut file: FileOrigin,
    fill: Fill,
) -> Result<ProfileSurface, Incomplete> {
    if file.cleaning.align_rows {
        return Err(Incomplete::Rows);
    }
    if let Some(Form::Sphere | Form::Cylinder) = file.cleaning.form {
        return Err(Incomplete::Form);
    }
    measurements.first().map_or("", |m| m.format).clone_into(&mut file.format);
    (file.crop, file.missing) = (measurements.first().and_then(|m| m.cropped), 0);
    // λs and λc act on the profile after its form is off, with their own ends.
    let before = Cleaning { s_filter: None, l_filter: None, ..file.cleaning };
    let (mut traces, mut first) = (Vec::new(), None);
    for measurement in measurements {
        let (even, steps) = measurement.evenly_spaced()?;
        file.cleaning.steps(even.grid())?; // the filters among them follow later
        // Points between two measured ones are in no step.
        let step = steps.is_none().then(|| height_step(even.heights())).flatten();
        let (even, cleaned) = clean(even, before)?;
        file.missing += even.missing();
        let map = even.fill(fill)?;
        let spacing = map.grid().pixel()[1];
        let trace = Trace::new(spacing, map.into_heights());
        traces.push(trace.map_err(Incomplete::Short)?);
        let uneven = steps.map(|steps| Unevenness { steps, spacing });
        first.get_or_insert((cleaned, step, uneven));
    }
    let uneven;
    (file.cleaned, file.height_step, uneven) = first.unwrap_or_default();
    let name = file.name().to_owned();
    Ok(ProfileSurface { name, origin: Origin::File(file), traces, uneven })
}

/// A measurement after cleaning, with what each step did.
fn clean(
    measurement: Measurement,
    cleaning: Cleaning,
) -> Result<(Measurement, Vec<Record>), Incomplete> {
    let steps = cleaning.steps(measurement.grid())?;
    if steps.is_empty() {
        return Ok((measurement, Vec::new()));
    }
    let clean = |grid, heights: &mut Vec<f64>| clean::apply(grid, heights, &steps);
    Ok(measurement.edit(clean)?)
}
