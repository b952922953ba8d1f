//! The chord iteration: [the loop](iteration), its [steps](steps), the [guesses](guess) before the
//! first, what it [remembers](memory), the fields it [works](work) on.

mod guess;
mod iteration;
mod memory;
mod steps;
mod work;

#[cfg(test)]
pub(crate) use memory::{Kind, Known};
pub(crate) use work::{Chord, room};
