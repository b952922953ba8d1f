//! Phrases that several sections use.

use crate::numbers::{
    METRES, NEWTONS, PASCALS, SPACE, chosen, percent, power_of_ten, quantity, significant, unit_for,
};
use contact_compare::{Sections, SurfaceComparison};

/// What was done to the form of the map.
pub(crate) fn levelled(surface: &SurfaceComparison) -> &'static str {
    match surface.statistics.level {
        // Statistics say what was chosen.
        surface_stats::Level::Plane | surface_stats::Level::Auto => "least-squares plane removed",
        surface_stats::Level::Quadratic => "least-squares paraboloid removed",
        surface_stats::Level::Mean => "mean removed",
        _ if surface.origin.cleaned().is_empty() => "as given",
        _ => "cleaned, not levelled",
    }
}

/// A tolerance, as a power of ten if it is one.
pub(crate) fn tolerance_words(tolerance: f64) -> String {
    let e = tolerance.log10();
    if (e - e.round()).abs() < 1e-9 {
        power_of_ten(e.round() as i32)
    } else {
        significant(tolerance, 2)
    }
}

/// Load on the whole map (N), "10 MPa × 0.262 mm²".
pub(crate) fn load_words(surface: &SurfaceComparison) -> (String, String) {
    let area = surface.nominal_area();
    let force = surface.headline_pressure() * area;
    let side = unit_for(area.sqrt(), METRES);
    (
        quantity(force, NEWTONS, 3),
        format!(
            "{} × {}{SPACE}{}²",
            chosen(surface.headline_pressure(), PASCALS),
            significant(area / side.scale.powi(2), 3),
            side.name
        ),
    )
}

/// How much of the row touches at each load, as the caption says it.
pub(crate) fn touching(surface: &SurfaceComparison) -> Vec<String> {
    let Some(Sections { pressure, .. }) = &surface.sections else { return Vec::new() };
    let share =
        |row: &Vec<f64>| row.iter().filter(|p| **p > 0.0).count() as f64 / row.len().max(1) as f64;
    pressure.iter().map(|row| percent(share(row))).collect()
}

/// JSON inside an attribute in single quotes.
pub(crate) fn attribute(data: &serde_json::Value) -> String {
    data.to_string().replace('&', "&amp;").replace('\'', "&#39;").replace('<', "&lt;")
}

/// A table of a name, its value and a note in each row; the caption may be empty.
pub(crate) fn key_table(caption: &str, rows: &[[String; 3]]) -> String {
    let caption = match caption {
        "" => String::new(),
        words => format!("<caption>{words}</caption>"),
    };
    let row = |[name, value, why]: &[String; 3]| {
        format!(
            "<tr><th scope=\"row\">{name}</th><td class=\"n\">{value}</td><td class=\"why\">{why}</td></tr>\n"
        )
    };
    let rows: String = rows.iter().map(row).collect();
    format!("<table class=\"key\">{caption}<tbody>\n{rows}</tbody></table>\n")
}

/// A list of terms, each with what is said of it.
pub(crate) fn terms(rows: &[(String, String)]) -> String {
    let row = |(term, text): &(String, String)| format!("<dt>{term}</dt><dd>{text}</dd>\n");
    format!("<dl>{}</dl>\n", rows.iter().map(row).collect::<String>())
}

/// " Downsampled to 640 × 640."
pub(crate) fn reduced_words([ny, nx]: [usize; 2], limit: usize) -> String {
    if ny.max(nx) <= limit {
        return String::new();
    }
    let factor = ny.max(nx) as f64 / limit as f64;
    let side = |n: usize| (n as f64 / factor).round().max(1.0);
    format!(" Downsampled to {} × {}.", side(nx), side(ny))
}
