//! What a study leaves: its documents, each as the bytes of a file.

use crate::failure::Failure;
use contact_compare::{Comparison, ProfileComparison, RunFile};
use contact_report::Provenance;

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
