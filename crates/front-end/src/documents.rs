//! What a study leaves: its documents, each as the bytes of a file.

use crate::failure::Failure;
use contact_compare::{Comparison, ProfileComparison, RunFile};
use contact_report::{Provenance, ReportError};
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

/// The documents of studies of profiles by name.
///
/// # Errors
/// [`Failure`] of a document that could not be made.
pub fn profile_documents(
    studies: &[ProfileComparison],
    provenance: &Provenance,
    run_file: &RunFile,
) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let unmade = |e: &dyn std::fmt::Display| Failure::incomplete("output", e.to_string());
    let mut made = Vec::new();
    let mut out = Vec::new();
    contact_report::write_profile_html(studies, provenance, &mut out).map_err(|e| unmade(&e))?;
    made.push(("report.html".to_owned(), std::mem::take(&mut out)));
    let json = contact_report::profile_comparison_json(studies, provenance);
    made.push(("results.json".to_owned(), format!("{json:#}\n").into_bytes()));
    contact_report::write_profile_csv(studies, &mut out).map_err(|e| unmade(&e))?;
    made.push(("curves.csv".to_owned(), std::mem::take(&mut out)));
    for (i, study) in studies.iter().enumerate() {
        contact_report::write_profile_area_svg(study, &mut out).map_err(|e| unmade(&e))?;
        made.push((figure_name("area", i, studies.len()), std::mem::take(&mut out)));
        contact_report::write_profile_trace_svg(study, &mut out).map_err(|e| unmade(&e))?;
        made.push((figure_name("trace", i, studies.len()), std::mem::take(&mut out)));
    }
    let text = run_file.to_toml().map_err(|e| unmade(&e))?;
    made.push(("run.toml".to_owned(), text.into_bytes()));
    Ok(made)
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
    let unmade = |e: &dyn std::fmt::Display| Failure::incomplete("output", e.to_string());
    let made = |name| -> Result<Vec<u8>, Failure> {
        let (mut out, failed) = (Vec::new(), |e: ReportError| unmade(&e));
        match name {
            "report.html" => {
                contact_report::write_html(comparison, provenance, &mut out).map_err(failed)?;
            }
            "results.json" => {
                contact_report::write_json(comparison, provenance, &mut out).map_err(failed)?;
            }
            "curves.csv" => {
                contact_report::write_csv(comparison, &mut out).map_err(|e| unmade(&e))?;
            }
            "area.svg" => {
                contact_report::write_area_svg(comparison, &mut out).map_err(|e| unmade(&e))?;
            }
            "pressure.svg" => {
                contact_report::write_pressure_svg(comparison, &mut out).map_err(|e| unmade(&e))?;
            }
            _ => out = run_file.to_toml().map_err(|e| unmade(&e))?.into_bytes(),
        }
        Ok(out)
    };
    let all = parallel::map(&DOCUMENTS, |name| Ok((*name, made(name)?)));
    all.into_iter().collect()
}
