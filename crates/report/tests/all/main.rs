//! Reports of studies of small surfaces. One program, linked once, that solves each study once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

mod moving;
mod own_model;
mod report;
mod studies;
