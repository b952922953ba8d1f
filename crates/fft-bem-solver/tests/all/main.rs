//! What the solver promises, against exact solutions and other programs. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

#[path = "../common/extremes.rs"]
mod cases;
#[path = "../common/mod.rs"]
mod common;
#[path = "../common/dense.rs"]
mod dense;
#[path = "../common/npy.rs"]
mod npy;
#[path = "../common/numpy_normal.rs"]
mod numpy_normal;

mod analytic;
mod certificate;
mod direct;
mod extremes;
mod perimeter_correction;
mod properties;
mod random_problems;
mod reference_points;
mod set_stiffness;
mod solver;
mod thin_pixels;
mod work;
mod yielding;
