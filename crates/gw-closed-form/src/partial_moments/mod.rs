//! Partial moments of the standard normal density: the only special functions the
//! Greenwood-Williamson model needs.
//!
//! ```math
//! J_n(\alpha) = \frac{1}{\sqrt{2\pi}} \int_\alpha^\infty (t-\alpha)^n e^{-t^2/2}\,dt
//!             = \frac{\Gamma(n+1)}{\sqrt{2\pi}}\, e^{-\alpha^2/4}\, U(n+\tfrac12, \alpha)
//! ```
//!
//! with U the parabolic cylinder function. J_0 is the fraction of summits above α, J_1 their mean
//! overlap (area), J_3/2 the mean of overlap^{3/2} (load), J_1/2 gives the stiffness. They are
//! the functions F_n of Greenwood and Tripp.
//!
//! # Accuracy
//! A large exact part plus a small correction leaves one rounding: values are right to about one unit in the
//! last place (4e-16 for α < 8, 9e-16 up to the end of the normal range at α ≈ 37.4) and fall with α
//! *to the last bit*. One unit in the last place of α changes J_n by α² units.
//!
//! A result below the smallest double is 0 and one above the largest is `f64::MAX`, never
//! infinity; the logarithm still answers there.
//!
//! # Source
//! Greenwood & Tripp (1970), doi:10.1243/PIME_PROC_1970_185_069_02 (F_n); NIST DLMF §12.5.

mod far_field;
mod function;
mod nodes;
mod orders;

pub use function::times_gaussian;
pub use orders::{Order, ln, ln_derivative, scaled, value};
