//! `rough-contact stats`: roughness statistics, each with its unit.

use crate::against::{self, Against};
use crate::args::{self, CommonOptions};
use crate::batch::{self, How, PerFile, Shown};
use crate::bodies::BodyOptions;
use crate::contact::AdhesionOptions;
use crate::files::{Files, expand};
use crate::input::{FileOptions, One};
use crate::outcome::{Failure, Reply, unfit};
use crate::profiles;
use crate::text::{self, Columns, TwoColumns};
use clap::Args;
use rough_contact::compare::{Hardness, Level, WorkOfAdhesion, typical_hardness};
use rough_contact::contact_types::Named;
use rough_contact::front_end::bodies::Bodies;
use rough_contact::front_end::shown::unusual_hardness;
use rough_contact::front_end::{IsoParameter, StatisticsRequest, Subject};
use rough_contact::surface_stats::{ByDistance, Edges, STATISTICS, Statistic, SurfaceStatistics};
use rough_contact::{front_end, report};
use serde_json::{Value, json};
use std::path::Path;

#[derive(Args, Clone, Debug)]
pub(crate) struct Stats {
    /// Form to remove by least squares first
    #[arg(long, value_name = "FORM", value_parser = args::one_of::<Level>(), default_value = args::LEVEL)]
    level: Level,
    /// What lies beyond the edges: nothing, or the same map again
    #[arg(long, value_parser = args::one_of::<Edges>(), default_value = "open")]
    boundary: Edges,
    /// The areal parameters of ISO 25178-2 too: Sdr, Sal, Str, Std, the Sk family, volumes
    #[arg(long)]
    iso: bool,
    /// Slope, curvature and autocorrelation by the distance over which they are taken too
    #[arg(long)]
    scales: bool,
    /// Take the traces of all files for one sample of one surface: profiles of equal length and spacing
    #[arg(long, conflicts_with_all = ["out", "resume", "against", "iso", "scales", "modulus", "young", "material", "work_of_adhesion"])]
    pool: bool,
    #[command(flatten)]
    bodies: BodyOptions,
    /// Hardness of the softer body, as 2GPa, with a modulus: will the contact of these heights yield?
    #[arg(long, value_name = "H", value_parser = args::hardness, allow_hyphen_values = true)]
    #[arg(conflicts_with = "pool")]
    hardness: Option<f64>,
    #[command(flatten)]
    adhesion: AdhesionOptions,
    #[command(flatten)]
    against: Against,
    #[command(flatten)]
    files: Files,
    #[command(flatten)]
    how: FileOptions,
}

impl Stats {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        if self.pool { self.pooled() } else { batch::run(self, &self.files, common) }
    }

    fn pooled(&self) -> Result<Reply, Failure> {
        let mut files = expand(&self.files.paths)?.into_iter();
        let profile = |file: &Path| match self.how.measured(file, false)? {
            One::Profile(traces) => Ok(*traces),
            One::Map(_) => {
                let why =
                    "this is a map, and --pool is for the traces of profiles; leave --pool out";
                Err(unfit(file, "profile", why))
            }
        };
        let first = files.next().unwrap_or_default();
        let mut all = profile(&first)?;
        for file in files {
            profiles::add(&mut all, profile(&file)?, &first, &file)?;
        }
        profiles::statistics(&first, &all, self.level)
    }
}

impl PerFile for Stats {
    const NAME: &'static str = "stats";
    const SHOWN: &'static [Shown] = &[
        Shown { head: "points", at: &["/shape"], how: How::Shape },
        Shown { head: "against", at: &["/pair/second/name"], how: How::Word },
        Shown { head: "traces", at: &["/traces"], how: How::Count },
        Shown { head: "pixel", at: &["/pixel/1", "/spacing"], how: How::Length },
        Shown { head: "Sq, Pq", at: &["/rms_height", "/primary/Pq/mean"], how: How::Length },
        Shown { head: "skewness", at: &["/skewness"], how: How::Number },
        Shown { head: "kurtosis", at: &["/kurtosis"], how: How::Number },
        Shown { head: "rms gradient", at: &["/rms_gradient"], how: How::Number },
        Shown { head: "H", at: &["/hurst"], how: How::Number },
        Shown { head: "filled", at: &["/missing"], how: How::Count },
        Shown { head: "to check", at: &["/findings"], how: How::Checks },
    ];

    fn beside(&self) -> String {
        self.against.content()
    }

    fn answer(&self, path: &Path, _: &CommonOptions) -> Result<Reply, Failure> {
        let asked = self.bodies()?; // refused before any work
        let surface = match self.against.measured(path, &self.how, self.level, false)? {
            One::Map(surface) => *surface,
            One::Profile(_) if asked.is_some() => {
                let message = "modulus and hardness are for maps; of a profile leave them out";
                return Err(Failure::refused("profile", message));
            }
            One::Profile(traces) => return profiles::statistics(path, &traces, self.level),
        };
        let sticking = |(made_of, given): &(Bodies, Option<_>)| Some(((*given)?, made_of.modulus));
        let request = StatisticsRequest {
            level: self.level,
            boundary: Some(self.boundary),
            fractal_range: None,
            iso: self.iso,
            scales: self.scales,
            adhesion: asked.as_ref().and_then(sticking),
        };
        let cleaned = surface.origin.cleaned().to_vec();
        let subject = Subject { path, surface, cleaned, fill: self.how.reading.fill.name() };
        let found = front_end::statistics(&subject, &request)?;
        let mut text = text::cleaning(&subject.cleaned)
            + &found.findings.iter().map(text::finding_line).collect::<String>()
            + &self.describe(&found.statistics);
        text += &against::lines(subject.surface.origin.pair(), None);
        if let Some(iso) = &found.iso {
            text = format!("{text}\nISO 25178-2\n{}", areal(iso));
        }
        if let Some([along_x, along_y]) = &found.scales {
            text = format!("{text}\nalong x\n{}\nalong y\n{}", scales(along_x), scales(along_y));
        }
        let mut json = found.json;
        if let Some((made_of, _)) = asked {
            let modulus = made_of.modulus.pascals();
            let (said, object) = forecast(modulus, made_of.hardness, &found.statistics);
            text += &(said + &text::materials(&made_of.materials));
            json["plasticity"] = object;
            if !made_of.materials.is_empty() {
                json["materials"] = report::materials_json(&made_of.materials);
            }
        }
        Ok(Reply::new(text, json))
    }
}

/// Parameters of ISO 25178-2 that are not shown before.
fn areal(iso: &[IsoParameter]) -> TwoColumns {
    let is_new = |p: &&IsoParameter| STATISTICS.iter().all(|field| field.symbol != p.symbol);
    let mut t = TwoColumns::default();
    for p in iso.iter().filter(is_new) {
        t.row(p.symbol.replace('_', " "), text::or_dash(p.value, |value| with_unit(value, p.unit)));
    }
    t
}

fn scales(list: &[ByDistance]) -> Columns {
    let mut columns = Columns::new(&["distance", "rms slope", "rms curvature", "autocorrelation"]);
    for d in list {
        columns.row([
            text::length(d.distance),
            text::number(d.slope),
            text::or_dash(d.curvature, |c| format!("{c:.3e} 1/m")),
            text::or_dash(d.autocorrelation, text::number),
        ]);
    }
    columns
}

impl Stats {
    /// The bodies and their work of adhesion, if anything was given of them.
    fn bodies(&self) -> Result<Option<(Bodies, Option<WorkOfAdhesion>)>, Failure> {
        let adhesion = self.adhesion.asked()?;
        let is_asked = self.hardness.is_some() || adhesion.is_some();
        let made_of = match self.bodies.given(self.hardness)? {
            None if !is_asked => return Ok(None),
            None => self.bodies.required(self.hardness)?,
            Some(made_of) => made_of,
        };
        Ok(Some((made_of, adhesion)))
    }

    fn describe(&self, s: &SurfaceStatistics) -> String {
        let [ny, nx] = s.shape;
        let [dy, dx] = s.pixel;
        let mut t = TwoColumns::default();
        t.row("points", format!("{ny} rows × {nx} columns, {} filled in", s.missing));
        t.row("pixel", format!("{} × {} (dy × dx)", text::length(dy), text::length(dx)));
        t.row("level, edges", format!("{}, {}", s.level.name(), self.boundary.name()));
        for fields in STATISTICS.chunk_by(|a, b| a.name == b.name) {
            let joined = |one: &dyn Fn(&Statistic) -> String| {
                fields.iter().map(one).collect::<Vec<_>>().join(", ")
            };
            let name = format!("{} {}", fields[0].name, joined(&|f| f.symbol.to_owned()));
            let value = |f: &Statistic| text::or_dash(f.of(s), |value| with_unit(value, f.unit));
            t.row(name.trim_end(), joined(&value));
        }
        t.asperities(s.asperities);
        if let Some(a) = s.asperities {
            t.row("asperity mean offset", text::length(a.mean_offset));
        }
        let summits = format!("{}, {:.4e} m⁻²", s.summits.count, s.summits.density);
        t.row("summits counted", summits);
        t.to_string()
    }
}

/// A number in its SI unit.
fn with_unit(value: f64, unit: &str) -> String {
    match unit {
        "" => text::number(value),
        "m" => text::length(value),
        "m³/m²" => format!("{} (m³ per m²)", text::length(value)),
        "%" => text::percent(value),
        "°" => format!("{}° from x", text::digits(value)),
        unit => format!("{value:.4e} {unit}"),
    }
}

/// Whether the contact of heights with these statistics will yield: text and object. Nothing is solved for.
fn forecast(modulus: f64, hardness: Option<f64>, s: &SurfaceStatistics) -> (String, Value) {
    let limit = modulus * s.rms_gradient;
    let yields = typical_hardness(modulus).is_some();
    let mut object = json!({
        "modulus": modulus,
        "hardness": hardness,
        "elastic_limit": (yields && limit > 0.0).then_some(limit),
    });
    let Some(pascals) = hardness else {
        let text = if yields {
            format!(
                "E* h′rms = {}: for a hardness of that or more the area of elastic contact is right to 2 %\n",
                text::pressure(limit)
            )
        } else {
            "solids of this contact modulus do not yield in a contact\n".to_owned()
        };
        return (text, object);
    };
    let given = Hardness { pascals, modulus, gradient: Some(s.rms_gradient) };
    let found = given.indices(s.asperities);
    object["modulus_gradient_over_hardness"] = json!(found.modulus_gradient_over_hardness);
    object["greenwood_williamson"] = json!(found.greenwood_williamson);
    object["mikic"] = json!(found.mikic);
    let warning = unusual_hardness(given);
    object["warning"] = json!(warning);
    let number = |value: Option<f64>| text::or_dash(value, text::number);
    let verdict = if found.modulus_gradient_over_hardness.is_some_and(|r| r <= 1.0) {
        "the area of elastic contact is right to 2 % at any load"
    } else {
        "the contact yields: solve and compare take --hardness"
    };
    let mut lines = format!(
        "E* h′rms/H = {}: {verdict}\nplasticity indices: Greenwood–Williamson {} (summits elastic below 0.6, plastic above 1: \
         1966), Mikic {} (E* m/H, = E* h′rms/H over √π)\n",
        number(found.modulus_gradient_over_hardness),
        number(found.greenwood_williamson),
        number(found.mikic)
    );
    lines += &text::hardness_check(warning.as_deref());
    (lines, object)
}
