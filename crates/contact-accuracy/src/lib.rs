#![doc = include_str!("../README.md")]
//!
//! # What is where
//! - [`Ladder`]: solves a load on a map, on every second point of it, and where needed on twice the points.
//! - [`Budget`]: the numbers of a solution with their [uncertainties](Estimate), by source.
//! - [`climb`]: up the ladder until the area is known as well as it is asked for.
//! - [`EdgeShare`]: what stands at the edge of a map.

mod budget;
mod climb;
mod coarser;
mod edge_share;
mod estimate;
mod indicator;
mod ladder;
mod leak;
mod request;
mod sampling;
mod setup;
mod table;
mod uncertainty;

pub use budget::Budget;
pub use climb::{Aim, Next, Reached, Sink, Task, Unmet, climb};
pub use coarser::{Numbers, regrid, thinned, with_images};
pub use contact_types::{Axis, ContactModulus, Grid, HeightMap};
pub use edge_share::EdgeShare;
pub use estimate::{Estimate, Inverse, NoUncertainty, Parts};
pub use fft_bem_solver::{
    Boundary, Load, Maps, Method, PERIMETER_CORRECTION, Precision, Solution, Solver, SolverBuilder,
    SolverError,
};
pub use gap_flow::{Bottleneck, Flow, NotSolved};
pub use indicator::LIMIT as INDICATOR_LIMIT;
pub use ladder::{Answered, Ladder, LadderError};
pub use leak::{Leak, Leaks};
pub use request::{AccuracyRequest, BadRequest};
pub use sampling::Map;
pub use setup::Setup;
pub use surface_stats::StatsError;
pub use table::{median, round_to_digits};
