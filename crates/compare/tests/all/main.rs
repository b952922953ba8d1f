//! The study as a whole. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

mod light_load;
mod mirrored;
mod pair;
mod persson_gap;
mod profiles;
mod yielding;
