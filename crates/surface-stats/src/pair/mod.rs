//! Two rough bodies pressed together, as one rough surface against a smooth flat.
//!
//! With both heights positive out of their own material, the gap at a place is `g0 - (h1 + h2)`, and to an elastic
//! half-space only that sum matters (Johnson 1985, *Contact Mechanics*, §1.2 and §4.1, doi:10.1017/CBO9781139171731).

mod composite;
mod independence;
mod overlay;

pub use composite::{Composite, Flip, Placing};
pub use independence::Independence;
pub use overlay::Placed;
