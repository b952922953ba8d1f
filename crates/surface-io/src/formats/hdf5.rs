//! HDF5 is recognised so that its users learn what to do, and not read: it is a file system in a
//! file, and NetCDF-4, Zygo DATX and MATLAB files are HDF5 with conventions of their own.

use crate::measurement::Contents;
use crate::{Format, Limits, ReadError};

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89HDF\r\n\x1a\n")
}

pub(crate) fn parse<'a>(_: &'a [u8], _: &Limits) -> Result<Contents<'a>, ReadError> {
    Err(ReadError::Unsupported {
        format: Format::Hdf5,
        feature: "reading (also of NetCDF-4 and DATX, which are HDF5 inside; export to X3P, SDF, \
                  NPY or classic NetCDF)"
            .into(),
    })
}
