//! The drawing kit: colours, marks, texts, axes; every figure is made of these.

pub(crate) mod axes;
pub(crate) mod labels;
pub(crate) mod palette;
pub(crate) mod png;
pub(crate) mod svg;
