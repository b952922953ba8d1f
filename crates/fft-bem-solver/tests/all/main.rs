//! What the solver promises, against exact solutions and other programs. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

#[path = "../common/mod.rs"]
mod common;

mod analytic;
mod cases;
mod certificate;
mod dense;
mod direct;
mod extremes;
mod npy;
mod numpy_normal;
mod perimeter_correction;
mod properties;
mod random_problems;
mod reference_points;
mod set_stiffness;
mod solver;
mod thin_pixels;
mod work;
mod yielding;
