#![doc = include_str!("../README.md")]

mod adhesion;
mod ask;
mod closer;
mod conducted;
mod conduction;
mod curve;
mod distribution;
mod finding;
mod findings;
mod gas;
mod materials;
mod needs;
mod pressure_maps;
mod profile;
mod progress;
mod registry;
mod result;
mod scene;
mod settings;
mod spikes;
mod study;
mod surface;
pub mod survey;
mod tabulated;
mod theories;
mod theory;
mod verdict;

pub use adhesion::{Adhesion, NO_PULL_OFF, WorkOfAdhesion};
pub use ask::possible;
pub use conducted::{Conductance, Conducted, Conduction, Joint, Octave, TheoryStiffness};
pub use conduction::conducted_by;
pub use contact_accuracy::{
    AccuracyRequest, Budget, EdgeShare, Estimate, Inverse, NoUncertainty, Reached, with_images,
};
pub use contact_types::{
    Caveat, Citation, ContactModel, ContactModulus, ContactState, Grid, HeightMap, ModelError,
    SeparationModel, SpectralMoments, SurfaceError,
};
pub use distribution::{
    Distributions, GapDistribution, PressureHistogram, Spot, SpotDistribution, contact_spots,
};
pub use fft_bem_solver::{
    Diagnostics, End, Iteration, Load, Method, ObserverResult, Precision, Solution, Solver,
    SolverError, Yielded,
};
pub use finding::{
    Applies, Fact, Finding, Passed, Pressed, Reason, Seam, Unevenness, Verdict, Weight, Yielding,
};
pub use findings::{Solved, findings, measured, seam};
pub use gas::{GapGas, Gas};
pub use grid_fft::parallel::on_threads;
pub use materials::{Listed, Material, MaterialUse, Property, material, materials};
pub use needs::{INPUTS, Input, InputFact, InputSet, InputUnit, Inputs, OfMap};
pub use pressure_maps::{FirstContact, PressureMap, PressureMaps, pressure_class, pressure_top};
pub use profile::{
    ProfileComparison, ProfileSurface, area_interval, profile_findings, profile_inputs,
};
pub use progress::{Listener, Progress, StudyError};
pub use registry::{Registry, built_in, find};
pub use result::{
    ChoiceKind, Coarser, Comparison, DeterministicAnswer, DeterministicPoint, ModelComparison,
    ModelCurve, Refused, Section, Spectral, SurfaceComparison,
};
pub use scene::{
    BULK_YIELD, Hardness, PlasticityIndices, Scene, elastic_holds, elastic_limit, hardness_of,
    is_steep, typical_hardness,
};
pub use settings::{
    Along, Body, EdgesName, LeakRequest, RunFile, RunSurface, STEEL, Seal, Settings, poisson,
};
pub use spikes::{SPIKE_THRESHOLD, Spikes};
pub use study::loads as loads_of_study;
pub use surface::{
    Cleaning, FileOrigin, GivenOrigin, Origin, PairOrigin, Recipe, Surface, built_in_recipes,
    sha256_hex,
};
pub use surface_stats::Level;
pub use surface_stats::pair::{Flip, Independence, Placed, Placing};
pub use tabulated::{CurvePoint, Tabulated};
pub use theory::{Assumes, BuildError, Card, Theory};
