//! A surface of which only profiles are known: the models, with what the assumption of isotropy
//! and the length of the traces leave of them. There is no deterministic answer to a profile but
//! that of parallel ridges.

mod findings;
mod study;

pub use findings::profile_findings;
pub use study::{ProfileComparison, ProfileSurface, area_interval, profile_inputs};
