//! A closed form fitted to deterministic solutions: for numbers, and for a map.

mod constants;
mod curves;
mod interval;
mod map;
mod numbers;

pub use constants::{MAP_TERMS, NUMBER_TERMS};
pub use curves::MapCurves;
pub use interval::INTERVAL_TERMS;
pub use map::{MapEquation, map_spread_terms, map_terms};
pub use numbers::{Equation, number_terms};
