//! The study: surfaces and settings go in; statistics, the deterministic solution and every
//! closed-form model over the loads come out, with errors, times and verdicts, as data.
//!
//! Nothing here opens a file, prints, draws or words anything: the crate `report` makes documents
//! out of these results.

mod cleaning;
mod closer;
mod coarser;
mod curve;
mod describe;
mod finding;
mod findings;
pub mod models;
mod progress;
mod recipe;
mod refine;
mod result;
mod run_file;
mod settings;
mod solver_of;
mod spots;
mod study;
mod surface;
mod surroundings;
pub mod survey;
mod verdict;

pub use cleaning::{Cleaning, CleaningError, FormName};
pub use coarser::COARSER;
pub use contact_accuracy::{
    Budget, EdgeShare, Estimate, NotRefined, TwiceFiner, budget, edge_study, plan,
};
pub use finding::{Bare, Fact, Finding, Passed, Seam, Subject, Weight};
pub use findings::{Solved, findings, seam};
pub use progress::{Progress, StudyError};
pub use recipe::{Recipe, RecipeError, built_in_recipes, parse_recipes};
pub use result::{
    Applies, Choice, ChoiceKind, Closer, Coarser, Comparison, DeterministicAnswer,
    DeterministicPoint, ModelComparison, ModelCurve, Reason, Spectral, SurfaceComparison, Verdict,
};
pub use run_file::{RunFile, RunFileError, RunSurface};
pub use settings::{
    EdgesName, LevelName, MethodName, PrecisionName, STEEL_ON_STEEL, Settings, default_pressures,
};
pub use spots::{Spots, contact_spots};
pub use surface::{FileOrigin, Origin, Surface, sha256_hex};
pub use surroundings::{Surrounded, on_given};
