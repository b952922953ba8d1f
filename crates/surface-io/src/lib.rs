#![doc = include_str!("../README.md")]
//!
//! [`read`] recognises a file by its content and returns a [`Measurement`]: heights in metres,
//! missing points as NaN, the pixel size, and what the file says about itself. A unit or a pixel
//! size that the file does not give is an error that tells what is needed; nothing is guessed.
//! [`Measurement::fill`] is the only way from a file to a complete [`HeightMap`], so no formula meets
//! a missing point.
//!
//! # Pixel size and the number of intervals
//!
//! The pixel size is the distance between neighbouring points. "1001 points over 1 mm" can mean
//! 1 mm / 1000 (the points stand on both ends: N − 1 intervals) or 1 mm / 1001 (every point
//! stands for one cell: N intervals). Formats that store a distance or coordinates leave no
//! choice. Formats that store a total length are read as their writers define it, which the page
//! of each format states; [`ReadOptions::pixel`] overrides it.

mod binary;
mod catalogue;
mod cells;
mod cut;
mod encoding;
mod entries;
mod error;
mod fill;
mod finish;
mod formats;
mod harmonic;
mod hdf5;
mod header;
mod meaning;
mod measurement;
mod need;
#[cfg(feature = "zip")]
mod ole;
mod options;
mod packed;
mod read;
mod resample;
mod text;
mod tiff;
mod units;
mod unpack;
pub mod write;
#[cfg(feature = "zip")]
mod xml;

pub use catalogue::{FORMATS, FormatSpec};
pub use contact_types::{Grid, HeightMap, SurfaceError};
pub use cut::Cut;
pub use error::{FillError, ReadError};
pub use fill::Fill;
pub use measurement::{ChannelInfo, Measurement};
pub use need::{Ambiguity, DecimalMark, Layout, Need};
pub use options::{HeightUnit, Limits, ReadOptions};
pub use read::{load, read, read_bytes, read_traces_bytes};
pub(crate) use units::metres_per;
