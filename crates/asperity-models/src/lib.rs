#![doc = include_str!("../README.md")]
//!
//! # The models
//! [`SummitModel`]: each summit is an elliptic paraboloid with its own height and two curvatures, distributed
//! as Nayak's random-process theory says. How one summit answers is its [`SummitLaw`]. The height of the flat is
//! that above the *mean plane of the surface*, not above the mean summit.
//!
//! [`ChangEtsionBogy`] are spheres of Greenwood and Williamson that yield; [`thermal_conductance`] has the
//! correlations of contact conductance, [`adhesion`] the numbers that say whether bodies stick.

pub mod adhesion;
mod chang_etsion_bogy;
mod gauss_legendre;
mod kernel_tables;
mod kernels;
mod laws;
mod quadrature;
mod summit_model;
pub mod thermal_conductance;

pub use contact_types::{
    Caveat, Citation, ContactModel, ContactModulus, ContactState, Elastic, ModelError,
    SeparationModel, SpectralMoments, SurfaceError,
};

pub use chang_etsion_bogy::ChangEtsionBogy;
pub use laws::SummitLaw;
pub use summit_model::SummitModel;
