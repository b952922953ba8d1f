#![doc = include_str!("../README.md")]

mod channel;
mod conjugate_gradients;
mod gap;
mod network;

pub use channel::Bottleneck;
pub use contact_types::{Grid, SurfaceError};
pub use gap::{Axis, Gap};
pub use network::{Flow, NotSolved};
