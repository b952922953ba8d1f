//! The page `report.html`, section by section.

pub(crate) mod budget;
pub(crate) mod conduction;
pub(crate) mod contact_map;
pub(crate) mod how_made;
pub(crate) mod html;
pub(crate) mod leak;
pub(crate) mod moving;
pub(crate) mod overview;
pub(crate) mod profile;
pub(crate) mod sections;
pub(crate) mod shared;
pub(crate) mod slider;
pub(crate) mod statistics;
pub(crate) mod summary;
pub(crate) mod tables;
