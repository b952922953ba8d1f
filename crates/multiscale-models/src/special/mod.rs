//! Special functions the theories need, to a few units in the last place.
//!
//! The error function and its complement are those of the `libm` crate (measured over 4000
//! random arguments against 40-digit values: 0.7 and 1.5 units in the last place). What no small
//! crate has with that accuracy is here: the integrals of Persson's mean gap.

mod coefficients;
mod gap_integrals;
mod gauss;

pub(crate) use gap_integrals::{half_e1_of_square, squared_erf_tail};
pub(crate) use gauss::gauss_legendre;
pub(crate) use libm::{erf, erfc};
