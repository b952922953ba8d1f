//! The methods: a [contract](contract) that all fulfil, three that do, and the parts of the first.
//!
//! From the ground up: *contract* and *compliance* (what a method is given); the parts of the chord
//! iteration that know nothing of it (*transfer*, *extension*, *stiffness*, *sweep*); *chord* and, around it, *`free_chord`*; the baselines *`polonsky_keer`* and
//! *`stanley_kato`*; *choice*.
//!
//! Passes over the finest grid read and write every field once, in pieces that belong to one task. Inner loops have
//! numbers of one size: where bytes (the nodes), single and double precision meet in one, half of each vector is
//! shuffling, so nodes become 1 or 0 and pressures that are only compared single precision, a block at a time.

#![allow(
    clippy::inline_always,
    clippy::needless_bitwise_bool,
    reason = "inner loops belong to each version of `vectorised!`, and have no branches"
)]

mod baseline;
mod ceiling;
mod choice;
mod chord;
mod compliance;
mod contract;
mod cut_cells;
mod equal_cells;
mod extension;
mod free_chord;
mod level;
mod level_control;
mod node;
mod polonsky_keer;
#[cfg(test)]
mod safeguards;
mod set_inverse;
mod stanley_kato;
mod stiffness;
mod sweep;
mod thin_pixels;
mod transfer;

pub(crate) use ceiling::{Ceiling, HardnessCeiling, NoCeiling, under};
pub(crate) use choice::build;
pub(crate) use compliance::Compliance;
pub(crate) use contract::{
    ContactMethod, ContactTask, IterateView, Means, Outcome, Start, State, Target,
};
pub(crate) use level::level_under;
pub(crate) use level_control::RISE;
pub(crate) use node::NodeState;
pub(crate) use set_inverse::SetInverse;
