//! What a study answers beyond its loads, what is incomplete about it, and its documents.

use crate::failure::Failure;
use crate::shown;
use contact_compare::{
    Comparison, DeterministicPoint, Listener, ProfileComparison, Reached, RunFile, StudyError,
};
use contact_report::{Provenance, plan_reason};

/// What is computed once the loads are: coarser grids, the shortest octaves taken off, a closer look at the headline.
///
/// # Errors
/// [`Failure`] of what was not finished.
pub fn look_around(
    comparison: &mut Comparison,
    listener: &mut Listener<'_>,
) -> Result<(), Failure> {
    let incomplete = |(stage, why): (&str, StudyError)| Failure::incomplete(stage, why.to_string());
    comparison.look_around(listener).map_err(incomplete)
}

/// Loads that did not converge; those without an answer were refused.
fn unsolved(comparison: &Comparison) -> impl Iterator<Item = Failure> {
    let points =
        comparison.surfaces.iter().flat_map(|s| s.deterministic.iter().map(|p| (&s.name, p)));
    points.filter_map(|(name, point): (&String, &DeterministicPoint)| {
        let pressure = shown::pressure(point.mean_pressure);
        let message = format!("{name}, {pressure}: {}", point.trouble.as_ref()?);
        Some(match point.answer {
            Some(_) => Failure::incomplete("not_converged", message),
            None => Failure::refused("bad_load", message),
        })
    })
}

/// Surfaces without a study, loads that were refused or did not converge, and plans that miss the accuracy asked for.
pub fn not_met(comparison: &Comparison) -> Option<Failure> {
    let unmet = comparison
        .surfaces
        .iter()
        .filter_map(|surface| unmet(&surface.name, surface.plan.as_ref()?));
    let refused = comparison.refused.iter().map(|r| {
        let of = if r.reason.contains(&r.name) { String::new() } else { format!("{}: ", r.name) };
        Failure::incomplete("files_failed", format!("no answer: {of}{}", r.reason))
    });
    refused.chain(unsolved(comparison)).chain(unmet).reduce(Failure::and)
}

/// A request that is not met ends with exit status 1.
pub(crate) fn unmet(surface: &str, reached: &Reached) -> Option<Failure> {
    let reason = plan_reason(reached)?;
    let percent = 100.0 * reached.request?.relative();
    let of = if surface.is_empty() { String::new() } else { format!("{surface}: ") };
    let message = format!("{of}an accuracy of {percent} % of the area is not met: {reason}");
    Some(Failure::incomplete("accuracy_not_met", message))
}

/// Names of all documents of a study of maps, or of so many profiles: figures are numbered where there are several.
pub fn document_names(profiles: Option<usize>) -> Vec<String> {
    let (second, count) = profiles.map_or(("pressure.svg", 1), |count| ("trace.svg", count));
    let figures = ["area.svg", second].into_iter();
    let figures = figures.flat_map(|name| (0..count).map(move |i| numbered(name, i, count)));
    let others = ["report.html", "results.json", "curves.csv", "run.toml"].map(str::to_owned);
    others.into_iter().chain(figures).collect()
}

fn numbered(name: &str, index: usize, count: usize) -> String {
    if count == 1 { name.to_owned() } else { name.replace('.', &format!("-{}.", index + 1)) }
}

/// The documents of studies of profiles by name.
///
/// # Errors
/// [`Failure`] of a run file that could not be made.
pub fn profile_documents(
    studies: &[ProfileComparison],
    provenance: &Provenance,
    run_file: &RunFile,
) -> Result<Vec<(String, String)>, Failure> {
    let mut made = Vec::new();
    for (name, texts) in contact_report::profile_documents(studies, provenance) {
        let count = texts.len();
        let named = |(i, text)| (numbered(name, i, count), text);
        made.extend(texts.into_iter().enumerate().map(named));
    }
    made.push(("run.toml".to_owned(), settings(run_file)?));
    Ok(made)
}

fn settings(run_file: &RunFile) -> Result<String, Failure> {
    run_file.to_toml().map_err(|e| Failure::incomplete("output", e.to_string()))
}

/// The documents of a study by name.
///
/// # Errors
/// [`Failure`] of a run file that could not be made.
pub fn documents(
    comparison: &Comparison,
    provenance: &Provenance,
    run_file: &RunFile,
) -> Result<Vec<(&'static str, String)>, Failure> {
    let mut made = contact_report::documents(comparison, provenance);
    made.push(("run.toml", settings(run_file)?));
    Ok(made)
}
