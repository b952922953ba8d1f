//! What a study leaves: its documents, each as the bytes of a file.

use crate::failure::Failure;
use compare::{Comparison, RunFile};
use report::{Provenance, ReportError};

/// Names of the documents, in the order in which they are written.
pub const DOCUMENTS: [&str; 6] =
    ["report.html", "results.json", "curves.csv", "area.svg", "pressure.svg", "run.toml"];

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
                report::write_html(comparison, provenance, &mut out).map_err(failed)?;
            }
            "results.json" => {
                report::write_json(comparison, provenance, &mut out).map_err(failed)?;
            }
            "curves.csv" => report::write_csv(comparison, &mut out).map_err(|e| unmade(&e))?,
            "area.svg" => report::write_area_svg(comparison, &mut out).map_err(|e| unmade(&e))?,
            "pressure.svg" => {
                report::write_pressure_svg(comparison, &mut out).map_err(|e| unmade(&e))?;
            }
            _ => out = run_file.to_toml().map_err(|e| unmade(&e))?.into_bytes(),
        }
        Ok(out)
    };
    DOCUMENTS.into_iter().map(|name| Ok((name, made(name)?))).collect()
}
