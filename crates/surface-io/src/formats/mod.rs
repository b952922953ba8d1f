//! One file per format. Each opens with the layout and where it is known from, and defines
//! `sniff` (is this the format?) and `parse` (what is in the file?).

#[cfg(feature = "zip")]
pub(crate) mod archive;
pub(crate) mod npy;
pub(crate) mod scattered;
pub(crate) mod table;
#[cfg(feature = "zip")]
pub(crate) mod x3p;
