//! Profiles: what one trace of a stylus says of a surface.
//!
//! [`ProfileStatistics::of`] answers most questions in one call: moments with the interval that
//! the length of the traces leaves, what the spacing of the points hides, PSD and scaling, and
//! the parameters of ISO 21920-2 at a named setting. Definitions and choices are in the book,
//! chapter "Profiles".
//!
//! A profile holds one direction. Its moments are those of the surface in the sense of
//! [`SpectralMoments`](crate::SpectralMoments) (Nayak 1971) if the surface is isotropic, and only
//! then: no trace can show whether it is.

mod moments;
mod parameters;
mod roughness;
mod scatter;
mod spectrum;
mod statistics;
mod trace;

pub use moments::{AtSpacing, moments};
pub use roughness::{Roughness, Setting, SettingSource};
pub use scatter::MomentScatter;
pub use spectrum::TraceSpectrum;
pub use statistics::{ParameterMean, ProfileOptions, ProfileStatistics};
pub(crate) use trace::LEAST_POINTS;
pub use trace::Trace;
