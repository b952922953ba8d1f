//! Why a file gives no surface.

use crate::need::{Layout, Need};
use contact_types::Named;
use std::borrow::Cow;
use std::path::PathBuf;

/// The name of texts, whose columns can be more than one thing.
pub(crate) const TEXT: &str = "text";
/// A container of others.
pub(crate) const ZIP: &str = "ZIP or gzip";

/// Why a file could not be read. Whose fault it is, is the variant.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The operating system refused.
    #[error("cannot read {}: {source}", path.display())]
    Io {
        /// The file asked for.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// Zero bytes.
    #[error("the file is empty (0 bytes)")]
    Empty,
    /// None of the known formats, by its first bytes.
    #[error("the content is none of the known formats (first bytes: {0})")]
    UnknownFormat(String),
    /// The file breaks the rules of its format.
    #[error("{format}: {place}: {what}")]
    Malformed {
        /// The format it claims.
        format: &'static str,
        /// Where: a byte from the start of the file (of the unpacked member, for containers), a line counted from 1, a
        /// field of the header, a member of a container, or a point of the map.
        place: Cow<'static, str>,
        /// What is wrong, with the value found.
        what: Cow<'static, str>,
    },
    /// The file is sound but holds something this reader does not read.
    #[error("{format}: {feature} is not supported")]
    Unsupported {
        /// The format.
        format: &'static str,
        /// What is not read, and where there is one the way out.
        feature: Cow<'static, str>,
    },
    /// A format that is known by its first bytes and not read.
    #[error("this is {name}, which is not read; {way_out}")]
    NotRead {
        /// What it is.
        name: &'static str,
        /// What to do with it.
        way_out: &'static str,
    },
    /// The file asks for more than [`Limits`](crate::Limits) allows.
    #[error("{format}: {value} {quantity}, the limit is {limit}")]
    Limit {
        /// The format.
        format: &'static str,
        /// What there is too much of.
        quantity: &'static str,
        /// How much the file asks for.
        value: u64,
        /// How much is allowed.
        limit: u64,
    },
    /// The file does not say how large a pixel is, or what unit its numbers have.
    #[error("{}", missing_scale(format, needs, unused.as_deref()))]
    MissingScale {
        /// The format.
        format: &'static str,
        /// What it does not say: never empty.
        needs: Vec<Need>,
        /// Entries of its header that look like a size, a scale or a unit and are not understood.
        unused: Option<String>,
    },
    /// A pixel size was given that contradicts the coordinates in the file.
    #[error(
        "the pixel size given, dx = {:e} m, dy = {:e} m, contradicts the file, whose steps \
         along x and y are in the ratio {} : {}",
        given[1], given[0], steps[1], steps[0]
    )]
    PixelContradicts {
        /// `[dy, dx]` given, in metres.
        given: [f64; 2],
        /// Along y and x in the file, in its unknown unit.
        steps: [f64; 2],
    },
    /// What was given is not a usable number.
    #[error("the {given} given, {value:e} m, must be finite and greater than 0")]
    BadOption {
        /// What was given.
        given: Need,
        /// Its value.
        value: f64,
    },
    /// A cell of a table that is neither a number nor a mark of a missing point.
    #[error("text: line {line}, cell {cell}: {text:?} is no number")]
    NotANumber {
        /// Line, counted from 1.
        line: usize,
        /// Cell in that line, counted from 1.
        cell: usize,
        /// What stands there.
        text: String,
    },
    /// A text that can be read in more than one way.
    #[error("text: {what}")]
    Ambiguous {
        /// The readings.
        what: String,
        /// What decides.
        needs: Vec<Need>,
    },
    /// The layout asked for is none this file can have.
    #[error("{format}: read as a {} although {reason}", layout.name())]
    BadLayout {
        /// The format.
        format: &'static str,
        /// What was asked for.
        layout: Layout,
        /// Why that cannot be.
        reason: &'static str,
    },
    /// No channel of this name.
    #[error("{format}: no channel {asked:?}; the file has {available}")]
    NoSuchChannel {
        /// The format.
        format: &'static str,
        /// What was asked for.
        asked: String,
        /// The names there are.
        available: String,
    },
    /// The channel, or every channel, is not a height.
    #[error(
        "{format}: channel {channel:?} is in {unit:?}, which is no unit of length; channels of heights: \
         {heights}"
    )]
    NotHeight {
        /// The format.
        format: &'static str,
        /// The channel.
        channel: String,
        /// Its unit as the file writes it.
        unit: String,
        /// The height channels, or "(the file has none)".
        heights: String,
        /// No channel is a height.
        is_only: bool,
    },
    /// The rectangle to cut out is not inside the map.
    #[error(
        "crop y0, x0, ny, nx = {}, {}, {}, {} is not inside the map of {} x {} points",
        part[0], part[1], part[2], part[3], shape[0], shape[1]
    )]
    Crop {
        /// `[y0, x0, ny, nx]` asked for.
        part: [usize; 4],
        /// Rows and columns there are.
        shape: [usize; 2],
    },
    /// No part of the map of so many rows and columns is complete.
    #[error(
        "of the {} x {} points no 2 x 2 are without a missing one, so that no complete part can be cut out",
        .0[0], .0[1]
    )]
    NothingComplete([usize; 2]),
}

impl ReadError {
    /// One word for the kind of trouble, for scripts.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Io { .. } => "io",
            Self::Empty => "empty",
            Self::UnknownFormat { .. } => "unknown_format",
            Self::NotRead { .. } => "not_read",
            Self::Malformed { .. } => "malformed",
            Self::Unsupported { .. } => "unsupported",
            Self::Limit { .. } => "limit",
            Self::MissingScale { .. } => "missing_scale",
            Self::PixelContradicts { .. } => "pixel_contradicts",
            Self::BadOption { .. } => "bad_option",
            Self::BadLayout { .. } => "bad_layout",
            Self::NotANumber { .. } => "not_a_number",
            Self::Ambiguous { .. } => "ambiguous",
            Self::NoSuchChannel { .. } => "no_such_channel",
            Self::NotHeight { .. } => "not_height",
            Self::Crop { .. } | Self::NothingComplete { .. } => "crop",
        }
    }

    /// What a caller can add so that the file is read: nothing where the file is at fault.
    pub fn needs(&self) -> Vec<Need> {
        match self {
            Self::MissingScale { needs, .. } | Self::Ambiguous { needs, .. } => needs.clone(),
            Self::PixelContradicts { .. } => vec![Need::PixelSize],
            Self::NoSuchChannel { .. } => vec![Need::Channel],
            Self::NotHeight { is_only, .. } => {
                let other = (!is_only).then_some(Need::Channel);
                other.into_iter().chain([Need::OtherHeightUnit]).collect()
            }
            Self::NotANumber { .. } => vec![Need::MissingMark],
            Self::Limit { .. } => vec![Need::Limits],
            Self::BadOption { given, .. } => vec![*given],
            _ => Vec::new(),
        }
    }

    /// The file holds something that is not read.
    pub(crate) fn unsupported(format: &'static str, feature: impl Into<Cow<'static, str>>) -> Self {
        Self::Unsupported { format, feature: feature.into() }
    }

    /// The file breaks the rules of the format at a place.
    pub(crate) fn at(
        format: &'static str,
        place: impl Into<Cow<'static, str>>,
        what: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self::Malformed { format, place: place.into(), what: what.into() }
    }
}

fn missing_scale(format: &'static str, needs: &[Need], unused: Option<&str>) -> String {
    let names: Vec<String> = needs.iter().map(Need::to_string).collect();
    let mut text = format!("{format}: the file gives no {}", names.join(" and no "));
    if needs.contains(&Need::PixelSize) {
        text += " (the pixel size is the distance between neighbouring points: 1001 points over \
                 1 mm are 1 mm / 1000 if they stand on both ends, 1 mm / 1001 if each stands for \
                 one cell)";
    }
    if let Some(unused) = unused {
        text = text + "; its header says " + unused + ", which was not used";
    }
    text
}

/// Why a measurement cannot become a complete height map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FillError {
    /// Points are missing and [`Fill::Refuse`](crate::Fill::Refuse) was asked for.
    #[error(
        "{missing} of {points} points are missing, the first at row {}, column {}",
        first[0], first[1]
    )]
    Missing {
        /// How many points are missing.
        missing: usize,
        /// How many points there are.
        points: usize,
        /// Row and column of the first.
        first: [usize; 2],
    },
    /// Not a single height at so many points.
    #[error("all {0} points are missing: there is nothing to fill from")]
    NothingValid(usize),
    /// The points of a profile are not evenly spaced; they deviate by so many steps.
    #[error(
        "the points are not evenly spaced: they deviate from even spacing by up to {0:.3} steps; interpolate them to \
         even spacing first (Measurement::evenly_spaced)"
    )]
    Uneven(f64),
    /// Two points of a profile stand so far apart that nothing is known between them.
    #[error(
        "two points are {:.3} mm apart, {:.0} times the mean distance; at most {limit} times is \
         bridged by a straight line: cut the gap out, or measure again",
        1e3 * gap, gap / spacing
    )]
    Gap {
        /// Largest distance of neighbouring points (m).
        gap: f64,
        /// Mean distance (m).
        spacing: f64,
        /// Largest quotient of the two.
        limit: f64,
    },
    /// The filled heights are no height map.
    #[error(transparent)]
    Surface(contact_types::SurfaceError),
    /// The harmonic fill did not reach its tolerance.
    #[error(
        "the harmonic fill stopped at a relative residual of {residual:e} after {iterations} \
         iterations"
    )]
    NotConverged {
        /// Residual reached.
        residual: f64,
        /// Iterations spent.
        iterations: usize,
    },
}

impl FillError {
    /// What a caller can add so that the map becomes complete.
    pub fn needs(&self) -> Vec<Need> {
        match self {
            Self::Missing { .. } | Self::NotConverged { .. } => vec![Need::Fill],
            _ => Vec::new(),
        }
    }
}
