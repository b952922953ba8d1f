//! What is said of a file before it is read, and why it may give no surface.

use crate::failure::raise;
use contact_compare::{FileOrigin, Origin};
use contact_front_end::{Complete, Failure, Incomplete};
use contact_types::Named;
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
#[serde(deny_unknown_fields)]
pub(crate) struct FileReading {
    /// As a run file has it.
    pub(crate) file: FileOrigin,
    /// As the command takes it.
    pub(crate) crop: Option<String>,
    /// No file, but an array, which is not cropped.
    #[serde(skip)]
    pub(crate) is_array: bool,
    /// What the file holds, where it is in memory.
    #[serde(skip)]
    pub(crate) content: Option<Vec<u8>>,
}

impl FileReading {
    pub(crate) fn options(&self) -> Result<ReadOptions, Failure> {
        let mut options = ReadOptions::default();
        options.channel.clone_from(&self.file.channel);
        options.pixel = self.file.pixel;
        options.lateral_unit = self.file.lateral_unit;
        options.height_unit = match self.file.override_height_unit {
            Some(metres) => Some(HeightUnit::Always(metres)),
            None => self.file.height_unit.map(HeightUnit::IfSilent),
        };
        if let Some(name) = &self.file.layout {
            let unknown = || Failure::refused("setting", format!("layout {name:?} is none"));
            options.layout = Some(Layout::of_name(name).ok_or_else(unknown)?);
        }
        if let Some(name) = &self.file.decimal {
            let unknown = || Failure::refused("setting", format!("decimal {name:?} is none"));
            options.decimal = Some(DecimalMark::of_name(name).ok_or_else(unknown)?);
        }
        options.missing.clone_from(&self.file.missing_marks);
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

    /// Where heights came from that were read so; what is known of them is how many points were filled, what cleaning
    /// did, and the step of the heights as measured.
    pub(crate) fn origin(
        &self,
        path: &str,
        format: String,
        crop: Option<[usize; 4]>,
        (missing, cleaned, height_step): (usize, &[Record], Option<f64>),
    ) -> Origin {
        let (path, cleaned) = (path.to_owned(), cleaned.to_vec());
        let file = self.file.clone();
        // The hash is made when a run file needs it: most surfaces never do.
        Origin::File(FileOrigin { path, format, crop, missing, cleaned, height_step, ..file })
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
    Fill::of_name(name).ok_or_else(|| {
        let message = format!("fill = {name:?} is none of 'refuse', 'harmonic', 'nearest'");
        Failure::refused("setting", message)
    })
}

/// Why a measurement gives no map, with the arguments that help.
pub(crate) fn unmade(path: &Path, error: &Incomplete, how: &FileReading) -> Failure {
    let way_out = match error {
        Incomplete::Line(_) => "of a profile, one row, see rc.read_profile".to_owned(),
        Incomplete::Short(_) => "measure a longer trace".to_owned(),
        Incomplete::Spikes(_) => "give fill='harmonic', or a higher threshold".to_owned(),
        Incomplete::Fill(FillError::NotConverged { .. }) => "give fill='nearest'".to_owned(),
        Incomplete::Fill(FillError::Missing { .. }) if how.is_array => {
            "fill them with fill='harmonic' or fill='nearest'".to_owned()
        }
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
    how: &FileReading,
) -> Result<Complete, Failure> {
    let found = contact_front_end::complete(measurement, how.file.cleaning, rule(&how.file.fill)?);
    found.map_err(|e| unmade(path, &e, how))
}
