//! The command as a user runs it. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

mod cli;
mod cli_accuracy;
mod cli_app;
mod cli_batch;
mod cli_cleaning;
mod cli_compare;
mod cli_export;
mod cli_joint;
mod cli_leak;
mod cli_load;
mod cli_materials;
mod cli_model;
mod cli_pair;
mod cli_profile;
mod cli_refusals;
mod cli_shell;
mod cli_surface;
mod cli_warnings;
mod cli_yielding;
mod front_ends;
