//! What a study leaves: its documents, each as the bytes of a file.

use crate::failure::Failure;
use contact_compare::{Comparison, ProfileComparison, RunFile};
use contact_report::Provenance;
use grid_fft::parallel;

/// Names of the documents, in the order in which they are written.
pub const DOCUMENTS: [&str; 6] =
    ["report.html", "results.json", "curves.csv", "area.svg", "pressure.svg", "run.toml"];

/// Names of the documents of profiles that do not depend on how many there are.
pub(crate) const PROFILE_DOCUMENTS: [&str; 4] =
    ["report.html", "results.json", "curves.csv", "run.toml"];

/// Names of all documents of a study of so many profiles: figures are numbered where there are several.
pub fn profile_documents_named(count: usize) -> Vec<String> {
    let figures = ["area", "trace"].into_iter();
    let figures = figures.flat_map(|name| (0..count).map(move |i| figure_name(name, i, count)));
    PROFILE_DOCUMENTS.map(str::to_owned).into_iter().chain(figures).collect()
}

fn figure_name(figure: &str, index: usize, count: usize) -> String {
    if count == 1 { format!("{figure}.svg") } else { format!("{figure}-{}.svg", index + 1) }
}

type Unmade = Box<dyn std::error::Error + Send + Sync>;

fn failure(error: &Unmade) -> Failure {
    Failure::incomplete("output", error.to_string())
}

/// The documents of studies of profiles by name.
///
/// # Errors
/// [`Failure`] of a document that could not be made.
pub fn profile_documents(
    studies: &[ProfileComparison],
    provenance: &Provenance,
    run_file: &RunFile,
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let all = || -> Result<_, Unmade> {
        let mut made = Vec::new();
        let mut page = Vec::new();
        contact_report::write_profile_html(studies, provenance, &mut page)?;
        made.push(("report.html".to_owned(), page));
        let json = contact_report::profile_comparison_json(studies, provenance);
        made.push(("results.json".to_owned(), format!("{json:#}\n").into_bytes()));
        let mut table = Vec::new();
        contact_report::write_profile_csv(studies, &mut table)?;
        made.push(("curves.csv".to_owned(), table));
        for (i, study) in studies.iter().enumerate() {
            let [mut area, mut trace] = [Vec::new(), Vec::new()];
            contact_report::write_profile_area_svg(study, &mut area)?;
            contact_report::write_profile_trace_svg(study, &mut trace)?;
            made.push((figure_name("area", i, studies.len()), area));
            made.push((figure_name("trace", i, studies.len()), trace));
        }
        made.push(("run.toml".to_owned(), run_file.to_toml()?.into_bytes()));
        Ok(made)
    };
    all().map_err(|e| failure(&e))
}

/// The documents of a study by name.
///
/// # Errors
/// [`Failure`] of a document that could not be made.
pub fn documents(
    comparison: &Comparison,
    provenance: &Provenance,
    run_file: &RunFile,
) -> Result<Vec<(&'static str, Vec<u8>)>, Failure> {
    let made = |name| -> Result<Vec<u8>, Unmade> {
        let mut out = Vec::new();
        match name {
            "report.html" => contact_report::write_html(comparison, provenance, &mut out)?,
            "results.json" => contact_report::write_json(comparison, provenance, &mut out)?,
            "curves.csv" => contact_report::write_csv(comparison, &mut out)?,
            "area.svg" => contact_report::write_area_svg(comparison, &mut out)?,
            "pressure.svg" => contact_report::write_pressure_svg(comparison, &mut out)?,
            _ => out = run_file.to_toml()?.into_bytes(),
        }
        Ok(out)
    };
    let all = parallel::map(&DOCUMENTS, |name| Ok((*name, made(name).map_err(|e| failure(&e))?)));
    all.into_iter().collect()
}
