//! What the research programs of this workspace share: tables, ensembles and figures. The programs
//! themselves are the examples of this package; `cargo xtask` runs them and puts their tables and
//! pages into the book.

pub mod drawing;
pub mod figures;
pub mod maps;
pub mod rows;
pub mod tradeoff;
