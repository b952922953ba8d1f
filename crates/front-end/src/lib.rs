#![doc = include_str!("../README.md")]

pub mod bodies;
mod complete;
mod failure;
mod leak;
pub mod loads;
pub mod model;
mod paths;
pub mod quantity;
pub mod shown;
mod solve;
mod statistics;
mod study;
pub mod typed;
pub mod units;
mod work;

pub use complete::{Incomplete, Subject, complete, raw, reading, traces};
pub use failure::Failure;
pub use leak::leak_request;
pub use paths::{pressed, run_file_in, told_apart};
pub use solve::{SolveRequest, SolveResult};
pub use statistics::{Statistics, StatisticsRequest, info, profile_statistics, statistics};
pub use study::{document_names, documents, look_around, not_met, profile_documents};
pub use surface_stats::iso25178::IsoParameter;
pub use work::{Point, Watch};
