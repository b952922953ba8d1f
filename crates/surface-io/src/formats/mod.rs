//! One file per format. Each opens with the layout and where it is known from, and defines
//! `sniff` (is this the format?) and `parse` (what is in the file?).

pub(crate) mod al3d;
#[cfg(feature = "zip")]
pub(crate) mod archive;
pub(crate) mod bcrf;
pub(crate) mod foreign;
pub(crate) mod frt;
pub(crate) mod gwy;
pub(crate) mod hdf5;
pub(crate) mod ibw;
pub(crate) mod mi;
pub(crate) mod mnt;
pub(crate) mod nanoscope;
pub(crate) mod netcdf;
pub(crate) mod nid;
pub(crate) mod nms;
pub(crate) mod npy;
#[cfg(feature = "zip")]
pub(crate) mod npz;
pub(crate) mod opd;
pub(crate) mod opdx;
pub(crate) mod plu;
pub(crate) mod scattered;
pub(crate) mod sdf;
pub(crate) mod sur;
pub(crate) mod table;
pub(crate) mod tmd;
pub(crate) mod wsxm;
#[cfg(feature = "zip")]
pub(crate) mod x3p;
pub(crate) mod zygo;
