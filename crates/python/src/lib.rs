//! The extension module of the Python package `rough_contact`: arrays, text and JSON in, arrays and JSON out.
//!
//! Everything people see is written in Python, in `python/rough_contact`. Here are only calls of the crates, the
//! lock of the interpreter, which is let go while they work, and the thread that looks out for Ctrl-C.

mod again;
mod failure;
mod model;
mod module;
mod profile;
mod reading;
mod solve;
mod statistics;
mod study;
mod summary;
mod surface;
mod watched;
