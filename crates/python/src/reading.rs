//! What is said of a file before it is read, and why it may give no surface.

use crate::failure::raise;
use answers::{Complete, Failure, Incomplete};
use compare::{Cleaning, FileOrigin, Origin};
use pyo3::PyErr;
use pyo3::exceptions::PyOSError;
use serde::{Deserialize, Serialize};
use std::path::Path;
use surface_io::{
    Cut, DecimalMark, Fill, FillError, HeightUnit, Layout, Measurement, ReadError, ReadOptions,
};
use surface_stats::clean::Record;

/// What is said of a file.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Reading {
    pub(crate) channel: Option<String>,
    pub(crate) pixel: Option<[f64; 2]>,
    pub(crate) lateral_unit: Option<f64>,
    pub(crate) height_unit: Option<f64>,
    pub(crate) override_height_unit: Option<f64>,
    pub(crate) layout: Option<String>,
    pub(crate) decimal: Option<String>,
    pub(crate) missing: Vec<String>,
    /// As the command takes it.
    pub(crate) crop: Option<String>,
    pub(crate) fill: String,
    pub(crate) cleaning: Cleaning,
    /// No file, but an array, which is not cropped.
    #[serde(skip)]
    pub(crate) is_array: bool,
    /// What the file holds, where it is in memory.
    #[serde(skip)]
    pub(crate) content: Option<Vec<u8>>,
}

impl Reading {
    /// How a file was read.
    pub(crate) fn again(file: &FileOrigin) -> Self {
        Self {
            channel: file.channel.clone(),
            pixel: file.pixel,
            lateral_unit: file.lateral_unit,
            height_unit: file.height_unit,
            override_height_unit: file.override_height_unit,
            layout: file.layout.clone(),
            decimal: file.decimal.clone(),
            missing: file.missing_marks.clone(),
            crop: file.crop.map(|part| Cut::Rectangle(part).to_string()),
            fill: file.fill.clone(),
            cleaning: file.cleaning,
            is_array: false,
            content: None,
        }
    }

    pub(crate) fn options(&self) -> Result<ReadOptions, Failure> {
        let mut options = ReadOptions::default();
        options.channel.clone_from(&self.channel);
        options.pixel = self.pixel;
        options.lateral_unit = self.lateral_unit;
        options.height_unit = match self.override_height_unit {
            Some(metres) => Some(HeightUnit::Always(metres)),
            None => self.height_unit.map(HeightUnit::IfSilent),
        };
        if let Some(name) = &self.layout {
            let unknown = || Failure::refused("setting", format!("layout {name:?} is none"));
            options.layout = Some(Layout::of_name(name).ok_or_else(unknown)?);
        }
        if let Some(name) = &self.decimal {
            let unknown = || Failure::refused("setting", format!("decimal {name:?} is none"));
            options.decimal = Some(DecimalMark::of_name(name).ok_or_else(unknown)?);
        }
        options.missing.clone_from(&self.missing);
        Ok(options)
    }

    /// Every trace of a file of several; one measurement of any other file.
    pub(crate) fn measurements(&self, path: &Path) -> Result<Vec<Measurement>, Unread> {
        let options = self.options()?;
        let all = match &self.content {
            Some(bytes) => surface_io::read_traces_bytes(bytes, &options),
            None => surface_io::read_traces(path, &options),
        };
        let all = all.map_err(Unread::File)?;
        all.into_iter().map(|m| self.part(m)).collect()
    }

    /// The name of the rule for missing points.
    pub(crate) fn rule_name(&self) -> String {
        if self.fill.is_empty() { "refuse".to_owned() } else { self.fill.clone() }
    }

    /// Where heights came from that were read so; what is known of them is how many points were filled, what cleaning
    /// did, and the step of the heights as measured.
    pub(crate) fn origin(
        &self,
        path: &str,
        format: String,
        crop: Option<[usize; 4]>,
        (missing, cleaned, height_step): (usize, &[Record], Option<f64>),
    ) -> Origin {
        Origin::File(FileOrigin {
            path: path.to_owned(),
            // Made when a run file needs it: most surfaces never do.
            sha256: String::new(),
            format,
            channel: self.channel.clone(),
            pixel: self.pixel,
            lateral_unit: self.lateral_unit,
            height_unit: self.height_unit,
            override_height_unit: self.override_height_unit,
            layout: self.layout.clone(),
            decimal: self.decimal.clone(),
            missing_marks: self.missing.clone(),
            crop,
            fill: self.rule_name(),
            missing,
            cleaning: self.cleaning,
            cleaned: cleaned.to_vec(),
            height_step,
        })
    }

    pub(crate) fn measurement(&self, path: &Path) -> Result<Measurement, Unread> {
        let options = self.options()?;
        let read = match &self.content {
            Some(bytes) => surface_io::read_bytes(bytes, &options),
            None => surface_io::read(path, &options),
        };
        self.part(read.map_err(Unread::File)?)
    }

    /// What was asked for of it.
    fn part(&self, measurement: Measurement) -> Result<Measurement, Unread> {
        let Some(text) = &self.crop else { return Ok(measurement) };
        let cut: Cut = text.parse().map_err(|message| Failure::refused("crop", message))?;
        measurement.crop(cut).map_err(Unread::File)
    }
}

/// Why a file gives no surface.
pub(crate) enum Unread {
    File(ReadError),
    Other(Failure),
}

impl From<Failure> for Unread {
    fn from(failure: Failure) -> Self {
        Self::Other(failure)
    }
}

impl Unread {
    /// The exception, with the arguments of `read` that help.
    pub(crate) fn raise(&self, path: &Path) -> PyErr {
        match self {
            // The error of the system keeps its number, and so its class.
            Self::File(ReadError::Io { source, .. }) if source.raw_os_error().is_some() => {
                PyOSError::new_err((
                    source.raw_os_error(),
                    source.to_string(),
                    path.display().to_string(),
                ))
            }
            Self::File(error) => {
                let way_out = needs(&error.needs());
                raise(&Failure::in_file(path, error).adding(&way_out))
            }
            Self::Other(failure) => raise(failure),
        }
    }
}

fn needs(needs: &[surface_io::Need]) -> String {
    use surface_io::Need;
    let argument = |need: &Need| match need {
        Need::PixelSize => "give pixel='1um'",
        Need::LateralUnit => "give lateral_unit='um'",
        Need::HeightUnit => "give height_unit='um'",
        Need::Channel => "choose one with channel=",
        Need::Layout(Layout::Matrix) => "if they are heights, give layout='matrix'",
        Need::Layout(Layout::List) => "if they are coordinates, give layout='list'",
        Need::Layout(Layout::Traces) => {
            "if they are traces of a stylus, give layout='traces' to read_profile"
        }
        Need::DecimalMark => "give decimal='point' or decimal='comma'",
        Need::MissingMark => "if it marks missing points, give missing='MARK'",
        Need::OtherHeightUnit => {
            "if they are heights in another unit, give override_height_unit='um'"
        }
        Need::Fill => {
            "fill them with fill='harmonic' or fill='nearest', or cut out the largest complete part with \
             crop='complete'"
        }
        _ => "",
    };
    let all: Vec<&str> = needs.iter().map(argument).filter(|text| !text.is_empty()).collect();
    all.join(" and ")
}

pub(crate) fn rule(name: &str) -> Result<Fill, Failure> {
    Ok(match name {
        "" | "refuse" => Fill::Refuse,
        "harmonic" => Fill::Harmonic,
        "nearest" => Fill::Nearest,
        other => {
            let message = format!("fill = {other:?} is none of 'refuse', 'harmonic', 'nearest'");
            return Err(Failure::refused("setting", message));
        }
    })
}

/// Why a measurement gives no map, with the arguments that help.
pub(crate) fn unmade(path: &Path, error: &Incomplete) -> Failure {
    let way_out = match error {
        Incomplete::Line(_) => "of a profile, one row, see rc.read_profile".to_owned(),
        Incomplete::Short(_) => "measure a longer trace".to_owned(),
        Incomplete::Spikes(_) => "give fill='harmonic', or a higher threshold".to_owned(),
        Incomplete::Fill(FillError::NotConverged { .. }) => "give fill='nearest'".to_owned(),
        Incomplete::Fill(e) => needs(&e.needs()),
        _ => String::new(),
    };
    let found = error.failure();
    let kind = if let Incomplete::Fill(FillError::Missing { .. }) = error {
        "missing"
    } else {
        found.kind()
    };
    Failure::refused(kind, format!("{}: {}", path.display(), found.message())).adding(&way_out)
}

pub(crate) fn filled(
    path: &Path,
    measurement: Measurement,
    how: &Reading,
) -> Result<Complete, Failure> {
    answers::complete(measurement, how.cleaning, rule(&how.fill)?).map_err(|e| match e {
        Incomplete::Fill(FillError::Missing { .. }) if how.is_array => {
            Failure::refused("missing", format!("{}: {}", path.display(), e.failure().message()))
                .adding("fill them with fill='harmonic' or fill='nearest'")
        }
        _ => unmade(path, &e),
    })
}
