//! `rough-contact compare`: the study and its report, of maps and of profiles.

use crate::against::{self, Against};
use crate::args::{self, CommonOptions, List};
use crate::contact::ContactOptions;
use crate::input::{FileOptions, One};
use crate::leak;
use crate::loads::Forces;
use crate::outcome::{Failure, Folder, Reply};
use crate::profiles::uneven_line;
use crate::progress::ProgressDisplay;
use crate::surfaces::{distinct, parted, repeat};
use crate::text::{self, Columns, plain};
use crate::units::Dimension::{Number, Pressure};
use clap::Args;
use rough_contact::compare::{
    Comparison, EdgesName, ModelCurve, ProfileComparison, ProfileSurface, Refused, RunFile,
    Settings, Surface, built_in, on_threads,
};
use rough_contact::contact_types::{ContactState, Named};
pub(crate) use rough_contact::front_end::not_met;
use rough_contact::front_end::run_file_in;
use rough_contact::report::Provenance;
use rough_contact::{compare, front_end, report};
use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Most files that have a section each; the pictures of more make a page of many megabytes.
const MOST_SECTIONS: usize = 10;

#[derive(Args, Clone, Debug)]
pub(crate) struct Compare {
    /// Surface files, and folders whose files are taken; without any, three built-in surfaces:
    /// polished, ground, blasted
    #[arg(value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// Nominal pressures [default: chosen so that about 0.1 % to half of the surface touches]
    #[arg(long, value_name = "LIST", value_parser = args::list(Pressure), allow_hyphen_values = true)]
    pressure: Option<List>,
    #[command(flatten)]
    forces: Forces,
    /// Pressure of headline and contact map, one of --pressure [default: at about 2 % contact]
    #[arg(long, value_name = "P", value_parser = args::one(Pressure), allow_hyphen_values = true)]
    headline: Option<f64>,
    #[command(flatten)]
    contact: ContactOptions,
    /// Models to ask, such as gw,persson [default: every one that a surface gives all it needs]
    #[arg(long, value_name = "LIST", value_parser = args::study_models(), value_delimiter = ',')]
    #[arg(ignore_case = true)]
    models: Option<Vec<String>>,
    /// Shortest and longest wavelength of the fractal fit [default: cut-off to roll-off as found]
    #[arg(long, value_name = "L,L", value_parser = args::range, allow_hyphen_values = true)]
    fractal_range: Option<[f64; 2]>,
    /// Weight of partial contact in Persson's mean gap: 0.45 (Yang & Persson 2008) or 1 (Persson 2007); given, the
    /// gap is among the results [default: 0.45, where his stiffness is asked for]
    #[arg(long, value_name = "G", value_parser = args::one(Number), allow_hyphen_values = true)]
    gamma: Option<f64>,
    /// Repeat the run that wrote this run.toml
    #[arg(long, value_name = "RUN.TOML")]
    from: Option<PathBuf>,
    /// Folder for report.html, results.json, curves.csv, area.svg, pressure.svg and run.toml
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// Each file by itself, and a page of distributions in place of a section for each [default: for
    /// a folder, or more than 10 files]
    #[arg(long)]
    pub(crate) summary: bool,
    /// Go on with a summary in --out: answers to the same content and the same options are kept
    #[arg(long)]
    pub(crate) resume: bool,
    #[command(flatten)]
    pub(crate) against: Against,
    #[command(flatten)]
    how: FileOptions,
}

impl Compare {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        let mut unread = Vec::new();
        let (mut settings, mut surfaces) = if let Some(path) = &self.from {
            repeat(path)?
        } else {
            let (settings, surfaces) = (self.settings()?, self.surfaces(&mut unread)?);
            let area = |one: &One| match one {
                One::Map(map) => Some(map.heights.grid().area()),
                One::Profile(_) => None,
            };
            (self.loaded(settings, surfaces.iter().filter_map(area))?, surfaces)
        };
        settings.threads = common.threads();
        let named = surfaces.iter_mut().map(|one| {
            let (name, origin) = one.named();
            (&*name, origin)
        });
        let run_file = RunFile::of(&settings, named);
        let (run_file, repeat) = (run_file_in(run_file, &self.out), repeat_command(&self.out));
        let (surfaces, profiles) = parted(surfaces)?;
        if !profiles.is_empty() {
            let out = &self.out;
            return run_profiles(profiles, &settings, &run_file, out, &repeat, common);
        }
        let names = front_end::document_names(None);
        let folder = Folder::prepare(&self.out, &names, common.force)?;
        on_threads(settings.threads, || {
            let mut comparison = study(surfaces, settings, common)?;
            comparison.refused.extend(unread);
            let provenance = Provenance::here(repeat);
            let mut reply = Reply::new(
                describe(&comparison, &folder.path),
                report::comparison_json(&comparison, &provenance),
            );
            reply.trouble = not_met(&comparison);
            // What was computed is printed even if it cannot be written.
            let documents = front_end::documents(&comparison, &provenance, &run_file);
            if let Err(failure) = documents.and_then(|files| folder.write_all(files)) {
                reply.trouble = Some(failure);
            }
            Ok(reply)
        })
    }

    /// True if every file is answered by itself, and the page shows distributions.
    pub(crate) fn is_summary(&self) -> bool {
        let many = self.files.len() > MOST_SECTIONS || self.files.iter().any(|f| f.is_dir());
        self.from.is_none() && !self.files.is_empty() && (self.summary || self.resume || many)
    }

    pub(crate) fn settings(&self) -> Result<Settings, Failure> {
        self.forces.given()?; // refused before any work
        let ContactOptions { bodies, hardness, .. } = &self.contact;
        let made_of = match bodies.given(*hardness)? {
            None if self.files.is_empty() => bodies.steel().required(*hardness)?,
            _ => bodies.required(*hardness)?,
        };
        Ok(Settings {
            pressures: self.pressure.as_ref().map(|List(pressures)| pressures.clone()),
            headline: self.headline,
            models: self.models.clone(),
            gamma: self.gamma,
            fractal_range: self.fractal_range,
            ..self.contact.settings(made_of, &self.forces)?
        })
    }

    /// With --load, its pressures on the area that carries it.
    pub(crate) fn loaded(
        &self,
        mut settings: Settings,
        areas: impl IntoIterator<Item = f64>,
    ) -> Result<Settings, Failure> {
        if let Some(spread) = self.forces.spread(areas)? {
            (settings.pressures, settings.load_area) = (Some(spread.pressures), Some(spread.area));
        }
        Ok(settings)
    }

    pub(crate) fn read(&self, path: &Path) -> Result<One, Failure> {
        self.against.measured(path, &self.how, self.contact.level, true)
    }

    /// What is in the files. One that cannot be read costs the others nothing: it goes to `unread`.
    fn surfaces(&self, unread: &mut Vec<Refused>) -> Result<Vec<One>, Failure> {
        if !self.files.is_empty() {
            let (mut all, mut first) = (Vec::new(), None);
            for path in &self.files {
                match self.read(path) {
                    Ok(one) => all.push(one),
                    Err(failure) => {
                        let shown = path.display().to_string();
                        let message = &failure.message;
                        let reason = message.strip_prefix(&format!("{shown}: ")).unwrap_or(message);
                        let name = path.file_name().map_or(shown, |n| n.to_string_lossy().into());
                        unread.push(Refused { name, reason: reason.to_owned() });
                        first.get_or_insert(failure);
                    }
                }
            }
            if let Some(failure) = first
                && all.is_empty()
            {
                return Err(failure);
            }
            distinct(&mut all);
            return Ok(all);
        }
        self.how.cleaning.refuse_without_file()?;
        if self.against.given()?.is_some() {
            let message = "--against is for a second body on a surface FILE, and none is given";
            return Err(Failure::refused("usage", message));
        }
        let recipes = compare::built_in_recipes();
        let made = recipes.iter().map(|recipe| recipe.make().map(|map| One::Map(Box::new(map))));
        made.collect::<Result<_, _>>().map_err(|e| Failure::from(&e))
    }
}

/// The command that repeats the run, from the folder it was made in, into a folder that is not there yet.
fn repeat_command(out: &Path) -> String {
    let again = format!("{}-again", out.display().to_string().trim_end_matches(['/', '\\']));
    let run_file = out.join("run.toml").display().to_string();
    format!("rough-contact compare --from {} --out {}", quoted(&run_file), quoted(&again))
}

pub(crate) fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "/._-+:\\~".contains(c);
    if word.chars().all(is_plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

fn study(
    surfaces: Vec<Surface>,
    settings: Settings,
    common: &CommonOptions,
) -> Result<Comparison, Failure> {
    let mut progress = ProgressDisplay::new(common.quiet, 0);
    let (mut current, mut steps) = (String::new(), 0);
    let comparison = Comparison::run(surfaces, settings, built_in(), &mut |news| {
        match news {
            compare::Progress::Surface { name, index, count, loads } => {
                current = format!("{name} ({} of {count})", index + 1);
                steps = loads + 1;
                progress.restart(steps);
                progress.working_on(&format!("{current}: first load"));
            }
            compare::Progress::Solved { index, mean_pressure, area_fraction, .. } => {
                if index == 0 {
                    progress.restart(steps); // again, on another grid for an accuracy
                }
                let area = area_fraction.map_or_else(|| "no answer".to_owned(), text::percent);
                progress.step(&format!("{current}: {}, {area}", text::pressure(mean_pressure)));
            }
            compare::Progress::Iterated { now, .. } => {
                progress.iterating(|| text::iterating(&current, now.number, now.residual));
            }
            compare::Progress::Models => {
                progress.step(&format!("{current}: models"));
            }
            _ => {}
        }
        ControlFlow::Continue(())
    });
    let mut comparison = comparison.map_err(|e| Failure::from(&e))?;
    progress.working_on("coarser grids");
    let mut watch = |news: compare::Progress<'_>| {
        if let compare::Progress::Iterated { now, .. } = news {
            progress.iterating(|| text::iterating("a closer look", now.number, now.residual));
        }
        ControlFlow::Continue(())
    };
    front_end::look_around(&mut comparison, &mut watch)?;
    drop(progress);
    Ok(comparison)
}

fn describe(comparison: &Comparison, folder: &Path) -> String {
    let mut out = String::new();
    for same in comparison.surfaces.chunk_by(|a, b| a.statistics.level == b.statistics.level) {
        // Whose it is, where it is not that of all.
        if same.len() < comparison.surfaces.len() {
            let names: Vec<_> = same.iter().map(|s| s.name.as_str()).collect();
            let _ = write!(out, "{}: ", names.join(", "));
        }
        out.push_str(&text::level(comparison.settings.level, same[0].statistics.level));
    }
    out.push_str(text::MOMENTS);
    if let Some(line) = report::loads_line(&comparison.settings) {
        let _ = writeln!(out, "load: {}", plain(&line));
    }
    let made_of = (comparison.settings.modulus, comparison.settings.bodies.clone());
    // Of pairs each says what its bodies are made of.
    if comparison.surfaces.iter().any(|s| s.origin.pair().is_none()) {
        out.push_str(&against::lines(None, Some(made_of.clone())));
    }
    out.push_str(&text::materials(&comparison.settings.materials));
    for surface in &comparison.surfaces {
        for line in report::surface_lines(surface) {
            let _ = writeln!(out, "{line}");
        }
        let loads =
            surface.deterministic.iter().map(|point| point.mean_pressure).zip(&surface.leaks);
        let leaks = loads.filter_map(|(pressure, leaks)| Some((pressure, leaks.as_ref()?)));
        let Settings { leak, modulus, hardness, .. } = &comparison.settings;
        out.push_str(&leak::lines(leak.as_ref(), leaks, *modulus, hardness.is_some()));
        if let Some(pair) = surface.origin.pair() {
            out.push_str(&against::lines(Some(pair), Some(made_of.clone())));
        }
        out.push_str(&text::cleaning(surface.origin.cleaned()));
        out.push_str(&text::findings(&compare::findings(surface)));
        if let Some(plan) = &surface.plan {
            let _ = writeln!(out, "{}", report::plan_explanation(plan));
        }
        out.push('\n');
        for reference in report::references(surface) {
            if !reference.of.is_empty() {
                let _ = writeln!(out, "against the solution of {}:", reference.of);
            }
            let _ = writeln!(out, "{}", models(&reference));
        }
    }
    let _ = writeln!(out, "report: {}", folder.join("report.html").display());
    out
}

/// The models that one solution judges, and that solution.
fn models(reference: &report::Reference<'_>) -> Columns {
    let heads =
        ["model", "mean |area error|", "range over the loads", "once + per load", "applies"];
    let mut columns = Columns::new(&heads);
    let dash = || "–".to_owned();
    for (_, model) in &reference.models {
        let curve = model.outcome.as_ref().ok();
        let percent = |(_, mean)| plain(&report::numbers::percent(mean));
        let range = |(low, high)| plain(&report::numbers::signed_range(low, high));
        columns.row([
            model.card.title.to_string(),
            text::or_dash(curve.and_then(ModelCurve::worst_and_mean), percent),
            text::or_dash(curve.and_then(ModelCurve::range), range),
            text::or_dash(curve, |c| {
                format!("{} + {}", text::seconds(c.preparation), text::seconds(c.seconds))
            }),
            model.verdict.answer.name().to_owned(),
        ]);
    }
    let solved: Vec<f64> = reference
        .points
        .iter()
        .filter_map(|p| Some(p.answer.as_ref()?.diagnostics.seconds))
        .collect();
    if !solved.is_empty() {
        let mean = solved.iter().sum::<f64>() / solved.len() as f64;
        columns.row(["Deterministic".into(), dash(), dash(), text::seconds(mean), dash()]);
    }
    columns
}

/// Options that say how to solve for a map.
fn refuse_solver(settings: &Settings) -> Result<(), Failure> {
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

fn run_profiles(
    surfaces: Vec<ProfileSurface>,
    settings: &Settings,
    run_file: &RunFile,
    out: &Path,
    repeat: &str,
    common: &CommonOptions,
) -> Result<Reply, Failure> {
    refuse_solver(settings)?;
    let names = |count| front_end::document_names(Some(count));
    let folder = Folder::numbered(out, names, surfaces.len(), common.force)?;
    let study = |surface| ProfileComparison::run(surface, settings.clone(), built_in());
    let studies = surfaces.into_iter().map(study).collect::<Result<Vec<_>, _>>();
    let studies = studies.map_err(|e| Failure::from(&e))?;
    let provenance = Provenance::here(repeat);
    let mut reply = Reply::new(
        describe_profiles(&studies, &folder.path),
        report::profile_comparison_json(&studies, &provenance),
    );
    let documents = front_end::profile_documents(&studies, &provenance, run_file);
    // What was computed is printed even if it cannot be written.
    reply.trouble = documents.and_then(|files| folder.write_all(files)).err();
    Ok(reply)
}

fn describe_profiles(studies: &[ProfileComparison], folder: &Path) -> String {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_to_repeat_names_the_run_file_and_a_new_folder() {
        for (folder, arguments) in [
            ("out/a", "out/a/run.toml --out out/a-again"),
            ("my out", "'my out/run.toml' --out 'my out-again'"),
        ] {
            let expected = format!("rough-contact compare --from {arguments}");
            assert_eq!(repeat_command(Path::new(folder)), expected);
        }
        assert_eq!(quoted("it's"), "'it'\\''s'");
    }
}
