//! `rough-contact solve`: the deterministic solution.

use crate::against::{self, Against};
use crate::args::{self, CommonOptions};
use crate::batch::{self, How, PerFile, Shown};
use crate::contact::ContactOptions;
use crate::fields::{Field, FieldFolder, FieldOptions};
use crate::files::{Files, folder_name};
use crate::input::{FileOptions, One};
use crate::loads::{Loads, carried, rising, shown};
use crate::outcome::{Failure, Reply, unfit};
use crate::progress::ProgressDisplay;
use crate::text::{self, Columns};
use crate::{conduction, leak};
use clap::Args;
use rough_contact::compare::{
    BULK_YIELD, DeterministicAnswer, EdgesName, Hardness, Joint, Origin, ProfileSurface, Settings,
    Surface, on_threads,
};
use rough_contact::contact_accuracy::{Estimate, NoUncertainty};
use rough_contact::contact_types::{Grid, HeightMap, Named};
use rough_contact::fft_bem_solver::{Boundary, Iteration, Load, Solution};
use rough_contact::front_end::bodies::Bodies;
use rough_contact::front_end::shown::unusual_hardness;
use rough_contact::front_end::{Point, SolveRequest, SolveResult, Subject, Watch};
use rough_contact::report;
use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

#[derive(Args, Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "one for each flag of the command")]
pub(crate) struct Solve {
    #[command(flatten)]
    loads: Loads,
    #[command(flatten)]
    contact: ContactOptions,
    /// What lies beyond the edges: the same map again, or nothing
    #[arg(long, value_parser = args::one_of::<Boundary>(), default_value = "periodic")]
    boundary: Boundary,
    #[arg(long, hide = true, num_args = 0, default_missing_value = "", value_parser = args::refine_is_gone)]
    refine: Option<bool>,
    /// Prove how wrong each answer may be, for one more FFT convolution: energy_bound in the JSON
    #[arg(long)]
    certify: bool,
    /// Contact stiffness too, of the contact set of each load
    #[arg(long)]
    stiffness: bool,
    /// Take a profile for the cross-section of ridges that are infinitely long: plane strain
    #[arg(long)]
    plane_strain: bool,
    #[command(flatten)]
    fields: FieldOptions,
    /// Distributions of pressure, gap and contact spots of each load: in the JSON
    #[arg(long)]
    distributions: bool,
    #[command(flatten)]
    against: Against,
    #[command(flatten)]
    files: Files,
    #[command(flatten)]
    how: FileOptions,
}

const PLANE_STRAIN: &str = "plane strain: the trace is the cross-section of parallel ridges that are \
infinitely long; a surface that is rough in both directions touches differently. Mean pressure is load \
per length of ridge over the length of the trace. Ends of unequal height make a step, unless with \
--edges mirrored.\n";

const CHOSEN_GRID: &str = "--fields heights and displacement are on the grid of the file, and --accuracy and \
                           --fast choose a grid of their own; leave them out, or give --tolerance";

const FREE_GAP: &str = "--gap cannot be prescribed with --boundary free: the mean gap of an isolated \
                        contact depends on where one stops looking; give --pressure, or solve with \
                        --boundary periodic";

const FREE_MIRRORED: &str = "--edges mirrored puts mirror images beyond the edges and --boundary free nothing; give \
                             one of them";

impl Solve {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        batch::run(self, &self.files, common)
    }
}

impl PerFile for Solve {
    const NAME: &'static str = "solve";
    const SHOWN: &'static [Shown] = &[
        Shown { head: "points", at: &["/shape"], how: How::Shape },
        Shown { head: "against", at: &["/pair/second/name"], how: How::Word },
        Shown { head: "load", at: &["/points/*/load"], how: How::Force },
        Shown { head: "resistance", at: &["/points/*/electrical_resistance"], how: How::In("Ω") },
        Shown {
            head: "thermal resistance",
            at: &["/points/*/thermal_resistance"],
            how: How::In("K/W"),
        },
        Shown { head: "mean pressure", at: &["/points/*/mean_pressure"], how: How::Pressure },
        Shown { head: "area", at: &["/points/*/area_fraction"], how: How::Percent },
        Shown { head: "mean gap", at: &["/points/*/mean_gap"], how: How::Length },
        Shown { head: "real pressure", at: &["/points/*/real_pressure"], how: How::Pressure },
        Shown { head: "stiffness", at: &["/points/*/stiffness"], how: How::In("Pa/m") },
        Shown { head: "leak x", at: &["/points/*/leak/x/permeability"], how: How::In("m³") },
        Shown { head: "leak y", at: &["/points/*/leak/y/permeability"], how: How::In("m³") },
        Shown { head: "time", at: &["/points/*/seconds"], how: How::Seconds },
        Shown { head: "to check", at: &["/findings"], how: How::Checks },
    ];

    fn beside(&self) -> String {
        self.against.content()
    }

    fn about(&self) -> String {
        self.bodies().map_or_else(
            |_| String::new(),
            |made_of| against::lines(None, Some((made_of.modulus.pascals(), made_of.bodies))),
        )
    }

    fn is_complete(&self, file: &Path) -> bool {
        let loads = self.loads.count().unwrap_or(0);
        let names = self.fields.names(loads);
        let all = |maps: &PathBuf| names.iter().all(|name| maps.join(name).exists());
        self.maps_of(file).as_ref().is_none_or(all)
    }

    fn answer(&self, path: &Path, common: &CommonOptions) -> Result<Reply, Failure> {
        let settings = self.contact.settings(self.bodies()?, &self.loads.forces)?;
        let count = self.loads.count()?;
        let is_free = self.boundary == Boundary::Free;
        let mirrored = self.contact.edges == EdgesName::Mirrored;
        let unfit = [
            (is_free && self.loads.gap.is_some(), FREE_GAP),
            (is_free && mirrored, FREE_MIRRORED),
            (self.contact.chooses_grid() && self.fields.needs(Field::Heights), CHOSEN_GRID),
        ];
        if let Some((_, why)) = unfit.into_iter().find(|(is_unfit, _)| *is_unfit) {
            return Err(Failure::refused("combination", why));
        }
        let repeats = !is_free && !mirrored;
        let surface = self.section(path, &settings)?;
        let maps =
            FieldFolder::prepare(self.fields.to(self.maps_of(path)), count, repeats, common.force)?;
        let spread = self.loads.forces.spread([surface.heights.grid().area()])?;
        let question = SolveRequest {
            loads: self.loads.each(spread.as_ref()),
            spread,
            settings,
            boundary: self.boundary,
            plane_strain: self.plane_strain,
            certify: self.certify,
            stiffness: self.stiffness,
            distributions: self.distributions,
            keep_gap: self.fields.needs(Field::Gap),
        };
        let origin = surface.origin.clone();
        let cleaned = origin.cleaned().to_vec();
        let subject = Subject { path, surface, cleaned, fill: self.how.reading.fill.name() };
        let progress = ProgressDisplay::new(common.quiet, question.loads.len());
        let mut terminal =
            Terminal { progress, maps, needs_heights: self.fields.needs(Field::Heights) };
        let solve = || question.solve(subject, &mut None, &mut terminal);
        let answer = on_threads(common.threads(), solve)?;
        drop(terminal);
        Ok(self.reply(answer, &question, &origin))
    }
}

struct Terminal {
    progress: ProgressDisplay,
    maps: Option<FieldFolder>,
    needs_heights: bool,
}

impl Watch for Terminal {
    fn levelled(&mut self, map: &HeightMap) {
        if let Some(maps) = self.maps.as_mut().filter(|_| self.needs_heights) {
            maps.surface = Some(map.clone());
        }
    }

    fn begin(&mut self, grid: Grid, loads: usize) {
        self.progress.restart(loads);
        let [ny, nx] = grid.shape();
        self.progress.working_on(&format!("{ny} × {nx} points"));
    }

    fn iterated(&mut self, _: usize, load: Load, now: &Iteration<'_>) -> ControlFlow<()> {
        self.progress.iterating(|| text::iterating(&shown(load), now.number, now.residual));
        ControlFlow::Continue(())
    }

    fn keep(&mut self, index: usize, grid: Grid, solution: &mut Solution) -> Result<(), Failure> {
        self.maps.as_ref().map_or(Ok(()), |maps| maps.write(index, grid, solution))
    }

    fn done(&mut self, _: usize, load: Load) {
        self.progress.step(&shown(load));
    }
}

impl Solve {
    /// The folder of its maps; those of several files are kept apart in folders with their names.
    fn maps_of(&self, file: &Path) -> Option<PathBuf> {
        let only = self.files.only().is_some();
        let apart = |maps: &PathBuf| if only { maps.clone() } else { maps.join(folder_name(file)) };
        self.fields.maps.as_ref().map(apart)
    }

    fn bodies(&self) -> Result<Bodies, Failure> {
        self.contact.bodies.required(self.contact.hardness)
    }

    /// The map, or the one trace that is to be solved in plane strain.
    fn section(&self, path: &Path, settings: &Settings) -> Result<Surface, Failure> {
        let refused = |why: &str| unfit(path, "profile", why);
        if !self.plane_strain {
            return match self.against.measured(path, &self.how, settings.level, false)? {
                One::Map(map) => Ok(*map),
                One::Profile(_) => Err(refused(
                    "this is a profile, and a surface has no deterministic answer from one line of it; give \
                     --plane-strain if it is the cross-section of long parallel ridges, or see `model` and \
                     `compare`, which take it for a line of an isotropic surface",
                )),
            };
        }
        let One::Profile(traces) = self.how.measured(path, false)? else {
            return Err(refused(
                "this is a map, and --plane-strain is for a profile; leave it out, or cut out a row with \
                 --crop Y0,0,1,NX",
            ));
        };
        let of_maps = [
            self.contact.chooses_grid(),
            self.stiffness || settings.joint().is_asked(),
            settings.leak.is_some() || settings.adhesion.is_some(),
        ];
        let wrong = [
            (
                self.against.given()?.is_some(),
                "--against presses two maps on each other, and --plane-strain is for one profile; leave \
                 one of them out",
            ),
            (
                self.loads.forces.given()?.is_some(),
                "--load is a force on an area, and in plane strain a load is a force on a length of ridge; \
                 give --pressure",
            ),
            (
                self.boundary == Boundary::Free,
                "--boundary free is for a contact that ends in all directions; ridges in plane strain do \
                 not: leave it out",
            ),
            (
                of_maps.contains(&true),
                "--accuracy, --fast, --stiffness, --resistivity, --conductivity, --leak and \
                 --work-of-adhesion are for maps; give --tolerance with --plane-strain",
            ),
            (
                traces.traces.len() > 1,
                "several traces are several solutions; choose one with --channel NAME",
            ),
        ];
        if let Some((_, message)) = wrong.iter().find(|(is_given, _)| *is_given) {
            return Err(refused(message));
        }
        let ProfileSurface { name, origin, traces, .. } = *traces;
        Ok(Surface { name, origin, heights: HeightMap::clone(&traces[0]) })
    }

    fn reply(&self, answer: SolveResult, question: &SolveRequest, origin: &Origin) -> Reply {
        let settings = &question.settings;
        let spread = question.spread.as_ref();
        let (joint, yields) = (settings.joint(), answer.hardness.is_some());
        let columns = table(&answer, question);
        let gap = |p: &Point| p.answer.as_ref()?.mean_gap;
        let gaps: Vec<f64> = answer.points.iter().filter_map(gap).collect();
        let solved = |p: &'_ Point| Some(p.answer.as_ref()?.budget.mean_pressure.value);
        let leaks = answer.points.iter().filter_map(|p| Some((solved(p)?, p.leak.as_ref()?)));
        let modulus = settings.modulus;
        let part = Joint { area: answer.json["nominal_area"].as_f64(), ..joint };
        let mut text = [
            text::cleaning(origin.cleaned()),
            text::findings(&answer.findings),
            columns.to_string(),
            leak::lines(settings.leak.as_ref(), leaks, modulus, yields),
            spread.map_or_else(String::new, carried),
            against::lines(origin.pair(), Some((modulus, settings.bodies.clone()))),
            text::level(settings.level, answer.level),
            conduction::line(&part, &gaps),
            text::materials(&settings.materials),
        ]
        .concat();
        if self.plane_strain {
            text += PLANE_STRAIN;
        }
        if answer.plan.is_none() {
            text += &notes(&answer.points);
        }
        if let Some(given) = answer.hardness {
            let highest = answer.points.iter().filter_map(solved).fold(0.0, f64::max);
            text += &yield_lines(given, highest);
        }
        if let Some(reached) = &answer.plan {
            text += &(report::plan_explanation(reached) + "\n");
        }
        Reply { text, json: answer.json, trouble: answer.trouble }
    }
}

/// A row for each load: a dash where an answer lacks a number, blanks after `refused` and where no conductance was found.
fn table(answer: &SolveResult, question: &SolveRequest) -> Columns {
    let (points, asked) = (&answer.points, &question.settings.joint());
    let mut columns = Columns::default();
    if question.spread.is_some() {
        columns.column("load", points.iter().map(|p| text::or_dash(p.force, text::force)));
    }
    for (k, heading) in conduction::first_headings(asked, true).into_iter().enumerate() {
        let cell = |p: &Point| conduction::first_cell(p.conducted.as_ref(), asked, k);
        columns.column(heading, points.iter().map(cell));
    }
    let load = |p: &Point| match &p.answer {
        Some(answer) => text::pressure(answer.budget.mean_pressure.value),
        None => shown(p.load),
    };
    columns.column("mean pressure", points.iter().map(load));
    let mut otherwise = "refused"; // in the first of these columns
    let mut add = |heading: &str, cell: &dyn Fn(&DeterministicAnswer) -> String| {
        let of = |p: &Point| p.answer.as_ref().map_or_else(|| otherwise.to_owned(), cell);
        columns.column(heading, points.iter().map(of));
        otherwise = "";
    };
    if question.loads.iter().any(|load| matches!(load, Load::MeanGap(_))) {
        // The load is an answer too.
        let load = |a: &DeterministicAnswer| a.budget.mean_pressure;
        add("±", &|a| text::relative(load(a).value, load(a).interval().ok(), text::pressure));
    }
    let area = |a: &DeterministicAnswer| a.budget.area;
    let mean = |a: &DeterministicAnswer| a.budget.real_pressure().map(|r| r.value);
    add("touching", &|a| text::percent(a.touching_fraction));
    add("area", &|a| text::percent(a.area_fraction));
    add("±", &|a| text::relative(area(a).value, area(a).interval().ok(), text::percent));
    add("± surface", &|a| text::relative(area(a).value, area(a).prediction(), text::percent));
    add("mean gap", &|a| text::or_dash(a.mean_gap, text::length));
    add("real pressure", &|a| text::or_dash(mean(a), text::pressure));
    add("highest", &|a| text::highest(a.diagnostics.max_pressure, mean(a)));
    add("convolutions", &|a| text::number(a.diagnostics.transforms));
    add("residual", &|a| format!("{:.1e}", a.diagnostics.residuals.preconditioned));
    add("time", &|a| text::seconds(a.diagnostics.seconds));
    if question.stiffness || asked.is_asked() {
        let shown = |k: Estimate| format!("{:.2e} Pa/m", k.value);
        add("stiffness", &|a| text::or_dash(a.budget.stiffness, shown));
    }
    if answer.hardness.is_some() {
        let yielded = |a: &DeterministicAnswer| a.diagnostics.yielded;
        add("area at H", &|a| text::or_dash(yielded(a), |y| text::percent(y.area_fraction)));
        add("load at H", &|a| text::or_dash(yielded(a), |y| text::percent(y.load_share)));
    }
    for (heading, of, unit) in conduction::columns(asked) {
        let cell = |p: &Point| Some(conduction::cell(of(p.conducted.as_ref()?), unit));
        columns.column(heading, points.iter().map(|p| cell(p).unwrap_or_default()));
    }
    columns
}

/// One line for each load on twice the points, and one for each reason without an uncertainty.
fn notes(points: &[Point]) -> String {
    let loads: Vec<Load> = points.iter().map(|point| point.load).collect();
    let mut notes = String::new();
    let mut missing: Vec<(String, Vec<String>)> = Vec::new();
    for index in rising(&loads) {
        let point = &points[index];
        let Some(answer) = point.answer.as_ref().filter(|a| a.converged) else { continue };
        let shown = shown(point.load);
        let uncertainty = answer.budget.area.half_width();
        if let Some(finer) = &answer.finer {
            let area = text::percent(finer.area);
            let both = if uncertainty.is_ok() { "; the ± covers both" } else { "" };
            let _ = writeln!(notes, "{shown}: twice the points read {area}{both}");
        }
        let Err(why) = uncertainty else { continue };
        let why = match (why, answer.mean_gap) {
            // The flat hangs above: by as much as it has approached less than nothing.
            (NoUncertainty::NoContact, Some(gap)) => {
                let first = text::length(gap + answer.approach);
                format!("{why}; first contact at a mean gap of {first}")
            }
            _ => why.to_string(),
        };
        match missing.iter_mut().find(|(known, _)| *known == why) {
            Some((_, loads)) => loads.push(shown),
            None => missing.push((why, vec![shown])),
        }
    }
    for (why, loads) in &missing {
        let _ = writeln!(notes, "no ± at {}: {why}", loads.join(", "));
    }
    notes
}

/// What is said of a contact that yields, below the table; `highest` is the largest mean pressure that was solved for (Pa).
fn yield_lines(given: Hardness, highest: f64) -> String {
    let mut out = format!("hardness {}", text::pressure(given.pascals));
    if let Some(ratio) = given.indices(None).modulus_gradient_over_hardness {
        let _ = write!(
            out,
            ": E* h′rms/H = {}; the area of elastic contact holds while that is below about 1",
            text::number(ratio)
        );
    }
    out.push('\n');
    out += &text::hardness_check(unusual_hardness(given).as_deref());
    if highest > BULK_YIELD * given.pascals {
        let _ = writeln!(
            out,
            "beyond {} of the hardness the body yields in its volume, which is not modelled",
            text::percent(BULK_YIELD)
        );
    }
    out + "one hardness at every scale; nothing hardens or piles up; loading only, no friction\n"
}
