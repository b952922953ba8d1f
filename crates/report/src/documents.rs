//! The files that a study leaves.

use crate::figures::{curves, profiles};
use crate::provenance::Provenance;
use crate::{csv, json, page};
use contact_compare::{Comparison, ProfileComparison};
use grid_fft::parallel;

const NAMES: [&str; 5] = ["report.html", "results.json", "curves.csv", "area.svg", "pressure.svg"];

/// The files of a study, each with its name: the page, which needs no other file and no network; all results; the numbers
/// that its figures over the load draw; two of those figures, 85 mm wide.
pub fn documents(comparison: &Comparison, provenance: &Provenance) -> Vec<(&'static str, String)> {
    parallel::map(&NAMES, |name| {
        let text = match *name {
            "report.html" => page::html::report(comparison, provenance),
            "results.json" => format!("{:#}\n", json::comparison(comparison, provenance)),
            "curves.csv" => csv::of_surfaces(comparison),
            "area.svg" => curves::panels(comparison, "area", curves::area),
            _ => curves::panels(comparison, "pressure", curves::pressure),
        };
        (*name, text)
    })
}

/// The files of studies of profiles, each with its name: page, results and curves of all of them; for each the area over
/// load, 85 mm wide, and the first trace, of which nothing is drawn if it is flat.
pub fn profile_documents(
    studies: &[ProfileComparison],
    provenance: &Provenance,
) -> [(&'static str, Vec<String>); 5] {
    let results = json::profile_comparison(studies, provenance);
    let area = |study| profiles::area(study).standalone("area");
    let trace = |study| {
        profiles::first_trace(study).map_or_else(String::new, |trace| trace.standalone("trace"))
    };
    [
        ("report.html", vec![page::profile::report(studies, provenance)]),
        ("results.json", vec![format!("{results:#}\n")]),
        ("curves.csv", vec![csv::of_profiles(studies)]),
        ("area.svg", studies.iter().map(area).collect()),
        ("trace.svg", studies.iter().map(trace).collect()),
    ]
}
