//! DATX of Zygo (Mx software): HDF5 with attributes that say unit, pixel size and missing points.
//! The reader of HDF5 has the layout.

use super::hdf5;
use crate::measurement::Contents;
use crate::{Format, Limits, ReadError};

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    hdf5::is_datx(bytes)
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    hdf5::parse_as(bytes, Format::Datx, limits)
}
