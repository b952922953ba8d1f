//! Measured surfaces: files in, files out.
//!
//! [`read`] recognises a file by its content and returns a [`Measurement`]: heights in metres,
//! missing points as NaN, the pixel size, and what the file says about itself. A unit or a pixel
//! size that the file does not give is an error that tells what is needed; nothing is guessed. [`Measurement::fill`] is the only way from a file to a complete
//! [`HeightMap`](contact_types::HeightMap), so no formula meets a missing point.
//!
//! ```
//! use surface_io::{Fill, ReadOptions, read_bytes};
//!
//! let text = "# Width: 4 µm\n# Height: 2 µm\n# Value units: nm\n1 2 3 4\n5 NaN 7 8\n";
//! let measurement = read_bytes(text.as_bytes(), &ReadOptions::default())?;
//! assert_eq!(measurement.grid().shape(), [2, 4]);
//! assert_eq!(measurement.missing(), 1);
//! let map = measurement.fill(Fill::Harmonic)?;
//! assert!((map.at(0, 1) - 2e-9).abs() < 1e-24);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
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
mod error;
mod fill;
mod finish;
mod format;
mod formats;
mod harmonic;
mod hdf5;
mod layout;
mod limits;
mod meaning;
mod measurement;
mod need;
mod options;
mod read;
mod text;
mod tiff;
mod units;
mod unpack;
pub mod write;
#[cfg(feature = "zip")]
mod xml;

pub use catalogue::{FORMATS, FormatSpec};
pub use contact_types::{Grid, HeightMap, SurfaceError};
pub use error::{FillError, Place, ReadError};
pub use fill::Fill;
pub use format::Format;
pub use layout::Layout;
pub use limits::Limits;
pub use measurement::{ChannelInfo, Measurement};
pub use need::{Ambiguity, Need};
pub use options::{HeightUnit, ReadOptions};
pub use read::{read, read_bytes, read_channels, read_channels_bytes};
pub use units::metres_per;
