//! Profiles: traces of a stylus, from a file to what every command takes.

use crate::needs;
use crate::outcome::Failure;
use crate::text;
use compare::{Cleaning, Unevenness};
use contact_types::HeightMap;
use std::path::Path;
use surface_io::{Fill, Measurement, Resampled};
use surface_stats::clean::{Form, Record};
use surface_stats::height_step;
use surface_stats::profile::Trace;

/// Traces of one surface, complete and evenly spaced; the filters are still to be applied.
pub(crate) struct Traces {
    pub(crate) each: Vec<Trace>,
    /// Points that were filled, in all traces.
    pub(crate) missing: usize,
    /// What each step of cleaning did, of the first trace.
    pub(crate) cleaned: Vec<Record>,
    /// How the points were put at equal distances, if they were not.
    pub(crate) uneven: Option<Unevenness>,
    /// Height step of the data as measured (m).
    pub(crate) height_step: Option<f64>,
    /// Cleaning asked for, the filters among it.
    pub(crate) cleaning: Cleaning,
    /// Name of the format.
    pub(crate) format: String,
}

impl Traces {
    /// Puts them at equal distances, cleans, fills.
    pub(crate) fn of(
        path: &Path,
        measurements: Vec<Measurement>,
        cleaning: Cleaning,
        fill: Fill,
    ) -> Result<Self, Failure> {
        refuse(path, cleaning)?;
        let format = measurements.first().map_or("", |m| m.format().name()).to_owned();
        // λs and λc act on the profile after its form is off, with their own ends.
        let before = Cleaning { s_filter: None, l_filter: None, ..cleaning };
        let (mut traces, mut missing, mut first) = (Vec::new(), 0, None);
        for measurement in measurements {
            let (even, how) = measurement.evenly_spaced().map_err(|e| needs::unfilled(path, &e))?;
            cleaning.check(even.grid()).map_err(|e| Failure::in_file(path, &e))?;
            // Points between two measured ones are in no step.
            let step = how.is_none().then(|| height_step(even.heights())).flatten();
            let (even, cleaned) =
                answers::clean(even, before).map_err(|e| needs::unmade(path, &e))?;
            missing += even.missing();
            let map = even.fill(fill).map_err(|e| needs::unfilled(path, &e))?;
            let trace = Trace::new(map.grid().pixel()[1], map.into_heights())
                .map_err(|e| Failure::in_file(path, &e).adding("measure a longer trace"))?;
            traces.push(trace);
            first.get_or_insert((cleaned, how.map(unevenness), step));
        }
        let (cleaned, uneven, height_step) = first.unwrap_or_default();
        Ok(Self { each: traces, missing, cleaned, uneven, height_step, cleaning, format })
    }

    /// Takes the traces of another file of the same surface in.
    ///
    /// # Errors
    /// If they are of another length or spacing.
    pub(crate) fn add(&mut self, other: Self, first: &Path, file: &Path) -> Result<(), Failure> {
        if let (Some(a), Some(b)) = (self.each.first(), other.each.first()) {
            let same = (b.spacing() / a.spacing() - 1.0).abs() < 1e-6;
            if a.len() != b.len() || !same {
                let message = format!(
                    "{}: {} points {} apart, and {} has {} points {} apart; traces of one sample are alike: \
                     cut them to one length with --crop 0,X0,1,NX, or leave --pool out",
                    file.display(),
                    b.len(),
                    text::length(b.spacing()),
                    first.display(),
                    a.len(),
                    text::length(a.spacing())
                );
                return Err(Failure::refused("profile", message));
            }
        }
        self.each.extend(other.each);
        self.missing += other.missing;
        self.height_step = self.height_step.into_iter().chain(other.height_step).reduce(f64::max);
        self.uneven = self.uneven.or(other.uneven);
        Ok(())
    }

    /// The one trace that is solved in plane strain.
    pub(crate) fn only(mut self, path: &Path) -> Result<(HeightMap, Self), Failure> {
        let filtered = self.cleaning.s_filter.is_some() || self.cleaning.l_filter.is_some();
        let message = if self.each.len() > 1 {
            "several traces are several solutions; choose one with --channel NAME"
        } else if filtered {
            "--s-filter and --l-filter cut the ends of a trace off, which is then no period; leave them \
             out"
        } else {
            let trace = self.each.swap_remove(0);
            return Ok((trace.as_map().clone(), self));
        };
        Err(Failure::refused("profile", format!("{}: {message}", path.display())))
    }
}

fn unevenness(how: Resampled) -> Unevenness {
    Unevenness { steps: how.steps, spacing: how.spacing }
}

/// Cleaning that is for maps only.
fn refuse(path: &Path, cleaning: Cleaning) -> Result<(), Failure> {
    let message = if cleaning.align_rows {
        "--align-rows puts the rows of a map in line, and this is a profile; leave it out"
    } else if let Some(Form::Sphere | Form::Cylinder) = cleaning.form {
        "--form sphere and cylinder are forms of maps, and this is a profile; give --form polynomial:2, \
         or another degree"
    } else {
        return Ok(());
    };
    Err(Failure::refused("profile", format!("{}: {message}", path.display())))
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
