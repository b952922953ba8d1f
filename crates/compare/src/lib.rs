//! The study: surfaces and settings go in; statistics, the deterministic solution and every
//! closed-form model over the loads come out, with errors and times, and a report to read them
//! in. The command `rough-contact` is built from this package.
//!
//! Nothing here opens a file or prints: the report writes to any [`std::io::Write`].

pub mod budget;
mod cleaning;
mod closer;
mod coarser;
mod curve;
mod describe;
mod edge_share;
pub mod edge_study;
pub mod models;
pub mod plan;
mod recipe;
mod refine;
mod regrid;
pub mod report;
mod result;
mod run_file;
mod settings;
mod spots;
mod study;
mod surface;
mod surroundings;
pub mod survey;
pub mod table;
mod verdict;

pub use budget::{Budget, Estimate};
pub use cleaning::{Cleaning, CleaningError, FormName};
pub use closer::{Choice, ChoiceKind, Closer};
pub use coarser::{COARSER, Coarser};
pub use edge_share::EdgeShare;
pub use recipe::{Recipe, RecipeError, built_in_recipes, parse_recipes};
pub use refine::{NotRefined, TwiceFiner};
pub use result::{
    Applies, Comparison, DeterministicAnswer, DeterministicPoint, ModelComparison, ModelCurve,
    Reason, Spectral, SurfaceComparison, Verdict,
};
pub use run_file::{RunFile, RunFileError, RunSurface};
pub use settings::{
    EdgesName, LevelName, MethodName, PrecisionName, STEEL_ON_STEEL, Settings, default_pressures,
};
pub use spots::{Spots, contact_spots};
pub use study::{Progress, StudyError};
pub use surface::{FileOrigin, Origin, Surface, sha256_hex};
pub use surroundings::{Surrounded, on_given};
