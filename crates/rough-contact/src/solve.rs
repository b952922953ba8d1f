//! `rough-contact solve`: the deterministic solution.

use crate::adhesion::AdhesionOptions;
use crate::against::{self, Against};
use crate::args::{self, CommonOptions, SolverOptions};
use crate::batch::{self, PerFile};
use crate::bodies::BodyOptions;
use crate::cells::{cells, notes};
use crate::conduction::{self, ConductionOptions};
use crate::fields::{FieldFolder, FieldOptions};
use crate::files::folder_name;
use crate::hardness;
use crate::input::{Complete, InputFiles, MapOrTraces};
use crate::leak::{self, LeakOptions};
use crate::loads::{Loads, carried, shown};
use crate::outcome::{Failure, Reply};
use crate::profiles::{self, Traces};
use crate::progress::ProgressDisplay;
use crate::rows::{How, Shown};
use crate::text::{self, Columns};
use clap::Args;
use rough_contact::compare::{EdgesName, Joint, Level, PairOrigin, on_threads};
use rough_contact::contact_types::{Grid, HeightMap, Named};
use rough_contact::fft_bem_solver::{Boundary, Iteration, Load, Solution};
use rough_contact::front_end::{Point, SolveInput, SolveRequest, SolveResult, Watch};
use rough_contact::surface_stats::clean::Record;
use rough_contact::{front_end, report};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

#[derive(Args, Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "one for each flag of the command")]
pub(crate) struct Solve {
    #[command(flatten)]
    bodies: BodyOptions,
    #[command(flatten)]
    loads: Loads,
    /// Form to remove by least squares first
    #[arg(long, value_name = "FORM", value_parser = args::one_of::<Level>(), default_value = args::LEVEL)]
    level: Level,
    /// What lies beyond the edges: the same map again, or nothing
    #[arg(long, value_parser = ["periodic", "free"], default_value = "periodic")]
    boundary: String,
    #[command(flatten)]
    solver: SolverOptions,
    #[arg(long, hide = true, num_args = 0, default_missing_value = "", value_parser = args::refine_is_gone)]
    refine: Option<bool>,
    /// Prove how wrong each answer may be, for one more FFT convolution: energy_bound in the JSON
    #[arg(long)]
    certify: bool,
    /// Contact stiffness too, of the contact set of each load
    #[arg(long)]
    stiffness: bool,
    /// Highest pressure that the softer body bears, as 2GPa: metals yield there, and the area grows;
    /// `elastic` to leave out that of --material
    #[arg(long, value_name = "H", value_parser = args::hardness, allow_hyphen_values = true)]
    hardness: Option<f64>,
    #[command(flatten)]
    conduction: ConductionOptions,
    #[command(flatten)]
    leak: LeakOptions,
    #[command(flatten)]
    adhesion: AdhesionOptions,
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
    input: InputFiles,
}

/// What a profile is taken for.
const PLANE_STRAIN: &str = "plane strain: the trace is the cross-section of parallel ridges that are \
infinitely long and repeat with its length; a surface that is rough in both directions touches \
differently. Mean pressure is load per length of ridge over the length of the trace. If the two ends \
of the trace differ in height, --edges mirrored takes the jump between them out.\n";

/// Why heights and displacements are not written on a chosen grid.
const CHOSEN_GRID: &str = "--fields heights and displacement are on the grid of the file, and --accuracy and \
                           --fast choose a grid of their own; leave them out, or give --tolerance";

/// Why an isolated contact is not solved for its gap.
const FREE_GAP: &str = "--gap cannot be prescribed with --boundary free: the mean gap of an isolated \
                        contact depends on where one stops looking; give --pressure, or solve with \
                        --boundary periodic";

impl Solve {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        batch::run(self, &self.input.files, common)
    }
}

impl PerFile for Solve {
    const NAME: &'static str = "solve";
    const SHOWN: &'static [Shown] = &[
        Shown { head: "points", at: &["/shape"], how: How::Shape },
        Shown { head: "against", at: &["/pair/second/name"], how: How::Word },
        Shown { head: "load", at: &["/points/*/load"], how: How::Force },
        Shown { head: "mean pressure", at: &["/points/*/mean_pressure"], how: How::Pressure },
        Shown { head: "area", at: &["/points/*/area_fraction"], how: How::Percent },
        Shown { head: "mean gap", at: &["/points/*/mean_gap"], how: How::Length },
        Shown { head: "real pressure", at: &["/points/*/real_pressure"], how: How::Pressure },
        Shown { head: "time", at: &["/points/*/seconds"], how: How::Seconds },
        Shown { head: "to check", at: &["/findings"], how: How::Checks },
    ];

    /// Maps of several files are kept apart in folders with the names of the files.
    fn on(&self, file: &Path) -> Self {
        let only = self.input.files.only().is_some();
        let apart = |maps: &PathBuf| if only { maps.clone() } else { maps.join(folder_name(file)) };
        let maps = self.fields.maps.as_ref().map(apart);
        let fields = self.fields.to(maps);
        Self { input: self.input.on(file), fields, ..self.clone() }
    }

    fn beside(&self) -> String {
        self.against.content()
    }

    fn about(&self) -> String {
        self.bodies.required(self.hardness).map_or_else(
            |_| String::new(),
            |made_of| against::lines(None, Some((made_of.modulus.pascals(), made_of.bodies))),
        )
    }

    fn is_complete(&self, file: &Path) -> bool {
        let loads = self.loads.count().unwrap_or(0);
        let names = self.fields.names(loads);
        let all = |maps: &PathBuf| names.iter().all(|name| maps.join(name).exists());
        self.on(file).fields.maps.as_ref().is_none_or(all)
    }

    fn answer(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        let mut made_of = self.bodies.required(self.hardness)?;
        self.loads.forces.refuse_idle_area(self.conduction.is_asked())?;
        let area = self.loads.forces.area().filter(|_| self.conduction.is_asked());
        let conduction = self.conduction.asked(&mut made_of, area)?;
        let front_end::bodies::Bodies { modulus, bodies, hardness, materials } = made_of;
        let adhesion = self.adhesion.asked()?;
        let leak = self.leak.asked()?;
        let count = self.loads.count()?;
        let boundary = match self.boundary.as_str() {
            "free" if self.loads.is_by_gap() => {
                return Err(Failure::refused("combination", FREE_GAP));
            }
            "free" => Boundary::Free,
            _ => Boundary::Periodic,
        };
        args::refuse_mirrored(self.solver.edges, self.boundary == "free")?;
        let repeats = boundary == Boundary::Periodic && self.solver.edges == EdgesName::Periodic;
        if (self.solver.accuracy.is_some() || self.solver.fast) && self.fields.needs_heights() {
            return Err(Failure::refused("combination", CHOSEN_GRID));
        }
        let (complete, pair) = self.section()?;
        let maps = FieldFolder::prepare(&self.fields, count, repeats, common.force)?;
        let Complete { map, cleaned, missing, .. } = complete;
        let spread = self.loads.forces.spread([map.grid().area()])?;
        let question = SolveRequest {
            loads: self.loads.each(spread.as_ref()),
            spread,
            modulus,
            bodies,
            level: self.level,
            boundary,
            edges: self.solver.edges,
            plane_strain: self.plane_strain,
            method: self.solver.method,
            precision: self.solver.precision,
            tolerance: self.solver.tolerance,
            accuracy: self.solver.accuracy,
            fast: self.solver.fast,
            certify: self.certify,
            stiffness: self.stiffness,
            hardness,
            conduction,
            leak,
            adhesion,
            materials,
            distributions: self.distributions,
            keep_gap: self.fields.needs_gap(),
        };
        let subject = SolveInput {
            path: &self.input.file,
            map,
            missing,
            fill: self.input.reading.fill.name(),
            cleaned: &cleaned,
            pair: pair.as_ref(),
        };
        let progress = ProgressDisplay::new(common.quiet, question.loads.len());
        let mut terminal = Terminal { progress, maps, needs_heights: self.fields.needs_heights() };
        let answer = on_threads(common.threads(), || question.solve(subject, &mut terminal))?;
        drop(terminal);
        let notes = match answer.plan {
            None => notes(&answer.points),
            Some(_) => String::new(),
        };
        let plan = answer.plan.clone();
        let mut reply = self.reply(answer, &notes, &question, (&cleaned, pair.as_ref()));
        if let Some(reached) = plan {
            reply.text += &(report::plan_explanation(&reached) + "\n");
            let unmet = front_end::unmet("", &reached);
            reply.trouble = reply.trouble.into_iter().chain(unmet).reduce(Failure::and);
        }
        Ok(reply)
    }
}

/// Progress, and where the maps go.
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

    fn working_on(&mut self, load: Load) {
        self.progress.working_on(&shown(load));
    }

    fn iterated(&mut self, _: usize, load: Load, now: &Iteration<'_>) -> ControlFlow<()> {
        self.progress.iterating(|| text::iterating(&shown(load), now.number, now.residual));
        ControlFlow::Continue(())
    }

    fn keep(&mut self, index: usize, grid: Grid, solution: &mut Solution) -> Result<(), Failure> {
        self.maps.as_ref().map_or(Ok(()), |maps| maps.write(index, grid, solution))
    }

    fn done(&mut self, load: Load) {
        self.progress.step(&shown(load));
    }
}

impl Solve {
    /// Whether more than the solution is asked, which only maps answer.
    fn asks_set(&self) -> Result<bool, Failure> {
        let adhesion = self.adhesion.asked()?.is_some();
        let leak = self.leak.asked()?.is_some();
        Ok(self.stiffness || self.conduction.is_asked() || leak || adhesion)
    }

    /// The map, or the one trace that is to be solved in plane strain.
    fn section(&self) -> Result<(Complete, Option<PairOrigin>), Failure> {
        let path = &self.input.file;
        let refused = |message: &str| {
            Err(Failure::refused("profile", format!("{}: {message}", path.display())))
        };
        let (measured, pair) = if self.plane_strain {
            (self.input.measured()?, None)
        } else {
            self.against.measured(path, self.input.how(), self.level)?
        };
        match (measured, self.plane_strain) {
            (MapOrTraces::Map(complete), false) => Ok((complete, pair)),
            (MapOrTraces::Map(_), true) => refused(
                "this is a map, and --plane-strain is for a profile; leave it out, or cut out a row with \
                 --crop Y0,0,1,NX",
            ),
            (MapOrTraces::Traces(_), false) => refused(
                "this is a profile, and a surface has no deterministic answer from one line of it; give \
                 --plane-strain if it is the cross-section of long parallel ridges, or see `model` and \
                 `compare`, which take it for a line of an isotropic surface",
            ),
            (MapOrTraces::Traces(_), true) if self.against.given()?.is_some() => refused(
                "--against presses two maps on each other, and --plane-strain is for one profile; leave \
                 one of them out",
            ),
            (MapOrTraces::Traces(_), true) if self.loads.forces.given()?.is_some() => refused(
                "--load is a force on an area, and in plane strain a load is a force on a length of ridge; \
                 give --pressure",
            ),
            (MapOrTraces::Traces(_), true) if self.boundary == "free" => refused(
                "--boundary free is for a contact that ends in all directions; ridges in plane strain do \
                 not: leave it out",
            ),
            (MapOrTraces::Traces(_), true)
                if self.solver.accuracy.is_some() || self.solver.fast || self.asks_set()? =>
            {
                refused(
                    "--accuracy, --fast, --stiffness, --resistivity, --conductivity, --leak and \
                     --work-of-adhesion are for maps; give --tolerance with --plane-strain",
                )
            }
            (MapOrTraces::Traces(traces), true) => {
                let (map, traces) = profiles::only(traces, path)?;
                let Traces { missing, cleaned, height_step, format, crop, .. } = traces;
                Ok((Complete { map, missing, cleaned, height_step, format, crop }, None))
            }
        }
    }

    fn reply(
        &self,
        answer: SolveResult,
        notes: &str,
        question: &SolveRequest,
        (cleaned, pair): (&[Record], Option<&PairOrigin>),
    ) -> Reply {
        let spread = question.spread.as_ref();
        let mut headings = if spread.is_some() { vec!["load"] } else { Vec::new() };
        let joint = Joint { hardness: answer.hardness.map(|h| h.pascals), ..question.conduction };
        headings.extend(conduction::first_headings(&joint, true));
        headings.push("mean pressure");
        if self.loads.is_by_gap() {
            headings.push("±"); // the load is an answer too
        }
        headings.extend([
            "touching",
            "area",
            "±",
            "± surface",
            "mean gap",
            "real pressure",
            "highest",
            "convolutions",
            "residual",
            "time",
        ]);
        if self.stiffness || joint.is_asked() {
            headings.push("stiffness");
        }
        if answer.hardness.is_some() {
            headings.extend(hardness::HEADINGS);
        }
        headings.extend(conduction::headings(&joint));
        let mut columns = Columns::new(&headings);
        for point in &answer.points {
            let mut cells = cells(point, joint.hardness.is_some());
            if spread.is_some() {
                cells.insert(0, point.force.map_or_else(|| "–".to_owned(), text::force));
            }
            columns.row(cells);
        }
        let gap = |p: &Point| p.solution.as_ref()?.state.mean_gap;
        let gaps: Vec<f64> = answer.points.iter().filter_map(gap).collect();
        let solved = |p: &'_ Point| Some(p.solution.as_ref()?.state.mean_pressure);
        let leaks = answer.points.iter().filter_map(|p| Some((solved(p)?, p.leak.as_ref()?)));
        let (modulus, yields) = (question.modulus.pascals(), answer.hardness.is_some());
        let part = Joint { area: answer.json["nominal_area"].as_f64(), ..joint };
        let mut text = [
            text::cleaning(cleaned),
            text::findings(&answer.findings),
            columns.to_string(),
            leak::lines(question.leak.as_ref(), leaks, modulus, yields),
            spread.map_or_else(String::new, carried),
            against::lines(pair, Some((modulus, question.bodies.clone()))),
            text::level(self.level, answer.level),
            conduction::line(&part, &gaps),
            text::materials(&question.materials),
        ]
        .concat();
        if self.plane_strain {
            text += PLANE_STRAIN;
        }
        text += notes;
        if let Some(given) = answer.hardness {
            let highest = answer.points.iter().filter_map(solved).fold(0.0, f64::max);
            text += &hardness::lines(given, highest);
        }
        Reply { text, json: answer.json, trouble: answer.trouble }
    }
}
