//! The figures of the programs, drawn with the kit of the report.

pub mod accuracy;
pub mod budget;
pub mod kappa;
pub mod survey;
pub mod tradeoff;
