//! The study: surfaces and settings go in; statistics, the deterministic solution and every
//! closed-form model over the loads come out, with errors and times, and a report to read them
//! in. The command `rough-contact` is built from this package.
//!
//! Nothing here opens a file or prints: the report writes to any [`std::io::Write`].

mod cleaning;
mod closer;
mod coarser;
mod curve;
mod describe;
pub mod light_load;
pub mod models;
mod progress;
pub mod quantity;
mod recipe;
mod refine;
pub mod report;
mod result;
mod run_file;
mod settings;
mod solver_of;
mod spots;
mod study;
mod surface;
mod surroundings;
pub mod survey;
pub mod tradeoff;
mod verdict;

pub use cleaning::{Cleaning, CleaningError, FormName};
pub use coarser::COARSER;
pub use contact_accuracy::{
    Budget, EdgeShare, Estimate, NotRefined, TwiceFiner, budget, edge_study, plan,
};
pub use progress::{Listener, Progress, StudyError};
pub use recipe::{Recipe, RecipeError, built_in_recipes, parse_recipes};
pub use result::{
    Applies, Choice, ChoiceKind, Closer, Coarser, Comparison, DeterministicAnswer,
    DeterministicPoint, ModelComparison, ModelCurve, Spectral, SurfaceComparison, Verdict,
};
pub use run_file::{RunFile, RunFileError, RunSurface};
pub use settings::{
    EdgesName, LevelName, MethodName, PrecisionName, STEEL_ON_STEEL, Settings, default_pressures,
};
pub use spots::{Spots, contact_spots};
pub use surface::{FileOrigin, GivenOrigin, Origin, Surface, sha256_hex};
pub use surroundings::{Surrounded, on_given};
