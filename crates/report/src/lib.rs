#![doc = include_str!("../README.md")]
#![allow(
    clippy::format_collect,
    clippy::format_push_string,
    reason = "a page is text put together from pieces, once"
)]

mod conduction_json;
mod csv;
mod digest;
mod draw;
mod error;
mod figures;
mod json;
mod leak_json;
mod lines;
mod messages;
pub mod numbers;
mod page;
mod pair_json;
mod plot_styles;
mod point_json;
mod profile_json;
mod provenance;
mod sources;
mod table_csv;

pub use contact_compare as compare; // whose results are written here

pub use conduction_json::{gas as gas_json, keys as conducted_keys};
pub use csv::{
    write as write_csv, write_profiles as write_profile_csv, write_spots as write_spots_csv,
};
pub use digest::digest;
pub use draw::{palette::Style, png::Picture, svg::Figure};
pub use error::ReportError;
pub use figures::cost_plot::{CostLabel, CostPlot};
pub use figures::heights::{heights as height_map, thumbnail};
pub use figures::maps::pressures as pressure_picture;
pub use figures::panels::{write_area_svg, write_pressure_svg};
pub use figures::profiles::{
    write_area_svg as write_profile_area_svg, write_trace_svg as write_profile_trace_svg,
};
pub use figures::rings::ring_points;
pub use json::{
    accuracy as accuracy_json, cleaning as cleaning_json, comparison as comparison_json,
    findings as findings_json, statistics as statistics_json, surface as surface_json,
    write as write_json,
};
pub use leak_json::{leak as leak_json, point as leak_point_json};
pub use lines::{Reference, references};
pub use messages::conduction::{ResistanceWords, joint_words, resistance_lines, resistances};
pub use messages::finding::finding;
pub use messages::headline_line;
pub use messages::leak::leak_notes;
pub use messages::loads::loads_line;
pub use messages::materials::{material_in_full, material_json, material_line, materials_json};
pub use messages::pair::{bodies_line, pair_lines};
pub use messages::plan::{explanation as plan_explanation, reason as plan_reason};
pub use messages::profile::profile_headline;
pub use messages::yielding::elastic_line;
pub use page::html::{style, write as write_html};
pub use page::profile::write as write_profile_html;
pub use page::profile_tables::setting_words;
pub use page::summary::{Summary, write as write_summary_html};
pub use pair_json::{bodies as bodies_json, pair as pair_json};
pub use plot_styles::plot_style;
pub use point_json::{YIELD_KEYS, budget_keys, yield_keys};
pub use profile_json::{
    profile_comparison as profile_comparison_json, profile_statistics as profile_statistics_json,
    unevenness as unevenness_json,
};
pub use provenance::Provenance;
pub use table_csv::write as write_table_csv;
