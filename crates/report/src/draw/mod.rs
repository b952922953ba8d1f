//! The drawing kit: colours, marks, texts, axes; every figure is made of these.

pub mod axes;
pub mod labels;
pub mod palette;
pub mod png;
pub mod svg;
