//! `rough-contact model`: a closed-form model from a surface or from numbers.

use crate::against::{self, Against};
use crate::args::{self, List};
use crate::bodies::BodyOptions;
use crate::conduction::{self, ConductionOptions};
use crate::input::{FileOptions, One};
use crate::loads::{self, Spread};
use crate::outcome::{Failure, Reply};
use crate::profiles;
use crate::roughness::{Source, options_of, ways};
use crate::text::{self, Columns};
use crate::units::Dimension::{Force, Length, Pressure};
use clap::{ArgGroup, Args};
use multiscale_models::Persson;
use rough_contact::compare::survey::SIMILAR;
use rough_contact::compare::{Card, Conducted, Input, Inputs, Joint, PairOrigin, Theory, built_in};
use rough_contact::contact_types::{Citation, ContactModulus, Named};
use rough_contact::front_end::Subject;
use rough_contact::front_end::bodies::Bodies;
use rough_contact::front_end::model::{
    self, ModelLoads, ModelPoint, ModelReply, ModelSubject, Said,
};
use rough_contact::{compare, report};
use serde_json::json;
use std::fmt::Write as _;
use std::path::PathBuf;

#[derive(Args)]
#[command(group(ArgGroup::new("loads").required(true).args(["pressure", "load", "separation", "list"])))]
pub(crate) struct Model {
    /// Which model; --list describes them
    #[arg(value_name = "NAME", value_parser = args::models(), ignore_case = true)]
    #[arg(required_unless_present = "list")]
    name: Option<String>,
    /// Surface file to take the roughness from, instead of typing it in
    #[arg(value_name = "FILE")]
    file: Option<PathBuf>,
    /// Every model with citation, inputs and domain
    #[arg(long, conflicts_with_all = ["name", "file"])]
    list: bool,
    #[command(flatten)]
    bodies: BodyOptions,
    /// Nominal pressures to answer at
    #[arg(long, value_name = "LIST", value_parser = args::list(Pressure), allow_hyphen_values = true)]
    pressure: Option<List>,
    /// Loads to answer at, such as 10N, over the area of FILE or --area, instead of --pressure
    #[arg(long, value_name = "LIST", value_parser = args::list(Force), allow_hyphen_values = true)]
    load: Option<List>,
    /// Separations to answer at (flat to mean plane of the undeformed heights), instead of
    /// --pressure
    #[arg(long, value_name = "LIST", value_parser = args::list(Length), allow_hyphen_values = true)]
    separation: Option<List>,
    #[command(flatten)]
    source: Source,
    #[command(flatten)]
    conduction: ConductionOptions,
    #[command(flatten)]
    against: Against,
    #[command(flatten)]
    how: FileOptions,
}

impl Model {
    pub(crate) fn run(&self) -> Result<Reply, Failure> {
        let Some(name) = &self.name else { return Ok(list()) };
        let theory = compare::find(name).expect("clap accepts only these names");
        let card = theory.card();
        let hardness = self.source.one(Input::Hardness);
        let mut made_of = match self.bodies.given(hardness)? {
            None if card.is_rigid => {
                let (bodies, materials) = (Vec::new(), Vec::new());
                Bodies { modulus: ContactModulus::RIGID, bodies, hardness, materials }
            }
            Some(given) => given,
            None => self.bodies.required(hardness)?,
        };
        let joint = self.joint(card, &mut made_of)?;
        let area_has_use = self.load.is_some() || joint.is_asked();
        let (elastic, file) = (self.bodies.typed(), self.file.as_deref());
        self.source.refuse_unused(card, elastic, file, area_has_use)?;
        let (modulus, asked) = (made_of.modulus, self.source.file.level.unwrap_or_default());
        let (mut first, mut traces) = (String::new(), 0);
        let mut subject = if let Some(path) = &self.file {
            match self.against.measured(path, &self.how, asked, false)? {
                One::Map(surface) => {
                    let cleaned = surface.origin.cleaned().to_vec();
                    first += &text::cleaning(&cleaned);
                    let fill = self.how.reading.fill.name();
                    let map = Subject { path, surface: *surface, cleaned, fill };
                    ModelSubject::of_map(card, modulus, map, asked, self.source.file.boundary)?
                }
                One::Profile(profile) => {
                    first += &text::cleaning(profile.origin.cleaned());
                    first += &profiles::uneven_line(profile.uneven);
                    traces = profile.traces.len();
                    ModelSubject::of_traces(modulus, path, &profile, asked)?
                }
            }
        } else {
            self.how.cleaning.refuse_without_file()?;
            if self.against.given()?.is_some() {
                let message = "--against is for a second body on a surface FILE, and none is given; for \
                               moments typed in, add those of the two";
                return Err(Failure::refused("usage", message));
            }
            let hardness = made_of.hardness;
            ModelSubject::typed(self.source.typed(card, modulus, hardness, area_has_use)?)
        };
        let poisson = compare::poisson(&made_of.bodies);
        let inputs = self.source.beside_file(subject.inputs);
        subject.inputs = Inputs { hardness: made_of.hardness, poisson, ..inputs };
        // Of a load the area that carries it, which may be that of the map; traces have none.
        let of_map = subject.inputs.nominal_area.filter(|_| traces == 0);
        let (questions, spread) = self.questions(of_map)?;
        let inputs = format!("give {}", ways(card));
        let found = subject.ask(
            theory,
            &joint,
            &questions,
            spread.as_ref(),
            ["give --pressure", &inputs],
        )?;
        first += &text::findings(&found.findings);
        let text = first + &describe(card, &found, spread.as_ref());
        let told = found.points.iter().find_map(|point| point.answer.as_ref().err());
        let mut reply = Reply { text, trouble: told.map(model::failure), json: found.json };
        for point in &found.points {
            if let Some(ends) = point.interval {
                let [low, high] = ends.map(text::percent);
                let _ = writeln!(
                    reply.text,
                    "{}: 95 % interval of the area {low} to {high}, by the length of the {}",
                    text::or_dash(point.mean_pressure, text::pressure),
                    if traces == 1 { "trace" } else { "traces" }
                );
            }
        }
        if let (Some(level), Some(_)) = (found.level, found.inputs.moments) {
            reply.text += &text::level(asked, level);
            reply.text += text::MOMENTS;
        }
        add_bodies(&mut reply, made_of, found.pair.as_ref(), card.is_rigid);
        Ok(reply)
    }

    /// What is asked of the joint; of a theory of conductance always something.
    fn joint(&self, card: &Card, bodies: &mut Bodies) -> Result<Joint, Failure> {
        let area = self.source.one(Input::Area);
        if !card.takes(Input::MeanSlope) {
            return self.conduction.asked(bodies, area);
        }
        let joint = self.conduction.asked_of(bodies, area)?;
        if joint.is_asked() {
            return Ok(joint);
        }
        let message = format!(
            "{} says what a joint conducts; give --conductivity K[,K], --resistivity RHO[,RHO], or two of --material",
            card.name
        );
        Err(Failure::refused("missing_input", message))
    }

    /// What is asked, of a surface of this area if it is known.
    fn questions(&self, area: Option<f64>) -> Result<(ModelLoads, Option<Spread>), Failure> {
        if let Some(List(forces)) = &self.load {
            let spread = loads::spread(forces, self.source.one(Input::Area), area)?;
            return Ok((ModelLoads::Pressures(spread.pressures.clone()), Some(spread)));
        }
        let all = |list: &Option<List>| list.as_ref().map(|List(all)| all.clone());
        let separations = all(&self.separation).map(ModelLoads::Separations);
        let pressures = || ModelLoads::Pressures(all(&self.pressure).unwrap_or_default());
        Ok((separations.unwrap_or_else(pressures), None))
    }
}

fn add_bodies(reply: &mut Reply, made_of: Bodies, pair: Option<&PairOrigin>, is_rigid: bool) {
    let Bodies { modulus, bodies, materials, .. } = made_of;
    reply.json["bodies"] = report::bodies_json(pair, &bodies);
    reply.text += &against::lines(pair, (!is_rigid).then_some((modulus.pascals(), bodies)));
    reply.text += &text::materials(&materials);
    if !materials.is_empty() {
        reply.json["materials"] = report::materials_json(&materials);
    }
}

/// What the theory says of a point.
fn said(point: &ModelPoint) -> Option<&Said> {
    point.answer.as_ref().ok()
}

/// The table, and what must be known of it.
fn describe(card: &Card, found: &ModelReply, spread: Option<&Spread>) -> String {
    let ModelReply { points, inputs, joint, .. } = found;
    let any = |of: fn(&Said) -> bool| points.iter().filter_map(said).any(of);
    let mut columns = Columns::default();
    let mut add = |heading: &str, cell: &dyn Fn(&ModelPoint) -> String| {
        columns.column(heading, points.iter().map(cell));
    };
    if spread.is_some() {
        add("load", &|p| text::or_dash(p.force, text::force));
    }
    let fit = |p: &ModelPoint| said(p)?.conducted.map(|[fit, _]| fit);
    let exact = |p: &ModelPoint| said(p)?.conducted.map(|[_, exact]| exact);
    let first = conduction::first_headings(joint, joint.area.is_some());
    for (k, heading) in first.into_iter().enumerate() {
        add(heading, &|p| conduction::first_cell(fit(p).as_ref(), joint, k));
    }
    let (pressure, length) =
        (|x| text::or_dash(x, text::pressure), |x| text::or_dash(x, text::length));
    let area = |said: &Said| text::percent(said.state.area_fraction);
    add("mean pressure", &|p| pressure(p.mean_pressure));
    add("area", &|p| said(p).map_or_else(|| "refused".to_owned(), area));
    // A theory that knows its own error says it.
    if any(|said| said.area_interval.is_some()) {
        let ends = |[a, b]: [f64; 2]| format!("{} to {}", text::percent(a), text::percent(b));
        add("for 95 of 100", &|p| text::or_dash(said(p).and_then(|s| s.area_interval), ends));
    }
    add("real pressure", &|p| pressure(said(p).and_then(|s| s.state.real_pressure())));
    add("separation", &|p| length(p.separation));
    add("mean gap", &|p| length(said(p).and_then(|s| s.state.mean_gap)));
    let surveyed = any(|said| said.survey.is_some());
    if surveyed {
        let range = |([low, high], _): ([f64; 2], usize)| report::numbers::signed_range(low, high);
        add("error", &|p| text::or_dash(said(p).and_then(|s| s.survey), range));
    }
    for (heading, of, unit) in conduction::columns(joint) {
        add(heading, &|p| text::or_dash(fit(p), |fit| conduction::cell(of(&fit), unit)));
    }
    if any(|said| said.conducted.is_some_and(|[fit, exact]| fit != exact)) {
        let columns = conduction::columns(&Joint { gas: None, ..*joint });
        let cells = |exact: Conducted| {
            let cells = columns.iter().map(|(_, of, unit)| conduction::cell(of(&exact), unit));
            cells.collect::<Vec<_>>().join(", ")
        };
        add("exact", &|p| text::or_dash(exact(p), cells));
    }
    let mut notes: Vec<String> = Vec::new();
    // The first refusal is said on standard error.
    let told = points.iter().find_map(|point| point.answer.as_ref().err());
    for point in points {
        let note = match &point.answer {
            Ok(said) => said.state.caveat.as_ref().map(|caveat| format!("caution: {caveat}")),
            Err(error) if Some(error) == told => None,
            Err(error) => Some(format!("refused: {}", model::failure(error))),
        };
        notes.extend(note.filter(|note| !notes.contains(note)));
    }
    let mut text = format!("{} ({})\n{columns}", card.title, cited(&card.citation));
    if !card.formula.is_empty() {
        let _ = writeln!(text, "{}", card.formula);
    }
    if surveyed {
        let [bandwidth, load] = SIMILAR;
        let _ = writeln!(
            text,
            "error: of the area, on isotropic Gaussian surfaces with this bandwidth (within a factor {bandwidth}) \
             at this load (within {load}), against the solver; a map tells more"
        );
    }
    if let Some(gamma) = inputs.gamma().filter(|_| card.takes(Input::Gamma)) {
        let whose = [(1.0, " (Persson 2007)"), (Persson::GAMMA, " (Yang & Persson 2008)")];
        let whose = whose.iter().find(|(g, _)| (g - gamma).abs() < 1e-12).map_or("", |w| w.1);
        let _ = writeln!(text, "mean gap with γ = {}{whose}", text::number(gamma));
    }
    let gap = |p| said(p).and_then(|s| s.state.mean_gap.or(s.state.separation));
    let gaps: Vec<f64> = points.iter().filter_map(gap).collect();
    text += &conduction::line(joint, &gaps);
    for note in notes {
        let _ = writeln!(text, "{note}");
    }
    text + &spread.map_or_else(String::new, loads::carried)
}

fn cited(c: &Citation) -> String {
    if c.doi.is_empty() {
        format!("{} {}", c.authors, c.year)
    } else {
        format!("{} {}, doi:{}", c.authors, c.year, c.doi)
    }
}

fn list() -> Reply {
    let mut text = String::new();
    let mut models = Vec::new();
    for card in built_in().iter().map(Theory::card) {
        let c = &card.citation;
        let doi = if c.doi.is_empty() { String::new() } else { format!(" doi:{}", c.doi) };
        let options = options_of(card).join(", or ");
        let separation = if card.has_separation { "; --separation as well" } else { "" };
        let _ = writeln!(
            text,
            "{}: {}\n  {} ({}) {}. {}.{doi}\n  inputs: {}\n  domain: {}\n  options: {options}{separation}\n",
            card.name, card.title, c.authors, c.year, c.title, c.journal, card.needs, card.domain,
        );
        let mut object = model::described(card);
        object["options"] = json!(options_of(card));
        models.push(object);
    }
    Reply::new(text, json!({ "models": models }))
}
