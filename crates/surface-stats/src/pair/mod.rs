//! Two rough bodies pressed together, as one rough surface against a smooth flat.
//!
//! With both heights positive out of their own material, the gap at a place is
//! `g0 - (h1 + h2)`, with `h2` the height of the second body at the point that faces it. To an elastic
//! half-space only that sum matters (Johnson 1985, *Contact Mechanics*, §1.2 and §4.1,
//! doi:10.1017/CBO9781139171731), so the pair is solved as one map: the [`Composite`].

mod composite;
mod independence;
mod overlay;

pub use composite::{Composite, Flip, Placing};
pub use independence::Independence;
pub use overlay::Placed;
