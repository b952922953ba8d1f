//! `area.svg` and `pressure.svg`: the source paper's Figs. 1 and 2, one panel per surface, two of bodies that yield.

use crate::draw::svg::{COLUMN, Canvas, Figure, Text};
use crate::figures::curves::{self, Use};
use crate::lines::LoadLines;
use contact_compare::Comparison;
use std::io::{self, Write};

/// Real area over load as a file 85 mm wide: panels below each other, in two columns from four.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_area_svg(comparison: &Comparison, out: &mut impl Write) -> io::Result<()> {
    panels(comparison, "area", curves::area).write_standalone(out)
}

/// Real pressure over load, as [`write_area_svg`].
///
/// # Errors
/// Whatever the writer reports.
pub fn write_pressure_svg(comparison: &Comparison, out: &mut impl Write) -> io::Result<()> {
    panels(comparison, "pressure", curves::pressure).write_standalone(out)
}

fn panels(comparison: &Comparison, key: &str, draw: fn(&LoadLines, &str, Use) -> Figure) -> Figure {
    const NAME: f64 = 18.0;
    let panels = comparison.surfaces.iter().flat_map(|surface| {
        LoadLines::panels(surface).into_iter().map(|lines| (lines.named(surface), lines))
    });
    let figures: Vec<(String, Figure)> = panels
        .enumerate()
        .map(|(i, (name, lines))| (name, draw(&lines, &format!("{key}{i}"), Use::File)))
        .collect();
    if let [(_, one)] = figures.as_slice() {
        return one.clone();
    }
    let columns = if figures.len() > 3 { 2 } else { 1 };
    let height = figures.iter().map(|(_, f)| f.size[1]).fold(0.0, f64::max) + NAME;
    let mut canvas = Canvas::default();
    for (i, (name, figure)) in figures.iter().enumerate() {
        let (x, y) = ((i % columns) as f64 * COLUMN, (i / columns) as f64 * height);
        let letter = char::from(b'a' + (i % 26) as u8);
        let name = format!("({letter}) {name}");
        canvas.text(&Text { bold: true, ..Text::new([x + 10.0, y + 12.0], &name) });
        canvas.raw(&format!("<g transform=\"translate({x} {})\">", y + NAME));
        canvas.raw(figure.canvas.body());
        canvas.raw("</g>");
    }
    let rows = figures.len().div_ceil(columns).max(1);
    let described: Vec<String> =
        figures.iter().map(|(name, f)| format!("{name}: {}", f.description)).collect();
    canvas.figure(
        key,
        figures.first().map_or(String::new(), |(_, f)| f.title.clone()),
        described.join(" "),
        [columns as f64 * COLUMN, rows as f64 * height],
    )
}
