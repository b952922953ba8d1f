//! `rough-contact compare` of profiles.

use crate::args::Common;
use crate::input::Reading;
use crate::outcome::{Failure, Reply};
use crate::output::Folder;
use crate::profile_stats::plain;
use crate::profiles::{Traces, uneven_line};
use crate::text::{self, Columns};
use compare::{
    EdgesName, ProfileComparison, ProfileSurface, Registry, RunFile, Settings, sha256_hex,
};
use contact_types::ContactState;
use report::Provenance;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

/// What the folder receives beside the figures.
const OUTPUTS: [&str; 4] = ["report.html", "results.json", "curves.csv", "run.toml"];

/// The file of a figure: numbered where there are several surfaces.
fn figure_name(figure: &str, index: usize, count: usize) -> String {
    if count == 1 { format!("{figure}.svg") } else { format!("{figure}-{}.svg", index + 1) }
}

/// The traces of a file as a surface of the study.
pub(crate) fn from_traces(
    reading: &Reading,
    path: &Path,
    traces: Traces,
) -> Result<ProfileSurface, Failure> {
    let bytes = std::fs::read(path).map_err(|e| Failure::refused("io", e.to_string()))?;
    let origin = reading.origin(path, &traces, sha256_hex(&bytes));
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let Traces { each, uneven, .. } = traces;
    Ok(ProfileSurface { name, origin, traces: each, uneven })
}

/// Options that say how to solve for a map.
pub(crate) fn refuse_solver(settings: &Settings) -> Result<(), Failure> {
    let option = match (settings.accuracy, settings.edges) {
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
    let count = surfaces.len();
    let figures = ["area", "trace"].into_iter();
    let figures = figures.flat_map(|name| (0..count).map(move |i| figure_name(name, i, count)));
    let names: Vec<String> = OUTPUTS.map(str::to_owned).into_iter().chain(figures).collect();
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
    if let Err(failure) = write(&folder, &studies, &provenance, &reply, run_file) {
        reply.trouble = Some(failure);
    }
    Ok(reply)
}

fn write(
    folder: &Folder,
    studies: &[ProfileComparison],
    provenance: &Provenance,
    reply: &Reply,
    run_file: &RunFile,
) -> Result<(), Failure> {
    let io = |e: report::ReportError| match e {
        report::ReportError::Io(e) => e,
        other => std::io::Error::other(other),
    };
    folder.write("report.html", |out| {
        report::write_profile_html(studies, provenance, out).map_err(io)
    })?;
    folder.write("results.json", |out| writeln!(out, "{:#}", reply.json))?;
    folder.write("curves.csv", |out| report::write_profile_csv(studies, out))?;
    for (i, study) in studies.iter().enumerate() {
        let name = |figure| figure_name(figure, i, studies.len());
        folder.write(&name("area"), |out| report::write_profile_area_svg(study, out))?;
        folder.write(&name("trace"), |out| report::write_profile_trace_svg(study, out))?;
    }
    let text = run_file.to_toml().map_err(|e| Failure::incomplete("output", e.to_string()))?;
    folder.write("run.toml", |out| out.write_all(text.as_bytes()))
}

fn describe(studies: &[ProfileComparison], folder: &Path) -> String {
    let mut out = String::new();
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
