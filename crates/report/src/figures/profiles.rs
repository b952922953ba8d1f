//! Figures of a study of profiles: the trace, and the models over the load.

use crate::draw::svg::Figure;
use crate::figures::curves::{self, Use};
use crate::figures::trace::trace;
use crate::lines::{LoadLines, ModelLine};
use crate::messages::profile::profile_headline;
use contact_compare::ProfileComparison;
use std::io::{self, Write};

/// The first trace with its evaluation length.
pub(crate) fn first_trace(study: &ProfileComparison, key: &str) -> Option<Figure> {
    let s = &study.statistics;
    // With a filter that was asked for the ends are off, and the evaluation length with them.
    let cut = 0.5 * s.options.cutoff.unwrap_or(0.0);
    let evaluated = s.roughness.as_ref().ok().map(|found| {
        let [start, end] = found.evaluated;
        ([start - cut, end - cut], found.sections)
    });
    trace(&study.traces[0], evaluated, key)
}

/// Area over load by every model, and as a band what those made of moments span together.
pub(crate) fn area(study: &ProfileComparison, key: &str) -> Figure {
    let mut figure = curves::area(&lines(study), key, Use::File);
    figure.description = profile_headline(study);
    figure
}

fn lines(study: &ProfileComparison) -> LoadLines {
    let models = study.models.iter().enumerate().filter_map(|(place, m)| {
        let curve = m.outcome.as_ref().ok()?;
        Some(ModelLine::of(&m.card, place, &curve.points))
    });
    let n = study.pressures.len();
    LoadLines {
        pressures: study.pressures.clone(),
        area: vec![None; n],
        interval: (0..n).map(|i| study.span(i).map(|(span, _)| span)).collect(),
        models: models.collect(),
        load_area: None,
        headline: study.headline,
        of: "",
    }
}

/// Real area over load as a file 85 mm wide.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_area_svg(study: &ProfileComparison, out: &mut impl Write) -> io::Result<()> {
    area(study, "area").write_standalone(out)
}

/// The trace as a file; nothing is drawn of a flat one.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_trace_svg(study: &ProfileComparison, out: &mut impl Write) -> io::Result<()> {
    first_trace(study, "trace").map_or(Ok(()), |figure| figure.write_standalone(out))
}
