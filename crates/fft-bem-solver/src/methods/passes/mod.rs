//! The passes over the finest grid that a chord iteration is made of. Each reads and writes every
//! field once, in pieces that belong to one task, and returns sums that do not depend on the
//! number of threads. Inner loops have numbers of one size: where bytes (the nodes), single and double precision
//! meet in one, half of each vector is shuffling, so nodes become 1 or 0 and pressures that are only compared
//! single precision, a block at a time, in loops of their own.

mod contact_set;
mod line_search;
mod pieces;
mod preconditioner;
mod step;
mod sums;
mod trial;

pub(crate) use contact_set::{
    ContactSet, GapSource, is_rounding, level, level_under, residual, residual_norm2,
};
pub(crate) use line_search::{Products, inner_products, reach};
pub(crate) use pieces::{fill, gap_of_constant, rows_per_task, scale, tasks};
pub(crate) use preconditioner::{gather, push};
pub(crate) use step::{combine, shorten};
pub(crate) use trial::{StepEstimate, end_trial, trial};
