//! A closed form fitted to deterministic solutions: for numbers, and for a map.

mod constants;
mod curves;
mod interval;
mod map;
mod numbers;

pub use constants::{MAP_TERMS, NUMBER_TERMS};
pub use curves::{CURVE_KNOTS, MapCurves, SHARE_KNOTS};
pub use interval::INTERVAL_TERMS;
pub use map::{MapEquation, map_terms};
pub use numbers::{Equation, number_terms};
