//! `rough-contact compare` of profiles.

use crate::against;
use crate::args::Common;
use crate::outcome::{Failure, Reply};
use crate::output::Folder;
use crate::profiles::uneven_line;
use crate::text::plain;
use crate::text::{self, Columns};
use rough_contact::compare::{
    EdgesName, ProfileComparison, ProfileSurface, Registry, RunFile, Settings,
};
use rough_contact::contact_types::ContactState;
use rough_contact::report::Provenance;
use rough_contact::{front_end, report};
use std::fmt::Write as _;
use std::io::Write as _;
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

/// Runs the study and writes the report.
pub(crate) fn run(
    surfaces: Vec<ProfileSurface>,
    settings: &Settings,
    run_file: &RunFile,
    out: &Path,
    repeat: impl Fn(&Path) -> String,
    common: &Common,
) -> Result<Reply, Failure> {
    refuse_solver(settings)?;
    let names = front_end::profile_documents_named(surfaces.len());
    let folder = Folder::prepare(out, &names, common.force)?;
    let registry = Registry::built_in();
    let mut studies = Vec::with_capacity(surfaces.len());
    for surface in surfaces {
        let study = ProfileComparison::run(surface, settings.clone(), &registry);
        studies.push(study.map_err(|e| Failure::from_error(&e))?);
    }
    let provenance = Provenance::here(repeat(folder.path()));
    let mut reply = Reply::new(
        describe(&studies, folder.path()),
        report::profile_comparison_json(&studies, &provenance),
    );
    if let Err(failure) = write(&folder, &studies, &provenance, run_file) {
        reply.trouble = Some(failure);
    }
    Ok(reply)
}

fn write(
    folder: &Folder,
    studies: &[ProfileComparison],
    provenance: &Provenance,
    run_file: &RunFile,
) -> Result<(), Failure> {
    for (name, bytes) in front_end::profile_documents(studies, provenance, run_file)? {
        folder.write(&name, |out| out.write_all(&bytes))?;
    }
    Ok(())
}

fn describe(studies: &[ProfileComparison], folder: &Path) -> String {
    let mut out = String::new();
    if let Some(ProfileComparison { settings, .. }) = studies.first() {
        let made_of = (settings.modulus, settings.bodies.clone());
        out.push_str(&against::lines(None, Some(made_of)));
    }
    for study in studies {
        let headline = plain(&report::profile_headline(study));
        let _ = writeln!(out, "{}: {headline}", study.name); // a String takes everything
        out.push_str(&text::cleaning(study.origin.cleaned()));
        out.push_str(&uneven_line(study.uneven));
        out.push_str(&text::findings(&study.findings()));
        out.push('\n');
        let mut columns =
            Columns::new(&["model", "area", "95 % interval", "real pressure", "applies"]);
        for model in &study.models {
            let state =
                model.outcome.as_ref().ok().and_then(|c| c.points[study.headline].as_ref().ok());
            let dash = || "–".to_owned();
            columns.row([
                model.card.title.to_string(),
                state.map_or_else(dash, |s| text::percent(s.area_fraction)),
                model.intervals[study.headline].map_or_else(dash, |[low, high]| {
                    format!("{} to {}", text::percent(low), text::percent(high))
                }),
                state.and_then(ContactState::real_pressure).map_or_else(dash, text::pressure),
                model.verdict.answer.word().to_owned(),
            ]);
        }
        let _ = writeln!(out, "{columns}");
    }
    let _ = writeln!(out, "report: {}", folder.join("report.html").display());
    out
}
