//! What is said of a file before it is read, and why it may give no surface.

use crate::failure::{bug, raise};
use contact_compare::{FileOrigin, Surface, sha256_hex};
use contact_front_end::{Failure, Incomplete, reading};
use pyo3::exceptions::PyOSError;
use pyo3::{PyErr, PyResult};
use serde::{Deserialize, Serialize};
use std::path::Path;
use surface_io::{Cut, FillError, Layout, Measurement, ReadError, load, read_traces_bytes};

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
    /// What is said of a file at this path, or with this content.
    pub(crate) fn of(path: &str, request: &str, content: Option<Vec<u8>>) -> PyResult<Self> {
        let mut how: Self = serde_json::from_str(request).map_err(|e| bug(&e))?;
        path.clone_into(&mut how.file.path);
        Ok(Self { content, ..how })
    }

    /// Every trace of a file of several; one measurement of any other file. The hash of what was read is kept.
    pub(crate) fn measurements(&mut self) -> Result<Vec<Measurement>, Unread> {
        let (options, _) = reading(&self.file)?;
        let bytes = self.content.take().map_or_else(|| load(&self.file.path, &options.limits), Ok);
        let bytes = bytes.map_err(Unread::File)?;
        self.file.sha256 = sha256_hex(&bytes);
        let all = read_traces_bytes(&bytes, &options).map_err(Unread::File)?;
        all.into_iter().map(|m| self.part(m)).collect()
    }

    /// The one measurement of a file; of several traces the first.
    pub(crate) fn measurement(&mut self) -> Result<Measurement, Unread> {
        Ok(self.measurements()?.swap_remove(0))
    }

    fn part(&self, measurement: Measurement) -> Result<Measurement, Unread> {
        let Some(text) = &self.crop else { return Ok(measurement) };
        let cut: Cut = text.parse().map_err(|message| Failure::refused("crop", message))?;
        measurement.crop(cut).map_err(Unread::File)
    }
}

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

/// Why a measurement gives no map, with the arguments that help.
pub(crate) fn unmade(path: &Path, error: &Incomplete, how: &FileReading) -> Failure {
    let way_out = match error {
        Incomplete::Line(_) => "of a profile, one row, see rc.read_profile".to_owned(),
        Incomplete::Rows => "leave align_rows out".to_owned(),
        Incomplete::Form => "give form='polynomial:2', or another degree".to_owned(),
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
    let is_missing = matches!(error, Incomplete::Fill(FillError::Missing { .. }));
    let kind = if is_missing { "missing" } else { &found.kind };
    Failure::refused(kind, format!("{}: {found}", path.display())).adding(&way_out)
}

pub(crate) fn filled(
    path: &Path,
    measurement: Measurement,
    how: &FileReading,
) -> Result<Surface, Failure> {
    let (_, fill) = reading(&how.file)?;
    let found = contact_front_end::complete(measurement, how.file.clone(), fill);
    found.map_err(|e| unmade(path, &e, how))
}
