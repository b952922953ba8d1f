//! Pictures of fields on a map: contact pressure over grey relief, flow through the gap, and the frame of every map.

use crate::draw::axes::round_step;
use crate::draw::palette::{FLOW_RAMP, INK, INK2, LINE, OkLab, PRESSURE_RAMP, ramp_table};
use crate::draw::png;
use crate::draw::svg::{COLUMN, Canvas, Figure, KEY, Text, num, text_width};
use crate::numbers::{METRES, PASCALS, Unit, chosen, significant, unit_for};
use contact_accuracy::Flow;
use contact_compare::{PressureMaps, SurfaceComparison, pressure_top};
use contact_types::Grid;
use grid_fft::parallel::join;
use std::borrow::Cow;

/// Lightness of the relief where nothing touches, and its depth.
const RELIEF: (f64, f64) = (0.965, 0.022);
/// Height of the colour bar and its texts below a map.
const LEGEND: f64 = 34.0;

/// Lightness of the flow where the bodies touch.
const CONTACT: f64 = 0.72;

/// Steps of a scale of pressures that the eye takes for none.
pub(crate) const FEWEST_STEPS: u8 = 31;

/// A rectangular part `[y0, x0, ny, nx]` of a grid.
pub(crate) type MapPart = [usize; 4];

pub(super) fn cut(field: &[f64], grid: Grid, [y0, x0, ny, nx]: MapPart) -> Cow<'_, [f64]> {
    let all = grid.shape()[1];
    if nx == all {
        return Cow::Borrowed(&field[y0 * nx..(y0 + ny) * nx]);
    }
    let rows = field.chunks_exact(all).skip(y0).take(ny);
    rows.flat_map(|row| &row[x0..x0 + nx]).copied().collect()
}

/// The shape of at most `limit` pixels along the longer side.
pub(crate) fn limited([ny, nx]: [usize; 2], limit: usize) -> [usize; 2] {
    let factor = (ny.max(nx) as f64 / limit.max(1) as f64).max(1.0);
    [ny, nx].map(|n| ((n as f64 / factor).round() as usize).max(1))
}

/// Mean over what each of at most `limit` pixels along the longer side covers, the ends in part: heights.
pub(crate) fn averaged(
    field: &[f64],
    [ny, nx]: [usize; 2],
    limit: usize,
) -> (Vec<f64>, [usize; 2]) {
    let shape = limited([ny, nx], limit);
    let mut out = Vec::with_capacity(shape[0] * shape[1]);
    // New pixel j covers old pixels [j n/m, (j+1) n/m), the ends in part.
    let span = |j: usize, n: usize, m: usize| -> Vec<(usize, f64)> {
        let (a, b) = (j as f64 * n as f64 / m as f64, (j + 1) as f64 * n as f64 / m as f64);
        let last = (b.ceil() as usize).clamp(1, n);
        let part = |i: usize| (i, (b.min((i + 1) as f64) - a.max(i as f64)).max(0.0));
        (a.floor() as usize..last).map(part).collect()
    };
    let columns: Vec<_> = (0..shape[1]).map(|jx| span(jx, nx, shape[1])).collect();
    for jy in 0..shape[0] {
        let rows = span(jy, ny, shape[0]);
        for columns in &columns {
            let (mut sum, mut weight) = (0.0, 0.0);
            for &(iy, wy) in &rows {
                for &(ix, wx) in columns {
                    sum += wy * wx * field[iy * nx + ix];
                    weight += wy * wx;
                }
            }
            out.push(sum / weight);
        }
    }
    (out, shape)
}

/// One value for the points that each dot covers, such as the highest, so that no small contact is lost; where a dot is less
/// than a point wide, two share it.
pub(crate) fn combined<T: Copy>(
    field: &[T],
    [ny, nx]: [usize; 2],
    small: [usize; 2],
    both: impl Fn(T, T) -> T,
) -> Vec<T> {
    let span = |j: usize, n: usize, m: usize| j * n / m..((j + 1) * n).div_ceil(m);
    let dot = |y: usize, x: usize| {
        let rows = span(y, ny, small[0]).map(|iy| &field[iy * nx..][span(x, nx, small[1])]);
        rows.flatten().copied().reduce(&both).expect("a dot covers a point")
    };
    (0..small[0] * small[1]).map(|i| dot(i / small[1], i % small[1])).collect()
}

/// Slope towards the light in the upper left, scaled so that two standard deviations are 1.
pub(super) fn shading(heights: &[f64], [ny, nx]: [usize; 2]) -> Vec<f64> {
    let at = |y: usize, x: usize| heights[y * nx + x];
    let steep = |i: usize| {
        let (y, x) = (i / nx, i % nx);
        let across = at(y, (x + 1).min(nx - 1)) - at(y, x.saturating_sub(1));
        let down = at((y + 1).min(ny - 1), x) - at(y.saturating_sub(1), x);
        across + down
    };
    let slope: Vec<f64> = (0..ny * nx).map(steep).collect();
    let rms = (slope.iter().map(|s| s * s).sum::<f64>() / slope.len() as f64).sqrt();
    if rms > 0.0 {
        slope.iter().map(|s| (s / (2.0 * rms)).clamp(-1.0, 1.0)).collect()
    } else {
        slope
    }
}

/// The address of a picture whose pixels have these colours.
pub(super) fn picture([ny, nx]: [usize; 2], colour: impl Fn(usize) -> OkLab) -> String {
    let bytes: Vec<u8> = (0..ny * nx).flat_map(|i| colour(i).to_rgb()).collect();
    png::shades([ny, nx], &bytes)
}

/// Pressure by colour from 0 to `top`; where nothing touches, the relief in faint grey.
fn contact_picture(pressure: &[f64], heights: &[f64], shape: [usize; 2], top: f64) -> String {
    let ramp = ramp_table::<256>(&PRESSURE_RAMP);
    let shade = shading(heights, shape);
    picture(shape, |i| match pressure[i] {
        p if p > 0.0 => ramp[((p / top).clamp(0.0, 1.0) * 255.0).round() as usize],
        _ => faint(shade[i]),
    })
}

fn faint(shade: f64) -> OkLab {
    OkLab(RELIEF.0 + RELIEF.1 * shade, 0.0, 0.0)
}

/// The pressure of a load of a study as a picture (`data:image/png;base64,…`): by colour, grey where nothing touches;
/// `None` of a load that is not there.
pub fn pressures(maps: &PressureMaps, load: usize) -> Option<String> {
    let classes = &maps.loads.get(load)?.classes;
    let ramp = ramp_table::<256>(&PRESSURE_RAMP);
    Some(picture(maps.shape, |i| match classes[i] {
        0 => faint(0.0),
        class => ramp[usize::from(class)],
    }))
}

/// A part of the surface in faint grey, as [`contact`] shows it where nothing touches.
pub(crate) fn relief(heights: &[f64], grid: Grid, window: MapPart, limit: usize) -> String {
    let [_, _, ny, nx] = window;
    let (small, shape) = averaged(&cut(heights, grid, window), [ny, nx], limit);
    let shade = shading(&small, shape);
    png::shades(shape, &shade.iter().map(|s| faint(*s).to_rgb()[0]).collect::<Vec<u8>>())
}

/// Width and height of a map in units: as wide as the column, no taller than wide.
pub(super) fn map_size([height, width]: [f64; 2]) -> [f64; 2] {
    let scale = (COLUMN / width).min(COLUMN / height);
    [(width * scale).max(8.0), (height * scale).max(8.0)]
}

/// The contact at one load: pressure by colour, the surface in grey, and what is shown elsewhere: the part that
/// [`enlarged`] shows, and the row of the section.
pub(crate) fn contact(
    surface: &SurfaceComparison,
    (window, row): (Option<MapPart>, Option<usize>),
    limit: usize,
) -> Figure {
    let (map, pressure) = (surface.solved_map(), &surface.pressure);
    let (grid, heights) = (map.grid(), map.heights());
    let shape = limited(grid.shape(), limit);
    let (h, p) = join(
        || averaged(heights, grid.shape(), limit).0,
        || combined(pressure, grid.shape(), shape, f64::max),
    );
    let (top, clipped) = pressure_top(pressure);
    let unit = unit_for(top, PASCALS);
    let mut canvas = map_canvas(&contact_picture(&p, &h, shape, top), grid.size(), "");
    mark(&mut canvas, grid.size(), grid.shape(), window, row);
    let (title, high) = (format!("Local pressure ({})", unit.name), upper_end(top, clipped, unit));
    colour_bar(&mut canvas, grid.size(), ["0", &high, &title], &PRESSURE_RAMP);
    let touching = pressure.iter().filter(|p| **p > 0.0).count();
    let highest = pressure.iter().copied().fold(0.0, f64::max) / unit.scale;
    let (all, highest, unit) = (grid.len(), significant(highest, 2), unit.name);
    let description =
        format!("{touching} of {all} points of the map carry pressure; highest {highest} {unit}.");
    canvas.figure("Contact map", description, with_legend(grid.size()))
}

pub(crate) fn upper_end(top: f64, clipped: bool, unit: Unit) -> String {
    let high = significant(top / unit.scale, 2);
    if clipped { format!("≥{high}") } else { high }
}

/// The window of the contact map, one square per point of the grid.
pub(crate) fn enlarged(surface: &SurfaceComparison, window: MapPart, row: Option<usize>) -> Figure {
    let ([y0, _, ny, nx], map) = (window, surface.solved_map());
    let grid = map.grid();
    let [p, h] = [&surface.pressure[..], map.heights()].map(|field| cut(field, grid, window));
    let (top, _) = pressure_top(&surface.pressure);
    let [dy, dx] = grid.pixel();
    let size = [ny as f64 * dy, nx as f64 * dx];
    let squares = " style=\"image-rendering:pixelated\"";
    let mut canvas = map_canvas(&contact_picture(&p, &h, [ny, nx], top), size, squares);
    let inside = row.filter(|row| (y0..y0 + ny).contains(row)).map(|row| row - y0);
    mark(&mut canvas, size, [ny, nx], None, inside);
    let [height, width] = size.map(|side| chosen(side, METRES));
    let description = format!("{width} by {height} of the contact map, one square per point.");
    canvas.figure("Enlargement of the boxed area", description, with_legend(size))
}

/// The flux over its mean, dark where the bodies touch, a ring around the bottleneck.
pub(crate) fn flux(flow: &Flow, pressure: &[f64], grid: Grid, limit: usize) -> Figure {
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
    colour_bar(&mut canvas, size, ["0", &high, "Flux over its mean"], &FLOW_RAMP);
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
    canvas.figure("Flow through the gap", description, with_legend(size))
}

/// A map of this size (m) around the picture at this address.
pub(super) fn map_canvas(address: &str, size: [f64; 2], extra: &str) -> Canvas {
    let [width, height] = map_size(size);
    let mut canvas = Canvas::default();
    let ([w, h], [inner_w, inner_h]) =
        ([width, height].map(num), [width - 0.6, height - 0.6].map(num));
    let line = LINE.light;
    canvas.raw(&format!(
        r#"<image class="px" href="{address}" x="0" y="0" width="{w}" height="{h}" preserveAspectRatio="none"{extra}/><rect x=".3" y=".3" width="{inner_w}" height="{inner_h}" fill="none" class="s-line" stroke="{line}" stroke-width=".6"/>"#
    ));
    scale_bar(&mut canvas, [width, height], size[1]);
    canvas
}

/// Width and height of a map of this size (m) with its bar of colours.
pub(super) fn with_legend(size: [f64; 2]) -> [f64; 2] {
    [COLUMN, map_size(size)[1] + LEGEND]
}

/// A dashed line along a row, and a box around a part of a map of this size (m) and shape.
fn mark(
    canvas: &mut Canvas,
    size: [f64; 2],
    [rows, columns]: [usize; 2],
    window: Option<MapPart>,
    row: Option<usize>,
) {
    let [width, height] = map_size(size);
    let x = |points: usize| num(points as f64 / columns as f64 * width);
    let y = |points: usize| num(points as f64 / rows as f64 * height);
    if let Some(row) = row {
        let (y, right) = (num((row as f64 + 0.5) / rows as f64 * height), num(width));
        canvas.raw(&format!(
            r##"<line x1="0" y1="{y}" x2="{right}" y2="{y}" stroke="#111" stroke-width=".8" stroke-dasharray="4 3"/>"##
        ));
    }
    if let Some([y0, x0, ny, nx]) = window {
        let (left, top, wide, high) = (x(x0), y(y0), x(nx), y(ny));
        canvas.raw(&format!(
            r##"<rect x="{left}" y="{top}" width="{wide}" height="{high}" fill="none" stroke="#111"/>"##
        ));
    }
}

/// A bar of round length, at most a third of the width, on a light ground.
fn scale_bar(canvas: &mut Canvas, [width, height]: [f64; 2], metres: f64) {
    if height < 40.0 || width < 80.0 {
        return;
    }
    let step = round_step(metres / 3.0);
    let length = if step > metres / 3.0 { round_step(metres / 7.5) } else { step };
    let bar = length / metres * width;
    let text = chosen(length, METRES);
    let wide = bar.max(text_width(&text, 10.0, false)) + 12.0;
    let (left, top) = (width - wide - 6.0, height - 28.0);
    let middle = left + wide / 2.0;
    let [left, wide, from, bar, middle] = [left, wide, middle - bar / 2.0, bar, middle].map(num);
    let [top, bar_top, base] = [top, top + 16.0, top + 12.0].map(num);
    canvas.raw(&format!(
        r##"<rect x="{left}" y="{top}" width="{wide}" height="22" fill="#fff" fill-opacity=".86"/><rect x="{from}" y="{bar_top}" width="{bar}" height="2.4" fill="#111"/><text x="{middle}" y="{base}" text-anchor="middle" fill="#111">{text}</text>"##
    ));
}

/// The colours below a map of this size (m) with lowest and highest number, and what they are.
pub(super) fn colour_bar(
    canvas: &mut Canvas,
    size: [f64; 2],
    [low, high, title]: [&str; 3],
    ramp: &[u32; 9],
) {
    const WIDTH: f64 = 130.0;
    let top = map_size(size)[1] + 9.0;
    let stop = |(i, c): (usize, OkLab)| {
        let (at, colour) = (num(i as f64 / 16.0), c.hex());
        format!(r##"<stop offset="{at}" stop-color="#{colour}"/>"##)
    };
    let stops: String = ramp_table::<17>(ramp).into_iter().enumerate().map(stop).collect();
    let y = num(top);
    canvas.group(r#"class="legend""#, |canvas| {
        canvas.raw(&format!(
            r#"<defs><linearGradient id="{KEY}-g">{stops}</linearGradient></defs><rect class="px" x="0" y="{y}" width="{WIDTH}" height="8" fill="url(#{KEY}-g)"/>"#
        ));
        canvas.text(&Text::start([0.0, top + 19.0], low, INK2));
        canvas.text(&Text::end([WIDTH, top + 19.0], high, INK2));
        canvas.text(&Text::start([WIDTH + 8.0, top + 8.0], title, INK));
    });
}

/// The square of about a sixth of the map (at least 32 points) that carries the most contact
/// points without being full of them; `None` if nothing or everything touches, or the map is
/// small enough to be seen whole.
pub(crate) fn busiest_window(pressure: &[f64], [ny, nx]: [usize; 2]) -> Option<MapPart> {
    let side = (ny.min(nx) / 6).clamp(32, 128);
    if ny.min(nx) < 2 * side {
        return None;
    }
    // Summed-area table of contact points.
    let stride = nx + 1;
    let mut sums = vec![0_u32; (ny + 1) * stride];
    for y in 0..ny {
        let mut row = 0;
        for x in 0..nx {
            row += u32::from(pressure[y * nx + x] > 0.0);
            sums[(y + 1) * stride + x + 1] = sums[y * stride + x + 1] + row;
        }
    }
    let half = (side * side / 2) as u32;
    let mut best: Option<(u32, MapPart)> = None;
    for y in (0..=ny - side).step_by(side / 4) {
        for x in (0..=nx - side).step_by(side / 4) {
            let [top, bottom] = [y * stride + x, (y + side) * stride + x];
            let found = sums[bottom + side] + sums[top] - sums[top + side] - sums[bottom];
            let score = if found <= half { found } else { (2 * half).saturating_sub(found) };
            if score > best.map_or(0, |(s, _)| s) {
                best = Some((score, [y, x, side, side]));
            }
        }
    }
    best.map(|(_, window)| window)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reduction_keeps_the_mean_and_the_highest_point() {
        let field: Vec<f64> = (0..70).map(|i| f64::from((i * 37) % 71)).collect();
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let (small, shape) = averaged(&field, [7, 10], 5);
        assert_eq!(shape, [4, 5]);
        assert!((mean(&small) - mean(&field)).abs() < 1e-9);
        let top = |v: &[f64]| v.iter().copied().fold(0.0, f64::max);
        let peaks = combined(&field, [7, 10], shape, f64::max);
        assert!((top(&peaks) - top(&field)).abs() < 1e-12);
        let grid = Grid::new([7, 10], [1.0, 1.0]).unwrap();
        assert_eq!(*cut(&field, grid, [2, 3, 2, 3]), [23, 24, 25, 33, 34, 35].map(|i| field[i]));
        assert_eq!(averaged(&field, [7, 10], 64), (field, [7, 10]));
    }

    #[test]
    fn the_window_goes_where_contact_is() {
        let mut pressure = vec![0.0; 200 * 200];
        for y in 150..160 {
            for x in 20..30 {
                pressure[y * 200 + x] = 1.0;
            }
        }
        let [y0, x0, ny, nx] = busiest_window(&pressure, [200, 200]).unwrap();
        assert!(y0 <= 150 && y0 + ny >= 160 && x0 <= 20 && x0 + nx >= 30);
        assert!(busiest_window(&vec![0.0; 200 * 200], [200, 200]).is_none());
        assert!(busiest_window(&pressure[..100], [10, 10]).is_none());
    }
}
