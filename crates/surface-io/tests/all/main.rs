//! Files as instruments write them. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

#[path = "../common/mod.rs"]
mod common;

mod formats;
mod headers;
mod hostile;
mod mountains;
mod roundtrip;
mod samples;
mod text;
