//! Greenwood's simplified elliptical model: a sphere of the geometric mean curvature.

use crate::kernel_tables::{GEOMETRIC_AREA, GEOMETRIC_LOAD};
use crate::kernels::Kernel;
use crate::{SummitLaw, SummitModel};
use contact_types::Citation;
use std::borrow::Cow;

/// Greenwood's simplification of Bush, Gibson and Thomas: each summit is replaced by a sphere of
/// curvature √(κ₁κ₂). Area within 2 % and load within 3 % of the full model.
///
/// # Source
/// Greenwood (2006), doi:10.1016/j.wear.2005.09.031.
pub type GreenwoodElliptical = SummitModel<GeometricMeanSphere>;

/// A sphere of curvature √(κ₁κ₂): area `πδ/κ`, load `(4/3) E* δ^{3/2}/√κ`.
///
/// Its kernels are closed forms, with D Dawson's integral:
///
/// ```math
/// W_A = \tfrac13\, {}_1F_1(1; \tfrac52; -t^2) = \frac{1 - D(t)/t}{2t^2}, \qquad
/// W_P = \tfrac{4}{7\pi}\, {}_1F_1(1; \tfrac{11}{4}; -t^2)
/// ```
#[derive(Debug, Clone, Copy)]
pub struct GeometricMeanSphere;

impl SummitLaw for GeometricMeanSphere {
    const NAME: &'static str = "Greenwood simplified elliptical";
    const CITATION: Citation = Citation {
        authors: Cow::Borrowed("Greenwood"),
        year: 2006,
        title: Cow::Borrowed("A simplified elliptic model of rough surface contact"),
        journal: Cow::Borrowed("Wear 261, 191-200"),
        doi: Cow::Borrowed("10.1016/j.wear.2005.09.031"),
    };
    const AREA: &'static Kernel = &GEOMETRIC_AREA;
    const LOAD: &'static Kernel = &GEOMETRIC_LOAD;
    const FULL_OVERLAP: f64 = 0.83;
}
