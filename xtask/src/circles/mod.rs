//! Circles of files: inside a crate, files import each other downwards only.
//!
//! Each name that a file imports is followed through re-exports to the file that defines it; a
//! re-export alone is a face and no arrow. What is not seen: a method of an `impl` that stands in
//! another file than its type, and names that a macro makes.

mod graph;
mod lexer;
mod uses;

pub(crate) use graph::{circles, faces};
