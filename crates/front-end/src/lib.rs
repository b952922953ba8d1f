#![doc = include_str!("../README.md")]

pub mod bodies;
mod complete;
mod documents;
mod failure;
mod info;
mod leak;
pub mod loads;
pub mod model;
mod paths;
mod point;
pub mod quantity;
mod scene;
pub mod shown;
mod solve;
mod statistics;
mod study;
pub mod typed;
pub mod units;
mod watch;
mod work;

pub use complete::{Incomplete, Subject, complete, raw, reading, traces};
pub use documents::{document_names, documents, profile_documents};
pub use failure::Failure;
pub use info::info;
pub use leak::leak_request;
pub use paths::{pressed, run_file_in, told_apart};
pub use point::Point;
pub use solve::{SolveRequest, SolveResult};
pub use statistics::{Statistics, StatisticsRequest, profile_statistics, statistics};
pub use study::{look_around, not_met};
pub use surface_stats::iso25178::IsoParameter;
pub use watch::Watch;
