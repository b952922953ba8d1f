//! The calls of the Python package, in Rust.

use contact_accuracy::{Answered, Ladder, LadderError, Setup};
use contact_compare::{Comparison, Registry, Settings, StudyError, Surface};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Load, Solver};
use std::ops::ControlFlow;
use surface_stats::{Level, StatsError, StatsOptions, SurfaceStatistics};

/// Roughness of a map, without its tilt, as `rough-contact stats` takes it.
///
/// # Errors
/// [`StatsError`].
pub fn statistics(map: &HeightMap) -> Result<SurfaceStatistics, StatsError> {
    SurfaceStatistics::of(map, &StatsOptions::default())
}

/// The contact of a map, without its tilt, with a flat: area and gap with their uncertainties.
///
/// # Errors
/// [`LadderError`].
pub fn solve(
    map: &HeightMap,
    modulus: ContactModulus,
    load: Load,
) -> Result<Answered, LadderError> {
    Ok(ladder(map, modulus)?.solve(load, |_| ())?)
}

/// The same for many loads: [`Ladder::solve`] tells each iteration and may be stopped.
///
/// # Errors
/// [`LadderError`].
pub fn ladder(map: &HeightMap, modulus: ContactModulus) -> Result<Ladder, LadderError> {
    Ladder::new(Level::Auto.taken_off(map.clone())?.1, Setup::new(Solver::builder(), modulus))
}

/// Every model of a registry beside the solution of a map.
///
/// # Errors
/// [`StudyError`].
pub fn compare(
    map: HeightMap,
    settings: Settings,
    models: &Registry,
) -> Result<Comparison, StudyError> {
    let surface = Surface::given("surface", map, "heights in memory");
    Comparison::run(vec![surface], settings, models, &mut |_| ControlFlow::Continue(()))
}
