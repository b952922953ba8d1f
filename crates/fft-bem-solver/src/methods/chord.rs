//! The chord iteration: [the loop](iteration) with its steps in order, [`active_set`], [trial], [line]; what it
//! [remembers](run) and all else it [works](work) with.

mod active_set;
mod iteration;
mod line;
mod run;
mod trial;
mod work;

pub(crate) use iteration::Chord;
