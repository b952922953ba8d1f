//! What a study looks like: one page to read, figures as files, and tables for other programs.
//! Everything writes to [`std::io::Write`]; nothing here opens a file.

#![allow(
    clippy::format_collect,
    clippy::format_push_string,
    reason = "a page is text put together from pieces, once"
)]

mod accuracy_figure;
mod axes;
mod budget;
mod budget_figure;
mod budget_json;
mod coarser;
mod cost;
mod csv;
mod curves;
mod edges;
mod how_made;
mod html;
mod json;
mod kappa_figures;
mod labels;
mod lines;
mod maps;
mod multiples;
mod notes;
pub(crate) mod numbers;
mod overview;
mod palette;
mod panels;
mod plan_words;
mod png;
mod sections;
mod statistics;
mod surface_figures;
mod survey_figures;
mod svg;
mod tables;
mod tradeoff_figures;
mod words;

pub use accuracy_figure::write_accuracy;
pub use budget_figure::{BarErrors, write_budget};
pub use budget_json::keys as budget_keys;
pub use csv::write as write_csv;
pub use html::write as write_html;
pub use json::{
    accuracy as accuracy_json, cleaning as cleaning_json, comparison as comparison_json,
    statistics as statistics_json, write as write_json,
};
pub use kappa_figures::{
    model_kappa, model_slope, write_kappa_bandwidth, write_kappa_full, write_kappa_load,
};
pub use palette::{
    BGT, Colour, ELLIPTICAL, GW, Look, MAJUMDAR_BHUSHAN, MULTISCALE, Marker, PERSSON, STACKED,
};
pub use panels::{write_area_svg, write_pressure_svg};
pub use plan_words::{explanation as plan_explanation, reason as plan_reason};
pub use survey_figures::{write_survey_map, write_survey_slopes};
pub use tradeoff_figures::{write_tradeoff_area, write_tradeoff_pressure};

use std::time::{SystemTime, UNIX_EPOCH};

/// A pressure as the report writes it, "10 MPa".
pub(crate) fn pressure(pascals: f64) -> String {
    numbers::chosen(pascals, numbers::PASCALS)
}

/// A length as the report writes it, "28 µm".
pub(crate) fn length(metres: f64) -> String {
    numbers::quantity(metres, numbers::METRES, 2)
}

/// Circumstances of a run that are not part of its result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    /// Version of this package.
    pub version: String,
    /// Operating system and processor.
    pub platform: String,
    /// Seconds since 1970 (UTC).
    pub unix_time: u64,
    /// The command that repeats the run.
    pub repeat: String,
}

impl Provenance {
    /// This version on this machine now.
    pub fn here(repeat: impl Into<String>) -> Self {
        let now = SystemTime::now().duration_since(UNIX_EPOCH);
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            platform: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            unix_time: now.map_or(0, |d| d.as_secs()),
            repeat: repeat.into(),
        }
    }
}

/// Why a report could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The writer failed.
    #[error("the report could not be written: {0}")]
    Io(#[from] std::io::Error),
    /// A picture could not be encoded.
    #[error("a picture of the report could not be encoded: {0}")]
    Picture(#[from] ::png::EncodingError),
    /// A value has no JSON form.
    #[error("the results could not be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}
