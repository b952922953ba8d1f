//! Sentences: what was decided below, in words.

pub(crate) mod adhesion;
mod answer;
pub(crate) mod conduction;
pub(crate) mod finding;
pub(crate) mod leak;
pub(crate) mod loads;
pub(crate) mod materials;
pub(crate) mod pair;
pub(crate) mod plan;
pub(crate) mod profile;
mod ranking;
mod verdict;
pub(crate) mod yielding;

pub(crate) use answer::{area, headline, real_pressure};
pub use answer::{headline_line, surface_lines};
pub(crate) use finding::edge_words;
pub(crate) use loads::{headline_load, load};
pub(crate) use ranking::{cheapest, coarser_routes, is_known, named, nearest, published, ranked};
pub(crate) use verdict::{SMALL_SLOPES, reason_of};
