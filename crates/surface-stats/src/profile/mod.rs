//! Profiles: what one trace of a stylus says of a surface.
//!
//! [`ProfileStatistics::of`] answers most questions in one call. Definitions and choices are in the book, chapter "Profiles".
//! The moments of a profile are those of the surface (Nayak 1971) only if it is isotropic, which no trace can show.

mod moments;
mod parameters;
mod roughness;
mod scatter;
mod spectrum;
mod statistics;
mod trace;

pub use moments::moments;
pub use parameters::ParameterMean;
pub use roughness::{Roughness, Setting, SettingSource};
pub use spectrum::TraceSpectrum;
pub use statistics::{ProfileOptions, ProfileStatistics};
pub use trace::Trace;
