#![doc = include_str!("../README.md")]
//!
//! # The models
//! Each summit is an elliptic paraboloid with its own height and two curvatures, distributed as
//! Nayak's random-process theory says. The models differ in how one summit answers:
//!
//! - [`BushGibsonThomas`]: exactly, as an elliptic Hertz contact.
//! - [`GreenwoodElliptical`]: as a sphere of the geometric mean curvature.
//! - [`MeanCurvature`]: as a sphere of the arithmetic mean curvature.
//!
//! All three are one integral over the curvature ([`SummitModel`]), and all take the height of the
//! flat above the *mean plane of the surface*, not above the mean summit.
//!
//! [`ChangEtsionBogy`] are spheres of Greenwood and Williamson that yield; [`thermal_conductance`] has the
//! correlations of contact conductance and the plasticity indices, [`adhesion`] the numbers that say whether bodies stick.
//!
//! [`nayak`] has the density of summit heights itself.

pub mod adhesion;
mod chang_etsion_bogy;
mod gauss_legendre;
mod kernel_tables;
mod kernels;
mod laws;
pub mod nayak;
mod quadrature;
mod summit_model;
pub mod thermal_conductance;

pub use contact_types::{
    Caveat, Citation, ContactModel, ContactModulus, ContactState, Elastic, ModelError,
    SeparationModel, SpectralMoments, SurfaceError,
};

pub use chang_etsion_bogy::ChangEtsionBogy;
pub use laws::{
    ArithmeticMeanSphere, BushGibsonThomas, EllipticHertz, GeometricMeanSphere,
    GreenwoodElliptical, MeanCurvature,
};
pub use summit_model::{SummitLaw, SummitModel};
