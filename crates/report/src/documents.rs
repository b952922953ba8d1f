//! The files that a study leaves.

use crate::figures::{curves, profiles};
use crate::provenance::Provenance;
use crate::{csv, json, page, profile_json};
use contact_compare::{Comparison, ProfileComparison};
use grid_fft::parallel;

/// Names of the files of a study.
const NAMES: [&str; 5] = ["report.html", "results.json", "curves.csv", "area.svg", "pressure.svg"];

/// The files of a study, each with its name: the page, which needs no other file and no network; all results; the numbers
/// that its figures over the load draw; two of those figures, 85 mm wide.
pub fn documents(comparison: &Comparison, provenance: &Provenance) -> Vec<(&'static str, String)> {
    parallel::map(&NAMES, |name| {
        let text = match *name {
            "report.html" => page::html::report(comparison, provenance),
            "results.json" => format!("{:#}\n", json::comparison(comparison, provenance)),
            "curves.csv" => csv::of_surfaces(comparison),
            "area.svg" => curves::panels(comparison, "area", curves::area).standalone(),
            _ => curves::panels(comparison, "pressure", curves::pressure).standalone(),
        };
        (*name, text)
    })
}

/// The files of studies of profiles that do not depend on how many there are.
pub fn profile_documents(
    studies: &[ProfileComparison],
    provenance: &Provenance,
) -> [(&'static str, String); 3] {
    let results = profile_json::profile_comparison(studies, provenance);
    [
        ("report.html", page::profile::report(studies, provenance)),
        ("results.json", format!("{results:#}\n")),
        ("curves.csv", csv::of_profiles(studies)),
    ]
}

/// Figures of a profile as files, each with the beginning of its name: area over load, 85 mm wide, and the first trace,
/// of which nothing is drawn if it is flat.
pub fn profile_figures(study: &ProfileComparison) -> [(&'static str, String); 2] {
    let trace = profiles::first_trace(study, "trace");
    [
        ("area", profiles::area(study, "area").standalone()),
        ("trace", trace.map_or_else(String::new, |figure| figure.standalone())),
    ]
}
