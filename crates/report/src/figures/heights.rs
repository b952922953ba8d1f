//! The height map: heights by colour with hill shading.

use super::maps::{Legend, Reduce, map_figure, picture, reduced, shading, whole};
use crate::draw::palette::{HEIGHT_RAMP, OkLab, ramp_table};
use crate::draw::png::Picture;
use crate::draw::svg::Figure;
use crate::numbers::{METRES, chosen, significant, unit_for};
use contact_types::Grid;

/// Depth of the hill shading in OKLab lightness.
const SHADE: f64 = 0.07;

/// The 0.1 and 99.9 percentiles, between which the height ramp runs.
fn percentiles(values: &[f64]) -> [f64; 2] {
    let mut left = values.to_vec();
    let place = |q: f64| ((values.len() - 1) as f64 * q).round() as usize;
    [0.001, 0.999].map(|q| *left.select_nth_unstable_by(place(q), f64::total_cmp).1)
}

/// A map as a picture of at most `limit` pixels along its longer side: heights by colour, lit from the upper left; the limits
/// of the ramp come back.
fn height_picture(heights: &[f64], grid: Grid, limit: usize) -> (Picture, [f64; 2]) {
    let (heights, shape) = reduced(heights, grid, whole(grid), limit, Reduce::Mean);
    let ramp = ramp_table::<256>(&HEIGHT_RAMP);
    let [lo, hi] = percentiles(&heights);
    let shade = shading(&heights, shape);
    let image = picture(shape, |i| {
        let t = if hi > lo { ((heights[i] - lo) / (hi - lo)).clamp(0.0, 1.0) } else { 0.5 };
        let OkLab(l, a, b) = ramp[(t * 255.0).round() as usize];
        OkLab((l + SHADE * shade[i]).clamp(0.0, 1.0), a, b)
    });
    (image, [lo, hi])
}

/// A map as a picture of at most `limit` pixels along its longer side: heights by colour, lit from the upper left.
pub fn thumbnail(heights: &[f64], grid: Grid, limit: usize) -> Picture {
    height_picture(heights, grid, limit).0
}

/// The picture of [`heights`], packed.
pub(crate) struct HeightPicture {
    address: String,
    /// Heights (m) between which the colours run.
    limits: [f64; 2],
}

impl HeightPicture {
    /// Of heights (m), of at most `limit` pixels along the longer side.
    pub(crate) fn of(
        heights: &[f64],
        grid: Grid,
        limit: usize,
    ) -> Result<Self, png::EncodingError> {
        let (image, limits) = height_picture(heights, grid, limit);
        Ok(Self { address: image.data_address()?, limits })
    }
}

/// Heights (m) of the whole map, with a bar of colours and one of length.
///
/// # Errors
/// If the picture cannot be encoded.
pub fn heights(
    heights: &[f64],
    grid: Grid,
    limit: usize,
    key: &str,
) -> Result<Figure, png::EncodingError> {
    Ok(height_figure(&HeightPicture::of(heights, grid, limit)?, grid, key))
}

/// The same around a picture that is packed already.
pub(crate) fn height_figure(picture: &HeightPicture, grid: Grid, key: &str) -> Figure {
    let [lo, hi] = picture.limits;
    let unit = unit_for(lo.abs().max(hi.abs()), METRES);
    let text = |v: f64| {
        let t = significant(v / unit.scale, 3);
        if v > 0.0 { format!("+{t}") } else { t }
    };
    let title = format!("Height above mean ({})", unit.name);
    let legend = Legend { low: text(lo), high: text(hi), title: &title, ramp: &HEIGHT_RAMP };
    let figure = map_figure(&picture.address, grid.size(), key, Some(&legend), None, false);
    Figure {
        title: "Shaded height map".into(),
        description: format!(
            "Height map, {} by {}, heights from {} to {} {} between the 0.1 and 99.9 percentiles.",
            chosen(grid.size()[1], METRES),
            chosen(grid.size()[0], METRES),
            legend.low,
            legend.high,
            unit.name
        ),
        ..figure
    }
}
