//! The flow through the gap: its flux by colour, and the bottleneck.

use crate::draw::palette::{FLOW_RAMP, OkLab, ramp_table};
use crate::draw::svg::{Figure, num};
use crate::figures::maps::{
    averaged, colour_bar, combined, map_canvas, map_figure, map_size, picture, upper_end,
};
use crate::numbers::{Unit, significant};
use contact_accuracy::Flow;
use contact_compare::pressure_top;
use contact_types::Grid;

/// Lightness where the bodies touch.
const CONTACT: f64 = 0.72;

/// The flux over its mean, dark where the bodies touch, a ring around the bottleneck.
pub(crate) fn flux(flow: &Flow, pressure: &[f64], grid: Grid, limit: usize, key: &str) -> Figure {
    let ([ny, nx], size) = (grid.shape(), grid.size());
    let touching: Vec<f64> = pressure.iter().map(|p| f64::from(u8::from(*p > 0.0))).collect();
    let (touching, shape) = averaged(&touching, grid.shape(), limit);
    let flux = combined(&flow.flux, grid.shape(), shape, f64::max);
    let (top, clipped) = pressure_top(&flow.flux);
    let ramp = ramp_table::<256>(&FLOW_RAMP);
    let address = picture(shape, |i| match flux[i] {
        f if f <= 0.0 && touching[i] > 0.5 => OkLab(CONTACT, 0.0, 0.0),
        f => ramp[((f / top).clamp(0.0, 1.0) * 255.0).round() as usize],
    });
    let high = upper_end(top, clipped, Unit { scale: 1.0, name: "" });
    let mut canvas = map_canvas(&address, size, "");
    colour_bar(&mut canvas, size, ["0", &high, "Flux over its mean"], &FLOW_RAMP, key);
    let [width, height] = map_size(size);
    let mut at = String::new();
    if let Some(bottleneck) = flow.bottleneck {
        let [row, column] = bottleneck.place;
        let [y, x] = [(row, ny, height), (column, nx, width)]
            .map(|(i, n, side)| num((i as f64 + 0.5) / n as f64 * side));
        for (colour, wide) in [("#fff", 4.0), ("#C01818", 1.8)] {
            canvas.raw(&format!(
                r#"<circle cx="{x}" cy="{y}" r="8" fill="none" stroke="{colour}" stroke-width="{wide}"/>"#
            ));
        }
        at = format!(" Bottleneck in row {row}, column {column}.");
    }
    let most = significant(flow.flux.iter().copied().fold(0.0, f64::max), 2);
    let description = format!("Largest flux {most} times the mean.{at}");
    map_figure(canvas, size, key, "Flow through the gap", description)
}
