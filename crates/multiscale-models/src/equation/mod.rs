//! A closed form fitted to deterministic solutions: for numbers, and for a map.

mod constants;
mod interval;
mod map;
mod numbers;
mod slopes;

pub use constants::{MAP_TERMS, NUMBER_TERMS};
pub use interval::INTERVAL_TERMS;
pub use map::{MapEquation, map_terms};
pub use numbers::{Equation, number_terms};
pub use slopes::{MapSlopes, SLOPE_KNOTS};
