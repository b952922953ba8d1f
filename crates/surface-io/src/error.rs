//! Why a file gives no surface.

use crate::Format;
use std::borrow::Cow;
use std::path::PathBuf;

/// Where in a file the trouble is.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// Offset from the start of the file (of the unpacked member, for containers).
    Byte(usize),
    /// Line of a text file, counted from 1.
    Line(usize),
    /// A named field of the header or member of a container.
    Field(Cow<'static, str>),
    /// A point of the map.
    Point {
        /// Row.
        iy: usize,
        /// Column.
        ix: usize,
    },
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Byte(at) => write!(f, "byte {at}"),
            Self::Line(line) => write!(f, "line {line}"),
            Self::Field(name) => write!(f, "{name}"),
            Self::Point { iy, ix } => write!(f, "row {iy}, column {ix}"),
        }
    }
}

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
    /// None of the known formats.
    #[error(
        "the content is none of the known formats (first bytes: {start}); \
         `rough-contact info --list` lists them"
    )]
    UnknownFormat {
        /// The first bytes, printable.
        start: String,
    },
    /// The file breaks the rules of its format.
    #[error("{format}: {place}: {what}")]
    Malformed {
        /// The format it claims.
        format: Format,
        /// Where.
        place: Place,
        /// What is wrong, with the value found.
        what: Cow<'static, str>,
    },
    /// The file is sound but holds something this reader does not read.
    #[error("{format}: {feature} is not supported")]
    Unsupported {
        /// The format.
        format: Format,
        /// What is not read, and where there is one the way out.
        feature: Cow<'static, str>,
    },
    /// The file asks for more than [`Limits`](crate::Limits) allows.
    #[error(
        "{format}: {value} {quantity}, the limit is {limit}; raise `ReadOptions::limits` if the \
         file is trusted"
    )]
    Limit {
        /// The format.
        format: Format,
        /// What there is too much of.
        quantity: &'static str,
        /// How much the file asks for.
        value: u64,
        /// How much is allowed.
        limit: u64,
    },
    /// The file does not say how large a pixel is, or what unit its heights have.
    #[error("{}", missing_scale(*format, *pixel, *height))]
    MissingScale {
        /// The format.
        format: Format,
        /// True if the pixel size is missing.
        pixel: bool,
        /// True if the height unit is missing.
        height: bool,
    },
    /// A pixel size was given that contradicts the coordinates in the file.
    #[error(
        "--pixel {dx:e},{dy:e} m contradicts the file, whose steps along x and y are in the ratio \
         {step_x} : {step_y}; give --pixel DX,DY in that ratio"
    )]
    PixelContradicts {
        /// Given, in metres.
        dx: f64,
        /// Given, in metres.
        dy: f64,
        /// In the file, in its unknown unit.
        step_x: f64,
        /// In the file, in its unknown unit.
        step_y: f64,
    },
    /// An option is not a usable number.
    #[error("{option} = {value:e} m must be finite and greater than 0")]
    BadOption {
        /// Which option.
        option: &'static str,
        /// Its value.
        value: f64,
    },
    /// No channel of this name.
    #[error("{format}: no channel {asked:?}; the file has {available}")]
    NoSuchChannel {
        /// The format.
        format: Format,
        /// What was asked for.
        asked: String,
        /// The names there are.
        available: String,
    },
    /// The channel, or every channel, is not a height.
    #[error(
        "{format}: channel {channel:?} is in {unit:?}, not a height; choose one of {heights} with \
         --channel NAME"
    )]
    NotHeight {
        /// The format.
        format: Format,
        /// The channel.
        channel: String,
        /// Its unit as the file writes it.
        unit: String,
        /// The height channels, or "(the file has no height channel)".
        heights: String,
    },
    /// The rectangle to cut out is not inside the map.
    #[error(
        "crop y0, x0, ny, nx = {y0}, {x0}, {ny}, {nx} is not inside the map of {} x {} points",
        shape[0], shape[1]
    )]
    Crop {
        /// First row.
        y0: usize,
        /// First column.
        x0: usize,
        /// Rows.
        ny: usize,
        /// Columns.
        nx: usize,
        /// Rows and columns there are.
        shape: [usize; 2],
    },
}

impl ReadError {
    /// One word for the kind of trouble, for scripts.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Io { .. } => "io",
            Self::Empty => "empty",
            Self::UnknownFormat { .. } => "unknown_format",
            Self::Malformed { .. } => "malformed",
            Self::Unsupported { .. } => "unsupported",
            Self::Limit { .. } => "limit",
            Self::MissingScale { .. } => "missing_scale",
            Self::PixelContradicts { .. } => "pixel_contradicts",
            Self::BadOption { .. } => "bad_option",
            Self::NoSuchChannel { .. } => "no_such_channel",
            Self::NotHeight { .. } => "not_height",
            Self::Crop { .. } => "crop",
        }
    }
}

fn missing_scale(format: Format, pixel: bool, height: bool) -> String {
    let mut text = format!("{format}: the file gives no ");
    text += match (pixel, height) {
        (true, true) => "pixel size and no height unit: add --pixel DX[,DY] and --height-unit U",
        (true, false) => "pixel size: add --pixel DX[,DY]",
        _ => "height unit: add --height-unit U",
    };
    if pixel {
        text += " (the pixel size is the distance between neighbouring points: 1001 points over \
                 1 mm are 1 mm / 1000 if they stand on both ends, 1 mm / 1001 if each stands for \
                 one cell)";
    }
    text
}

/// Why a measurement cannot become a complete height map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FillError {
    /// Points are missing and [`Fill::Refuse`](crate::Fill::Refuse) was asked for.
    #[error(
        "{missing} of {points} points are missing, the first at row {iy}, column {ix}; fill them \
         with --fill harmonic or --fill nearest, or cut out a complete part with --crop"
    )]
    Missing {
        /// How many points are missing.
        missing: usize,
        /// How many points there are.
        points: usize,
        /// Row of the first.
        iy: usize,
        /// Column of the first.
        ix: usize,
    },
    /// Not a single height.
    #[error("all {points} points are missing: there is nothing to fill from")]
    NothingValid {
        /// How many points there are.
        points: usize,
    },
    /// The points of a profile are not evenly spaced.
    #[error(
        "the points are not evenly spaced: they deviate from even spacing by up to {deviation:.3} \
         steps; interpolate them to even spacing first"
    )]
    Uneven {
        /// Largest deviation in steps.
        deviation: f64,
    },
    /// The filled heights are no height map.
    #[error(transparent)]
    Surface(contact_types::SurfaceError),
    /// The harmonic fill did not reach its tolerance.
    #[error(
        "the harmonic fill stopped at a relative residual of {residual:e} after {iterations} \
         iterations; use --fill nearest"
    )]
    NotConverged {
        /// Residual reached.
        residual: f64,
        /// Iterations spent.
        iterations: usize,
    },
}
