//! The error budget of a deterministic answer: how far each number may be from the truth, by
//! source, and two intervals that must not be confused.
//!
//! - *Comparison*: grid and iteration. For holding a model against the solution of the same map.
//! - *Prediction*: the finite sample on top. For saying what the surface does, of which the map is
//!   one sample.
//!
//! Sources are in [`grid`], [`iteration`] and [`sample`], one file each, with their constants. The
//! constants come from a study of many surfaces (`cargo xtask budget`, page "Error budget" of the
//! book); where it found no bar that holds, the answer is a reason instead.
//!
//! ```no_run
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let (surface, modulus): (contact_types::HeightMap, contact_types::ContactModulus) = todo!();
//! use contact_accuracy::budget::{Budget, Map};
//! use fft_bem_solver::{Load, Solver};
//!
//! let map = Map::of(&surface)?; // once per surface: one transform, one sort
//! let mut solver = Solver::builder().build(surface.grid(), modulus)?;
//! let solution = solver.solve(&surface, Load::MeanPressure(1e6))?;
//! let budget = Budget::of(&solution, &map);
//! println!("{:?} {:?}", budget.area.comparison(), budget.area.prediction());
//! # Ok(())
//! # }
//! ```
//!
//! # On another grid
//! [`Budget::of`] holds for the grid the map is given on. Of a solution on a *refined* map take
//! [`grid::Finer`] and hand it to [`Budget::refined`] of the budget on the given grid, which gives
//! the bar that holds outside the gate. Of a solution on a *coarsened* map, whose
//! bar comes from elsewhere, replace the part of the grid with [`Budget::with_grid`]; the parts of
//! iteration and sample stay.
//!
//! # At a given gap
//! [`Budget::of`] takes the load as given. Where the gap was, [`Budget::at_given_gap`] moves what is
//! not known of the gap over to the load, and to the area that follows it.

mod area;
mod bend;
mod between;
mod estimate;
mod fall;
mod floor;
mod given_gap;
pub mod grid;
pub mod iteration;
mod long_waves;
mod map;
mod no_interval;
pub mod sample;
mod stiffness;

pub use area::{
    AREA_PER_RESIDUAL, AreaAccuracy, LEFT_OF_CORRECTION, iteration_half_width, left_of_correction,
};
pub use bend::Bend;
pub(crate) use between::same_place;
pub use between::{Between, MOST_DOUBT};
pub use estimate::{Budget, Estimate, Given, RealPressure};
pub use fall::{area_per_load, least_fall};
pub use floor::Floor;
pub use map::Map;
pub use no_interval::NoAreaInterval;
pub use stiffness::Stiffness;
