//! What waves a map is made of.
//!
//! Three normalisations, each named by what its sum or integral gives:
//! - variance per wave `S = |H|² / (ny nx)²`, with `sum S = m0` ([`RoughnessSpectrum`]);
//! - two-dimensional PSD `C = S / (dqy dqx)` in m⁴, with `m0 = ∫ C d²q`, q angular ([`Ring`]);
//! - one-sided profile PSD `S(f)` in m³, with `∫_0^∞ S df = m0`, f = 1/wavelength.
//!
//! The mean of the map (the wave q = 0) is never part of a spectrum.
//!
//! [`RoughnessSpectrum`]: contact_types::RoughnessSpectrum

mod profile;
mod radial;
mod window;

pub use profile::amplitudes;
pub(crate) use profile::{ProfileBin, psd_1d};
pub use radial::{PowerSpectrum, Ring, radial};
pub(crate) use window::window;
