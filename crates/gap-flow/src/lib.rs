#![doc = include_str!("../README.md")]

mod channel;
#[cfg(feature = "cholesky")]
mod cholesky;
mod conjugate_gradients;
mod gap;
mod network;

pub use channel::Bottleneck;
pub use conjugate_gradients::NotSolved;
pub use contact_types::{Axis, Grid, SurfaceError};
pub use gap::Gap;
pub use network::Flow;
