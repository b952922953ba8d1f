#![doc = include_str!("../README.md")]

pub mod adhesion;
pub mod bodies;
mod complete;
mod conduction;
mod documents;
mod failure;
mod hardness;
mod info;
mod iso;
pub mod leak;
pub mod loads;
pub mod model;
pub mod models;
mod paths;
mod planned;
mod point;
pub mod quantity;
pub mod scene;
pub mod shown;
mod solve;
mod statistics;
mod study;
mod traces;
pub mod typed;
pub mod units;
mod validated;
mod watch;
mod work;

pub use complete::{Complete, Incomplete, clean, complete};
pub use documents::{
    DOCUMENTS, PROFILE_DOCUMENTS, documents, profile_documents, profile_documents_named,
};
pub use failure::{Failure, variant};
pub use hardness::doubt as hardness_doubt;
pub use info::info;
pub use iso::Iso;
pub use leak::{Leak, Seal};
pub use paths::{run_file_in, told_apart};
pub use planned::unmet;
pub use point::Point;
pub use solve::{Answer, Question, Subject};
pub use statistics::{Measured, Statistics, statistics};
pub use study::{look_around, not_met};
pub use traces::Traces;
pub use validated::validated;
pub use watch::Watch;
