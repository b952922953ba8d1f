//! The built-in theories, one file each. A new one is a file here and its line in [`all`].

mod all;
mod archard;
mod bgt;
mod chang_etsion_bogy;
mod equation;
mod greenwood_elliptical;
mod gw;
mod majumdar_bhushan;
mod multiscale;
mod persson;
mod persson_yield;
mod row;
mod stacked;

pub(crate) use all::all;
