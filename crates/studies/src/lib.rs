//! The table and the figures of the study of time against true error. The programs themselves are the examples of this
//! package; `cargo xtask` runs them and puts their tables into the book.

pub mod figures;
pub mod tradeoff;
