//! HDF5, as far as maps need it: groups, data sets and attributes in the form that the library
//! writes by default.
//!
//! | what | read | not read |
//! |---|---|---|
//! | superblock | versions 0 to 3, also behind a user block of 512 to 2048 bytes | |
//! | groups | symbol tables; links in the header | links in a fractal heap |
//! | data sets | compact, contiguous, chunks in a B-tree version 1, a single chunk | other chunk indices |
//! | filters | deflate, shuffle, Fletcher-32 (not checked) | others |
//! | numbers | integers of 1, 2, 4, 8 bytes, IEEE floats of 4 and 8 bytes, both orders | others |
//! | attributes | numbers, texts, compounds of them, in the header | in a fractal heap |
//!
//! What is [written](hdf5) is the smallest form that every reader knows.
//!
//! Source: The HDF Group, *HDF5 File Format Specification*, version 3.0.

mod dataset;
mod file;
mod types;
mod write;

pub(crate) use dataset::Dataset;
pub(crate) use file::{File, datasets, superblock};
pub(crate) use types::AttributeValue;
pub use write::hdf5;
