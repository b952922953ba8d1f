//! Uncertainties hold the truth. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

#[path = "../../examples/coverage/families.rs"]
#[allow(dead_code, reason = "the study uses all of it")]
mod families;
mod ladder;
mod leak;
