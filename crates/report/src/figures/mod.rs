//! The figures of a study.

pub(crate) mod conduction;
pub(crate) mod cost;
pub(crate) mod curves;
pub(crate) mod deformed;
pub(crate) mod distributions;
pub(crate) mod heights;
pub(crate) mod maps;
pub(crate) mod multiples;
pub(crate) mod profiles;
pub(crate) mod spread;
pub(crate) mod surface;
