#![doc = include_str!("../README.md")]
#![allow(
    clippy::format_collect,
    clippy::format_push_string,
    reason = "a page is text put together from pieces, once"
)]

mod csv;
mod digest;
mod documents;
mod draw;
mod figures;
mod json;
mod lines;
mod messages;
pub mod numbers;
mod page;
mod parts_json;
mod plot_styles;
mod provenance;
mod table_csv;

pub use contact_compare as compare; // whose results are written here

pub use digest::digest;
pub use documents::{documents, profile_documents};
pub use figures::cost::{CostFigure, CostSeries};
pub use figures::heights::{height_map, height_picture};
pub use figures::maps::pressures as pressure_picture;
pub use json::{
    accuracy as accuracy_json, cleaning as cleaning_json, comparison as comparison_json,
    findings as findings_json, profile_comparison as profile_comparison_json,
    profile_statistics as profile_statistics_json, statistics as statistics_json,
    unevenness as unevenness_json,
};
pub use lines::{Reference, references};
pub use messages::conduction::{joint_words, resistances};
pub use messages::finding::finding;
pub use messages::leak::leak_notes;
pub use messages::loads::loads_line;
pub use messages::materials::{material_in_full, material_json, material_line, materials_json};
pub use messages::pair::{bodies_line, pair_lines};
pub use messages::plan::{explanation as plan_explanation, reason as plan_reason};
pub use messages::profile::profile_headline;
pub use messages::{headline_line, surface_lines};
pub use page::html::style;
pub use page::profile::setting_words;
pub use page::summary::{Summary, summary_html};
pub use parts_json::{
    bodies_json, conducted_keys, gas_json, leak_json, leak_point_json, pair_json, solution_keys,
};
pub use provenance::Provenance;
pub use table_csv::write as write_table_csv;
