//! Sentences: what was decided below, in words.

pub(crate) mod adhesion;
mod answer;
pub(crate) mod coarser;
pub(crate) mod conduction;
mod date;
pub(crate) mod edges;
pub(crate) mod finding;
pub(crate) mod loads;
pub(crate) mod materials;
pub(crate) mod pair;
pub(crate) mod plan;
pub(crate) mod profile;
mod ranking;
mod spikes;
mod verdict;
pub(crate) mod yielding;

pub use answer::headline_line;
pub(crate) use answer::{area, covers, headline, highest_pressure, real_pressure};
pub(crate) use date::date;
pub(crate) use loads::{headline_load, load};
pub(crate) use ranking::{
    NOT_RANKED, curves_lead, is_known, named, nearest, ranked, recommendation, within_ten,
};
pub(crate) use verdict::{SMALL_SLOPES, reason, reason_of};
