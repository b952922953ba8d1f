//! The figures of the programs, drawn with the kit of the report.

pub mod tradeoff;
