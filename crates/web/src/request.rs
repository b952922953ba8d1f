//! What the page asks: the fields as people filled them in, numbers with their units as text.

use crate::pace::Pace;
use crate::place::Host;
use contact_compare::{Cleaning, EdgesName, FileOrigin, Level, SPIKE_THRESHOLD, STEEL, Settings};
use contact_front_end::Failure;
use contact_front_end::bodies::{Bodies, BodyInput, BothBodies};
use contact_front_end::loads::{Spread, positive};
use contact_front_end::quantity;
use contact_front_end::units::Dimension;
use serde::Deserialize;
use surface_io::{Cut, ReadOptions};
use surface_stats::clean::Form;

/// Everything that an answer depends on, besides the bytes of the file.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Request {
    /// Name of the file.
    pub(crate) name: String,
    /// Name of a built-in surface, instead of a file.
    pub(crate) example: Option<String>,
    pub(crate) reading: FileFields,
    pub(crate) remedies: Remedies,
    /// The two bodies; empty: steel on steel.
    pub(crate) bodies: Vec<BodyFields>,
    /// Hardness of the softer body; empty: that of the materials, if they have one; `elastic`: bodies that do not yield.
    pub(crate) hardness: String,
    /// Electrical resistivity of the two bodies; both empty: not asked for.
    pub(crate) resistivities: [String; 2],
    pub(crate) load: LoadFields,
    /// For a plan: rms gradient of the map, its points and its area (m²).
    pub(crate) facts: Option<Facts>,
    /// For a plan: how fast an earlier one found this place; `None`: that is found out.
    pub(crate) pace: Option<Pace>,
    /// For the meaning of units: the numbers as they stand in the file.
    pub(crate) raw: Option<Raw>,
    /// For areas: the remedies to look at.
    pub(crate) defects: Vec<String>,
    /// Where it is answered; no page says that.
    #[serde(skip)]
    pub(crate) place: Host,
}

/// A map without units.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Raw {
    pub(crate) shape: [usize; 2],
    pub(crate) pixel: [f64; 2],
    pub(crate) range: f64,
    pub(crate) gradient: f64,
}

/// What is said of a file that does not say it.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct FileFields {
    pub(crate) channel: Option<String>,
    pub(crate) pixel: Option<String>,
    pub(crate) lateral_unit: Option<String>,
    pub(crate) height_unit: Option<String>,
    pub(crate) override_height_unit: Option<String>,
    pub(crate) layout: Option<String>,
    pub(crate) decimal: Option<String>,
    /// What stands where a point is missing.
    pub(crate) missing: Vec<String>,
    /// The part that is cut out, as the command takes it; `None` for the whole map.
    pub(crate) part: Option<String>,
}

#[derive(Debug, Clone, Deserialize, PartialEq)]
#[serde(default, deny_unknown_fields)]
#[allow(clippy::struct_excessive_bools, reason = "each is a box to tick")]
pub(crate) struct Remedies {
    pub(crate) rows: bool,
    pub(crate) spikes: bool,
    pub(crate) plane: bool,
    pub(crate) dome: bool,
    pub(crate) mirror: bool,
    /// `harmonic` or `nearest`, for missing points.
    pub(crate) fill: String,
}

impl Default for Remedies {
    fn default() -> Self {
        let (rows, spikes, plane, dome, mirror) = (false, true, true, false, false);
        Self { rows, spikes, plane, dome, mirror, fill: "harmonic".to_owned() }
    }
}

/// One body as it was filled in.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct BodyFields {
    /// Name in the table of materials; empty: own values.
    pub(crate) material: String,
    /// Young's modulus, such as `210 GPa`; `∞` for a rigid body.
    pub(crate) young: String,
    pub(crate) poisson: String,
}

/// Loads as they were filled in.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct LoadFields {
    pub(crate) by: LoadBy,
    /// Pressures or forces, as the command takes them.
    pub(crate) list: String,
    /// Nominal area that forces press on; empty: that of the map.
    pub(crate) area: String,
}

/// How loads are given.
#[derive(Debug, Clone, Copy, Default, Deserialize, PartialEq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum LoadBy {
    /// Chosen from the surface.
    #[default]
    Auto,
    Pressure,
    Force,
}

/// What a plan has to know of a map that was read before.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Facts {
    pub(crate) gradient: f64,
    pub(crate) points: f64,
    pub(crate) area: f64,
}

/// A number as people type it: with a point or a comma.
pub(crate) fn parse(text: &str, dimension: Dimension) -> Result<f64, Failure> {
    quantity::parse(&text.trim().replace(',', "."), dimension)
}

/// The same of a field that may be empty.
fn parse_some(text: &str, dimension: Dimension) -> Result<Option<f64>, Failure> {
    if text.trim().is_empty() { Ok(None) } else { parse(text, dimension).map(Some) }
}

fn own(young: f64, poisson: f64) -> BodyInput {
    BodyInput { young: Some(young), poisson: Some(poisson), ..BodyInput::default() }
}

impl BodyFields {
    fn given(&self) -> Result<BodyInput, Failure> {
        if !self.material.is_empty() {
            return Ok(BodyInput { material: Some(self.material.clone()), ..BodyInput::default() });
        }
        Ok(own(parse(&self.young, Dimension::Pressure)?, parse(&self.poisson, Dimension::Number)?))
    }
}

impl FileFields {
    pub(crate) fn part(&self) -> Result<Option<Cut>, Failure> {
        let refused = |message| Failure::refused("crop", message);
        self.part.as_deref().map(str::parse).transpose().map_err(refused)
    }
}

pub(crate) fn unit(text: Option<&str>) -> Result<Option<f64>, Failure> {
    text.map(quantity::parse_length_unit).transpose()
}

impl Remedies {
    /// The box of a remedy; the rules for missing points have none.
    fn tick(&mut self, key: &str) -> Option<&mut bool> {
        match key {
            "spikes" => Some(&mut self.spikes),
            "plane" => Some(&mut self.plane),
            "dome" => Some(&mut self.dome),
            "rows" => Some(&mut self.rows),
            "mirror" => Some(&mut self.mirror),
            _ => None,
        }
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.clone().tick(key).is_some_and(|on| *on)
    }

    /// Ticks one, or takes the tick off; of the two rules for missing points `true` is the one that is chosen.
    pub(crate) fn set(&mut self, key: &str, on: bool) {
        if let Some(tick) = self.tick(key) {
            *tick = on;
        } else if key == "fill" && !on {
            let other = if self.fill == "nearest" { "harmonic" } else { "nearest" };
            other.clone_into(&mut self.fill);
        }
    }

    pub(crate) fn cleaning(&self) -> Cleaning {
        Cleaning {
            align_rows: self.rows,
            outliers: self.spikes.then_some(SPIKE_THRESHOLD),
            form: self.dome.then_some(Form::Polynomial(2)),
            ..Cleaning::default()
        }
    }

    pub(crate) fn level(&self) -> Level {
        if self.plane { Level::Auto } else { Level::Mean }
    }
}

impl Request {
    /// What is said of the file, as a run that repeats it has it.
    pub(crate) fn origin(&self) -> Result<FileOrigin, Failure> {
        let reading = &self.reading;
        let pixel = reading.pixel.as_deref().map(|text| parse(text, Dimension::Length));
        Ok(FileOrigin {
            path: self.name.clone(),
            channel: reading.channel.clone(),
            pixel: pixel.transpose()?.map(|metres| [metres; 2]),
            lateral_unit: unit(reading.lateral_unit.as_deref())?,
            height_unit: unit(reading.height_unit.as_deref())?,
            override_height_unit: unit(reading.override_height_unit.as_deref())?,
            layout: reading.layout.clone(),
            decimal: reading.decimal.clone(),
            missing_marks: reading.missing.clone(),
            fill: self.remedies.fill.clone(),
            cleaning: self.remedies.cleaning(),
            ..FileOrigin::default()
        })
    }

    pub(crate) fn options(&self) -> Result<ReadOptions, Failure> {
        let (options, _) = contact_front_end::reading(&self.origin()?)?;
        Ok(ReadOptions { limits: self.place.limits(), ..options })
    }

    /// The two bodies in numbers; steel on steel if nothing was filled in.
    fn made_of(&self) -> Result<Bodies, Failure> {
        let hardness = self.hardness.trim();
        let elastic = hardness.eq_ignore_ascii_case("elastic");
        let deforms = |body: &&BodyFields| !body.young.trim_start().starts_with('∞');
        let bodies = if self.bodies.is_empty() {
            vec![own(STEEL.young, STEEL.poisson); 2]
        } else {
            let deforming = self.bodies.iter().filter(deforms);
            deforming.map(BodyFields::given).collect::<Result<_, _>>()?
        };
        let given = BothBodies {
            bodies,
            hardness: if elastic { None } else { parse_some(hardness, Dimension::Pressure)? },
            elastic,
            ..BothBodies::default()
        };
        given.resolve()?.ok_or_else(|| {
            let message = "Two rigid bodies do not deform: give one of them a modulus.";
            Failure::refused("material", message)
        })
    }

    /// Settings of the study on a map of this area (m²).
    pub(crate) fn settings(&self, of_map: f64) -> Result<Settings, Failure> {
        let Bodies { modulus, bodies, hardness, materials } = self.made_of()?;
        let list = |dimension| quantity::parse_list(&self.load.list, dimension);
        let (pressures, load_area) = match self.load.by {
            LoadBy::Auto => (None, None),
            LoadBy::Pressure => (Some(list(Dimension::Pressure)?), None),
            LoadBy::Force => {
                let area = parse_some(&self.load.area, Dimension::Area)?;
                let check = "look at the force and the area";
                let spread = Spread::of(&list(Dimension::Force)?, area, of_map, check)?;
                (Some(spread.pressures), Some(spread.area))
            }
        };
        positive("pressure", pressures.as_deref().unwrap_or_default(), "Pa", "that presses")?;
        let resistivities = match &self.resistivities {
            both if both.iter().all(|t| t.trim().is_empty()) => None,
            [one, two] => {
                Some([parse(one, Dimension::Resistivity)?, parse(two, Dimension::Resistivity)?])
            }
        };
        Ok(Settings {
            modulus: modulus.pascals(),
            bodies,
            materials,
            hardness,
            resistivities,
            pressures,
            load_area,
            level: self.remedies.level(),
            edges: if self.remedies.mirror { EdgesName::Mirrored } else { EdgesName::Periodic },
            threads: self.place.threads,
            ..Settings::default()
        })
    }
}
