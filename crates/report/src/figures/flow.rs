//! The flow through the gap: its flux by colour, and the bottleneck.

use crate::draw::palette::{FLOW_RAMP, OkLab, ramp_table};
use crate::draw::svg::{Figure, num};
use crate::figures::maps::{
    Legend, Reduce, map_figure, map_size, picture, reduced, upper_end, whole,
};
use crate::numbers::{Unit, significant};
use contact_accuracy::Flow;
use contact_compare::pressure_top;
use contact_types::Grid;

/// Lightness where the bodies touch.
const CONTACT: f64 = 0.72;

/// The flux over its mean, dark where the bodies touch, a ring around the bottleneck.
pub(crate) fn flux(
    flow: &Flow,
    pressure: &[f64],
    grid: Grid,
    limit: usize,
    key: &str,
) -> Result<Figure, png::EncodingError> {
    let [ny, nx] = grid.shape();
    let (flux, shape) = reduced(&flow.flux, grid, whole(grid), limit, Reduce::Max);
    let touching: Vec<f64> = pressure.iter().map(|p| f64::from(u8::from(*p > 0.0))).collect();
    let (touching, _) = reduced(&touching, grid, whole(grid), limit, Reduce::Mean);
    let (top, clipped) = pressure_top(&flow.flux);
    let ramp = ramp_table::<256>(&FLOW_RAMP);
    let colour = |i: usize| {
        if flux[i] <= 0.0 && touching[i] > 0.5 {
            return OkLab(CONTACT, 0.0, 0.0);
        }
        ramp[((flux[i] / top).clamp(0.0, 1.0) * 255.0).round() as usize]
    };
    let address = picture(shape, colour).data_address()?;
    let high = upper_end(top, clipped, Unit { scale: 1.0, name: "" });
    let title = "Flux over its mean";
    let legend = Legend { low: "0".into(), high, title, ramp: &FLOW_RAMP };
    let mut figure = map_figure(&address, grid.size(), key, Some(&legend), None, false);
    let [width, height] = map_size(grid.size());
    let mut at = String::new();
    if let Some(bottleneck) = flow.bottleneck {
        let [row, column] = bottleneck.place;
        let [y, x] = [(row, ny, height), (column, nx, width)]
            .map(|(i, n, side)| num((i as f64 + 0.5) / n as f64 * side));
        for (colour, wide) in [("#fff", 4.0), ("#C01818", 1.8)] {
            figure.canvas.raw(&format!(
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"8\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{wide}\"/>"
            ));
        }
        at = format!(" Bottleneck in row {row}, column {column}.");
    }
    let most = significant(flow.flux.iter().copied().fold(0.0, f64::max), 2);
    figure.title = "Flow through the gap".into();
    figure.description = format!("Largest flux {most} times the mean.{at}");
    Ok(figure)
}
