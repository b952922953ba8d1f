#![doc = include_str!("../README.md")]
//!
//! # What is where
//! - [`budget`]: the error of area, gap, real pressure and stiffness, by source.
//! - [`plan`]: the cheapest grid, precision and tolerance for an accuracy that is asked for.
//! - [`TwiceFiner`]: bars where the map does not resolve its shortest waves, from a finer grid.
//! - [`EdgeShare`] and [`edge_study`]: what a map that does not repeat does at its edges.
//!
//! Every constant comes from studies of many surfaces, which the book shows. Results are numbers
//! and reasons; words for them are found elsewhere.

pub mod budget;
mod continuation;
mod edge_share;
pub mod edge_study;
mod monotone;
pub mod plan;
mod refinement;
mod ringing;
mod table;

pub use budget::{AreaAccuracy, Budget, Estimate, Map, NoAreaInterval};
pub use contact_types::{ContactModulus, Grid, HeightMap};
pub use continuation::regrid;
pub use edge_share::EdgeShare;
pub use fft_bem_solver::{
    BOUNDARY_CORRECTION, Boundary, Load, Maps, Method, Precision, Solution, Solver, SolverBuilder,
    SolverError,
};
pub use refinement::{NotRefined, TwiceFiner, fits};
pub use surface_stats::StatsError;
pub use table::{median, quantile, round_to_digits};

// What the results of this crate are said with.
