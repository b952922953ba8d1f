//! Profiles: from what was read of a stylus to traces, and to their statistics.

use crate::complete::{Incomplete, clean};
use contact_compare::{Cleaning, Unevenness};
use serde_json::{Value, json};
use surface_io::{Fill, Measurement, Resampled};
use surface_stats::clean::Record;
use surface_stats::profile::{ProfileOptions, ProfileStatistics, Trace};
use surface_stats::{StatsError, height_step};

/// Traces of one surface, complete and evenly spaced; the filters are still to be applied.
#[derive(Debug)]
pub struct Traces {
    /// Each trace.
    pub each: Vec<Trace>,
    /// Points that were filled, in all traces.
    pub missing: usize,
    /// What each step of cleaning did, of the first trace.
    pub cleaned: Vec<Record>,
    /// How the points were put at equal distances, if they were not.
    pub uneven: Option<Unevenness>,
    /// Height step of the data as measured (m).
    pub height_step: Option<f64>,
    /// Cleaning asked for, the filters among it.
    pub cleaning: Cleaning,
    /// Name of the format.
    pub format: String,
    /// `[y0, x0, ny, nx]` of the part that was cut out of the first trace, if one was.
    pub crop: Option<[usize; 4]>,
}

impl Traces {
    /// Puts them at equal distances, cleans, fills.
    ///
    /// # Errors
    /// [`Incomplete`].
    pub fn of(
        measurements: Vec<Measurement>,
        cleaning: Cleaning,
        fill: Fill,
    ) -> Result<Self, Incomplete> {
        let format = measurements.first().map_or("", |m| m.format().name()).to_owned();
        let crop = measurements.first().and_then(Measurement::cropped);
        // λs and λc act on the profile after its form is off, with their own ends.
        let before = Cleaning { s_filter: None, l_filter: None, ..cleaning };
        let (mut traces, mut missing, mut first) = (Vec::new(), 0, None);
        for measurement in measurements {
            let (even, how) = measurement.evenly_spaced()?;
            cleaning.check(even.grid())?;
            // Points between two measured ones are in no step.
            let step = how.is_none().then(|| height_step(even.heights())).flatten();
            let (even, cleaned) = clean(even, before)?;
            missing += even.missing();
            let map = even.fill(fill)?;
            let trace = Trace::new(map.grid().pixel()[1], map.into_heights());
            traces.push(trace.map_err(Incomplete::Short)?);
            first.get_or_insert((cleaned, how.map(unevenness), step));
        }
        let (cleaned, uneven, height_step) = first.unwrap_or_default();
        Ok(Self { each: traces, missing, cleaned, uneven, height_step, cleaning, format, crop })
    }

    /// Statistics of the traces as one sample, a polynomial of this degree taken off each, and what
    /// `rough-contact stats` answers of them.
    ///
    /// # Errors
    /// [`StatsError`] of traces too short for the filters.
    pub fn statistics(&self, degree: usize) -> Result<(ProfileStatistics, Value), StatsError> {
        let (found, ..) = ProfileStatistics::of(&self.each, &self.options(degree))?;
        let mut json = contact_report::profile_statistics_json(&found);
        json["missing"] = json!(self.missing);
        json["uneven"] = contact_report::unevenness_json(self.uneven);
        json["cleaning"] = contact_report::cleaning_json(&self.cleaned);
        Ok((found, json))
    }

    /// How statistics are taken of them; `degree` is that of the polynomial that levels a trace.
    pub(crate) fn options(&self, degree: usize) -> ProfileOptions {
        ProfileOptions {
            degree,
            short: self.cleaning.s_filter,
            cutoff: self.cleaning.l_filter,
            fractal_range: None,
            height_step: self.height_step,
        }
    }
}

fn unevenness(how: Resampled) -> Unevenness {
    Unevenness { steps: how.steps, spacing: how.spacing }
}
