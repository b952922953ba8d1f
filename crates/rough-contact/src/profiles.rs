//! Profiles: what every command says of the traces of a stylus.

use crate::outcome::{Failure, unfit};
use crate::text;
use rough_contact::HeightMap;
use rough_contact::compare::{Cleaning, Origin, ProfileSurface, Surface, Unevenness};
use rough_contact::surface_stats::clean::Form;
use std::path::Path;

/// Takes the traces of another file of the same surface in.
///
/// # Errors
/// If they are of another length or spacing.
pub(crate) fn add(
    all: &mut ProfileSurface,
    other: ProfileSurface,
    first: &Path,
    file: &Path,
) -> Result<(), Failure> {
    if let (Some(a), Some(b)) = (all.traces.first(), other.traces.first()) {
        let same = (b.spacing() / a.spacing() - 1.0).abs() < 1e-6;
        if a.heights().len() != b.heights().len() || !same {
            let why = format!(
                "{} points {} apart, and {} has {} points {} apart; traces of one sample are alike: \
                 cut them to one length with --crop 0,X0,1,NX, or leave --pool out",
                b.heights().len(),
                text::length(b.spacing()),
                first.display(),
                a.heights().len(),
                text::length(a.spacing())
            );
            return Err(unfit(file, "profile", why));
        }
    }
    all.traces.extend(other.traces);
    if let (Origin::File(all), Origin::File(other)) = (&mut all.origin, other.origin) {
        all.missing += other.missing;
        all.height_step = all.height_step.into_iter().chain(other.height_step).reduce(f64::max);
    }
    all.uneven = all.uneven.or(other.uneven);
    Ok(())
}

/// The one trace that is solved in plane strain.
pub(crate) fn only(all: ProfileSurface, path: &Path) -> Result<Surface, Failure> {
    let ProfileSurface { name, origin, traces, .. } = all;
    let filter = |c: &Cleaning| c.s_filter.or(c.l_filter);
    let message = if traces.len() > 1 {
        "several traces are several solutions; choose one with --channel NAME"
    } else if matches!(&origin, Origin::File(file) if filter(&file.cleaning).is_some()) {
        "--s-filter and --l-filter cut the ends of a trace off, which is then no period; leave them \
         out"
    } else {
        return Ok(Surface { name, origin, heights: HeightMap::clone(&traces[0]) });
    };
    Err(unfit(path, "profile", message))
}

/// Cleaning that is for maps only.
pub(crate) fn refuse(path: &Path, cleaning: Cleaning) -> Result<(), Failure> {
    let message = if cleaning.align_rows {
        "--align-rows puts the rows of a map in line, and this is a profile; leave it out"
    } else if let Some(Form::Sphere | Form::Cylinder) = cleaning.form {
        "--form sphere and cylinder are forms of maps, and this is a profile; give --form polynomial:2, \
         or another degree"
    } else {
        return Ok(());
    };
    Err(unfit(path, "profile", message))
}

/// A line for every trace that was put at equal distances.
pub(crate) fn uneven_line(uneven: Option<Unevenness>) -> String {
    uneven.map_or_else(String::new, |u| {
        format!(
            "points {} to {} apart were put {} apart, on straight lines between neighbours\n",
            text::length(u.steps[0]),
            text::length(u.steps[1]),
            text::length(u.spacing)
        )
    })
}
