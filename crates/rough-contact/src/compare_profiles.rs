//! `rough-contact compare` of profiles.

use crate::against;
use crate::args::CommonOptions;
use crate::outcome::{Failure, Reply};
use crate::output::Folder;
use crate::profiles::uneven_line;
use crate::text::plain;
use crate::text::{self, Columns};
use rough_contact::compare::{
    EdgesName, ProfileComparison, ProfileSurface, RunFile, Settings, built_in,
};
use rough_contact::contact_types::{ContactState, Named};
use rough_contact::report::Provenance;
use rough_contact::{front_end, report};
use std::fmt::Write as _;
use std::path::Path;

/// Options that say how to solve for a map.
pub(crate) fn refuse_solver(settings: &Settings) -> Result<(), Failure> {
    let option = match (settings.accuracy, settings.edges) {
        _ if settings.fast => "--fast",
        _ if settings.leak.is_some() => "--leak",
        (Some(_), _) => "--accuracy",
        (None, EdgesName::Mirrored) => "--edges mirrored",
        _ => return Ok(()),
    };
    let message = format!(
        "{option} says how to solve for a map, and a profile has no deterministic answer here; leave it \
         out, or see `solve --plane-strain`"
    );
    Err(Failure::refused("combination", message))
}

pub(crate) fn run(
    surfaces: Vec<ProfileSurface>,
    settings: &Settings,
    run_file: &RunFile,
    out: &Path,
    repeat: &str,
    common: &CommonOptions,
) -> Result<Reply, Failure> {
    refuse_solver(settings)?;
    let names = front_end::document_names(Some(surfaces.len()));
    let folder = Folder::prepare(out, &names, common.force)?;
    let study = |surface| ProfileComparison::run(surface, settings.clone(), built_in());
    let studies = surfaces.into_iter().map(study).collect::<Result<Vec<_>, _>>();
    let studies = studies.map_err(|e| Failure::from(&e))?;
    let provenance = Provenance::here(repeat);
    let mut reply = Reply::new(
        describe(&studies, folder.path()),
        report::profile_comparison_json(&studies, &provenance),
    );
    let documents = front_end::profile_documents(&studies, &provenance, run_file);
    // What was computed is printed even if it cannot be written.
    reply.trouble = documents.and_then(|files| folder.write_all(files)).err();
    Ok(reply)
}

fn describe(studies: &[ProfileComparison], folder: &Path) -> String {
    let mut out = String::new();
    if let Some(ProfileComparison { settings, .. }) = studies.first() {
        let made_of = (settings.modulus, settings.bodies.clone());
        out.push_str(&against::lines(None, Some(made_of)));
    }
    for study in studies {
        let headline = plain(&report::profile_headline(study));
        let _ = writeln!(out, "{}: {headline}", study.surface.name);
        out.push_str(&text::cleaning(study.surface.origin.cleaned()));
        out.push_str(&uneven_line(study.surface.uneven));
        out.push_str(&text::findings(&study.findings()));
        out.push('\n');
        let mut columns =
            Columns::new(&["model", "area", "95 % interval", "real pressure", "applies"]);
        for model in &study.models {
            let curve = model.outcome.as_ref().ok();
            let state = curve.and_then(|c| c.points[study.headline].as_ref().ok());
            let interval = curve.and_then(|c| c.intervals[study.headline]);
            columns.row([
                model.card.title.to_string(),
                text::or_dash(state, |s| text::percent(s.area_fraction)),
                text::or_dash(interval, |[low, high]| {
                    format!("{} to {}", text::percent(low), text::percent(high))
                }),
                text::or_dash(state.and_then(ContactState::real_pressure), text::pressure),
                model.verdict.answer.name().to_owned(),
            ]);
        }
        let _ = writeln!(out, "{columns}");
    }
    let _ = writeln!(out, "report: {}", folder.join("report.html").display());
    out
}
