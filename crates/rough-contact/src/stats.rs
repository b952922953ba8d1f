//! `rough-contact stats`: roughness statistics, each with its unit.

use crate::adhesion::Adhesion;
use crate::against::{self, Against};
use crate::args::{self, Bodies, Common};
use crate::batch::{self, PerFile};
use crate::files::expand;
use crate::hardness;
use crate::input::{Complete, Input, Measured};
use crate::iso;
use crate::outcome::{Failure, Reply};
use crate::roughness::Edges;
use crate::rows::{How, Shown};
use crate::text::{self, Columns, Table};
use crate::{profile_stats, profiles};
use clap::Args;
use rough_contact::compare::{Level, WorkOfAdhesion};
use rough_contact::contact_types::Named;
use rough_contact::surface_stats::{ByDistance, StatsOptions, SurfaceStatistics};
use rough_contact::{front_end, report};
use std::path::Path;

#[derive(Args, Clone, Debug)]
pub(crate) struct Stats {
    /// Form to remove by least squares first
    #[arg(long, value_name = "FORM", value_parser = args::level(), default_value = args::LEVEL)]
    level: Level,
    /// What lies beyond the edges: nothing, or the same map again
    #[arg(long, value_enum, default_value_t = Edges::Open)]
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
    bodies: Bodies,
    /// Hardness of the softer body, as 2GPa, with a modulus: will the contact of these heights yield?
    #[arg(long, value_name = "H", value_parser = args::hardness, allow_hyphen_values = true)]
    #[arg(conflicts_with = "pool")]
    hardness: Option<f64>,
    #[command(flatten)]
    adhesion: Adhesion,
    #[command(flatten)]
    against: Against,
    #[command(flatten)]
    input: Input,
}

/// What the heights are asked of the bodies.
struct Asked {
    made_of: front_end::bodies::Bodies,
    adhesion: Option<WorkOfAdhesion>,
}

impl Stats {
    pub(crate) fn run(&self, common: &Common) -> Result<Reply, Failure> {
        if self.pool { self.pooled() } else { batch::run(self, &self.input.files, common) }
    }

    /// All files as one sample.
    fn pooled(&self) -> Result<Reply, Failure> {
        let mut files = expand(&self.input.files.paths)?.into_iter();
        let profile = |file: &Path| match self.input.on(file).measured()? {
            Measured::Profile(traces) => Ok(traces),
            Measured::Surface(_) => {
                let message = format!(
                    "{}: this is a map, and --pool is for the traces of profiles; leave --pool out",
                    file.display()
                );
                Err(Failure::refused("profile", message))
            }
        };
        let first = files.next().unwrap_or_default();
        let mut all = profile(&first)?;
        for file in files {
            profiles::add(&mut all, profile(&file)?, &first, &file)?;
        }
        profile_stats::run(&first, &all, self.level.degree().unwrap_or(0))
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

    fn on(&self, file: &Path) -> Self {
        Self { input: self.input.on(file), ..self.clone() }
    }

    fn beside(&self) -> String {
        self.against.content()
    }

    fn answer(&self, _: &Common) -> Result<Reply, Failure> {
        let asked = self.asked()?; // refused before any work
        let (complete, pair) = if self.against.given()?.is_some() {
            let pair = self.against.complete(&self.input.file, self.input.how(), self.level)?;
            (pair.0, Some(pair.1))
        } else {
            match self.input.measured()? {
                Measured::Surface(complete) => (complete, None),
                Measured::Profile(_) if asked.is_some() => {
                    let message = "modulus and hardness are for maps; of a profile leave them out";
                    return Err(Failure::refused("profile", message));
                }
                Measured::Profile(traces) => {
                    let degree = self.level.degree().unwrap_or(0);
                    return profile_stats::run(&self.input.file, &traces, degree);
                }
            }
        };
        let Complete { map, missing, cleaned, height_step, .. } = complete;
        let options = StatsOptions::default()
            .with_level(self.level)
            .with_edges(self.boundary.rule())
            .with_missing(missing)
            .with_height_step(height_step);
        let subject =
            front_end::Measured { path: &self.input.file, cleaned: &cleaned, pair: pair.as_ref() };
        let mut found = front_end::statistics(&map, &options, subject, self.iso, self.scales)?;
        if let Some(Asked { made_of, adhesion: Some(given) }) = &asked {
            found.stick(*given, &map, self.level, made_of.modulus, &self.input.file)?;
        }
        let mut text = text::cleaning(&cleaned)
            + &text::all_findings(&found.findings)
            + &self.describe(&found.statistics);
        text += &against::lines(pair.as_ref(), None);
        if let Some(iso) = &found.iso {
            text = format!("{text}\nISO 25178-2\n{}", iso::describe(iso));
        }
        if let Some([along_x, along_y]) = &found.scales {
            text = format!("{text}\nalong x\n{}\nalong y\n{}", scales(along_x), scales(along_y));
        }
        let mut json = found.json;
        if let Some(Asked { made_of, .. }) = asked {
            let modulus = made_of.modulus.pascals();
            let (said, object) = hardness::forecast(modulus, made_of.hardness, &found.statistics);
            text += &(said + &text::materials(&made_of.materials));
            json["plasticity"] = object;
            if !made_of.materials.is_empty() {
                json["materials"] = report::materials_json(&made_of.materials);
            }
        }
        Ok(Reply::new(text, json))
    }
}

/// A line for each distance.
fn scales(list: &[ByDistance]) -> Columns {
    let mut columns = Columns::new(&["distance", "rms slope", "rms curvature", "autocorrelation"]);
    let dash = || "–".to_owned();
    for d in list {
        columns.row([
            text::length(d.distance),
            text::number(d.slope),
            d.curvature.map_or_else(dash, |c| format!("{c:.3e} 1/m")),
            d.autocorrelation.map_or_else(dash, text::number),
        ]);
    }
    columns
}

impl Stats {
    /// The bodies, if anything was given of them.
    fn asked(&self) -> Result<Option<Asked>, Failure> {
        let adhesion = self.adhesion.asked()?;
        let is_asked = self.hardness.is_some() || adhesion.is_some();
        let made_of = match self.bodies.given(self.hardness)? {
            None if !is_asked => return Ok(None),
            None => self.bodies.required(self.hardness)?,
            Some(made_of) => made_of,
        };
        Ok(Some(Asked { made_of, adhesion }))
    }

    fn describe(&self, s: &SurfaceStatistics) -> String {
        let absent = || "–".to_owned();
        let length = |x: Option<f64>| x.map_or_else(absent, text::length);
        let number = |x: Option<f64>| x.map_or_else(absent, text::number);
        let [ny, nx] = s.shape;
        let [dy, dx] = s.pixel;
        let mut t = Table::default();
        t.row("points", format!("{ny} rows × {nx} columns, {} filled in", s.missing));
        t.row("pixel", format!("{} × {} (dy × dx)", text::length(dy), text::length(dx)));
        t.row("level, edges", format!("{}, {}", s.level.name(), self.boundary.name()));
        t.row("rms height Sq", text::length(s.rms_height));
        t.row("mean abs height Sa", text::length(s.mean_abs_height));
        t.row("skewness Ssk", number(s.skewness));
        t.row("kurtosis Sku", number(s.kurtosis));
        t.row("rms gradient Sdq", text::number(s.rms_gradient));
        t.row("m0", format!("{:.4e} m²", s.m0));
        t.row("m2", format!("{:.4e} (x {:.4e}, y {:.4e})", s.m2, s.m2_x, s.m2_y));
        t.row("m4", format!("{:.4e} m⁻² (x {:.4e}, y {:.4e})", s.m4, s.m4_x, s.m4_y));
        let spectral =
            format!("{:.4e} m², {:.4e}, {:.4e} m⁻²", s.m0_spectral, s.m2_spectral, s.m4_spectral);
        t.row("m0, m2, m4 spectral", spectral);
        t.row("bandwidth m0 m4/m2²", number(s.bandwidth));
        if let Some(a) = s.asperities {
            t.row("asperity density", format!("{:.4e} m⁻²", a.density));
            t.row("asperity radius", text::length(a.radius));
            t.row("asperity height std", text::length(a.height_std));
            t.row("asperity mean offset", text::length(a.mean_offset));
        }
        let summits = format!("{}, {:.4e} m⁻²", s.summits.count, s.summits.density);
        t.row("summits counted", summits);
        t.row("Hurst exponent H", number(s.hurst));
        t.row("profile dimension D", number(s.dimension));
        t.row("fractal roughness G", length(s.roughness));
        t.row("roll-off, cut-off", format!("{}, {}", length(s.rolloff), length(s.cutoff)));
        let ratio = text::number(s.max_amplitude_ratio);
        t.row("B_max", format!("{ratio} on records of {}", text::length(s.record_length)));
        t.to_string()
    }
}
