#![doc = include_str!("../README.md")]

mod facade;

pub use contact_accuracy;
pub use contact_compare as compare;
pub use contact_front_end as front_end;
pub use contact_report as report;
pub use {contact_types, fft_bem_solver, surface_io, surface_stats};

pub use contact_accuracy::{Answered, Budget, Estimate, Ladder, LadderError, NoUncertainty, Setup};
pub use contact_compare::{
    BuildError, Card, Comparison, Conductance, CurvePoint, Inputs, Joint, ModelComparison,
    Progress, Registry, Settings, StudyError, Surface, SurfaceComparison, Tabulated, Theory,
    built_in,
};
pub use contact_front_end::units::Dimension as Quantity;
pub use contact_front_end::{Failure, quantity::parse as quantity};
pub use contact_report::{Provenance, documents};
pub use contact_types::{
    AsperityStatistics, Caveat, Citation, ContactModel, ContactModulus, ContactState, Elastic,
    FractalParameters, Grid, HeightMap, ModelError, SpectralMoments, SurfaceError,
};
pub use facade::{compare, ladder, solve, statistics};
pub use fft_bem_solver::{Boundary, Iteration, Load, Solution, Solver, SolverError};
pub use surface_io::{Fill, FillError, Measurement, ReadError, ReadOptions, read, read_bytes};
pub use surface_stats::pair::{Composite, Flip, Placing};
pub use surface_stats::synthesis;
pub use surface_stats::{Level, StatsError, StatsOptions, SurfaceStatistics, Warning};
