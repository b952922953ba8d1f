//! The height map: heights by colour with hill shading, and rings round single points.

use super::maps::{averaged, colour_bar, map_canvas, map_size, picture, shading, with_legend};
use crate::draw::palette::{HEIGHT_RAMP, OkLab, ramp_table};
use crate::draw::svg::{Canvas, Figure, KEY, num};
use crate::numbers::{METRES, chosen, significant, unit_for};
use contact_types::Grid;
use std::collections::BTreeMap;

/// Depth of the hill shading in OKLab lightness.
const SHADE: f64 = 0.07;

/// Radius of the ring round one point, in units of the figure.
const RADIUS: f64 = 5.0;
/// Side of a square whose points share a ring, in units of the figure: so that very many points take no time.
const SQUARE: f64 = 5.0;
/// Widths of the light line of a ring and of the dark one outside it, in units of the figure.
const LINES: [f64; 2] = [1.4, 1.0];

/// A map as a picture (`data:image/png;base64,…`) of at most `limit` pixels along its longer side: heights by colour, lit
/// from the upper left; and the heights (m) between which its colours run.
pub fn height_picture(heights: &[f64], grid: Grid, limit: usize) -> (String, [f64; 2]) {
    let (heights, shape) = averaged(heights, grid.shape(), limit);
    let ramp = ramp_table::<256>(&HEIGHT_RAMP);
    // The ramp runs between these percentiles.
    let mut left = heights.clone();
    let place = |q: f64| ((heights.len() - 1) as f64 * q).round() as usize;
    let [lo, hi] = [0.001, 0.999].map(|q| *left.select_nth_unstable_by(place(q), f64::total_cmp).1);
    let shade = shading(&heights, shape);
    let image = picture(shape, |i| {
        let t = if hi > lo { ((heights[i] - lo) / (hi - lo)).clamp(0.0, 1.0) } else { 0.5 };
        let OkLab(l, a, b) = ramp[(t * 255.0).round() as usize];
        OkLab((l + SHADE * shade[i]).clamp(0.0, 1.0), a, b)
    });
    (image, [lo, hi])
}

/// Heights (m) of the whole map as an SVG element with a bar of colours, one of length, and a ring round each of
/// `points`, indices into the grid row by row. Rings that lie on one another have one outline.
///
/// # Panics
/// If `heights` are fewer than the points of the grid.
pub fn height_map(
    heights: &[f64],
    grid: Grid,
    points: &[usize],
    limit: usize,
    key: &str,
) -> String {
    figure(&height_picture(heights, grid, limit), grid, points).inline(key)
}

pub(crate) fn figure(
    (address, [lo, hi]): &(String, [f64; 2]),
    grid: Grid,
    points: &[usize],
) -> Figure {
    let unit = unit_for(lo.abs().max(hi.abs()), METRES);
    let [low, high] = [lo, hi].map(|v| {
        let text = significant(v / unit.scale, 3);
        if *v > 0.0 { format!("+{text}") } else { text }
    });
    let title = format!("Height above mean ({})", unit.name);
    let mut canvas = map_canvas(address, grid.size(), "");
    colour_bar(&mut canvas, grid.size(), [&low, &high, &title], &HEIGHT_RAMP);
    let [height, width] = grid.size().map(|side| chosen(side, METRES));
    let description = format!(
        "Height map, {width} by {height}, heights from {low} to {high} {} between the 0.1 and 99.9 percentiles.",
        unit.name
    );
    let size = with_legend(grid.size());
    if points.is_empty() {
        return canvas.figure("Shaded height map", description, size);
    }
    draw_rings(&mut canvas, points, grid);
    let description = format!("{description} Ringed points: {}.", points.len());
    canvas.figure("Shaded height map with ringed points", description, size)
}

/// Centre `[x, y]`, down from the upper left corner of the map, and radius of rings that hold all `points` (indices
/// into a grid of this shape) on a map of this size; all in units.
fn rings(
    points: &[usize],
    [ny, nx]: [usize; 2],
    [width, height]: [f64; 2],
) -> Vec<([f64; 2], f64)> {
    // The box of the points in each square.
    let mut boxes: BTreeMap<[usize; 2], [f64; 4]> = BTreeMap::new();
    for point in points {
        let x = ((point % nx) as f64 + 0.5) / nx as f64 * width;
        let y = ((point / nx) as f64 + 0.5) / ny as f64 * height;
        let square = [y, x].map(|s| (s / SQUARE) as usize);
        let [x0, y0, x1, y1] = boxes.entry(square).or_insert([x, y, x, y]);
        (*x0, *y0, *x1, *y1) = (x0.min(x), y0.min(y), x1.max(x), y1.max(y));
    }
    let round = |[x0, y0, x1, y1]: [f64; 4]| {
        ([0.5 * (x0 + x1), 0.5 * (y0 + y1)], RADIUS + 0.5 * (x1 - x0).hypot(y1 - y0))
    };
    boxes.into_values().map(round).collect()
}

fn draw_rings(canvas: &mut Canvas, points: &[usize], grid: Grid) {
    let size = map_size(grid.size());
    let circle = |([x, y], r): ([f64; 2], f64)| {
        let [x, y, r] = [x, y, r].map(num);
        format!(r#"<circle cx="{x}" cy="{y}" r="{r}"/>"#)
    };
    let circles: String = rings(points, grid.shape(), size).into_iter().map(circle).collect();
    // The mask hides the inside of every ring and with it the lines of the others there. What is left of a line is
    // its outer half: light, then dark, so that no colour of the map hides both.
    let [light, dark] = [2.0 * LINES[0], 2.0 * (LINES[0] + LINES[1])].map(num);
    let margin = 4.0 * RADIUS;
    let ([width, height], margin) = (size.map(|s| num(s + 2.0 * margin)), num(margin));
    let place = format!(r#"x="-{margin}" y="-{margin}" width="{width}" height="{height}""#);
    canvas.raw(&format!(
        r##"<mask id="{KEY}-m" maskUnits="userSpaceOnUse" {place}><rect {place} fill="#fff"/><use href="#{KEY}-r" fill="#000"/></mask><g class="rings" mask="url(#{KEY}-m)" fill="none" stroke="#fff" stroke-width="{light}"><use href="#{KEY}-r" stroke="#111" stroke-width="{dark}"/><g id="{KEY}-r">{circles}</g></g>"##
    ));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Row `y`, column `x` of a grid with 200 columns.
    const fn at(y: usize, x: usize) -> usize {
        y * 200 + x
    }

    fn drawn(points: &[usize], limit: usize) -> String {
        let grid = Grid::new([100, 200], [1e-6, 1e-6]).unwrap();
        let heights: Vec<f64> = (0..20_000).map(|i| f64::from(i % 7)).collect();
        let figure = height_map(&heights, grid, points, limit, "k");
        figure[figure.find("class=\"rings\"").unwrap()..].to_owned()
    }

    #[test]
    fn rings_lie_round_their_points_however_small_the_picture() {
        // The map is 340 units wide, 1.7 for each point.
        let points = [at(10, 20), at(0, 0), at(99, 199)];
        for limit in [1000, 37] {
            let text = drawn(&points, limit);
            assert_eq!(text.matches("<circle").count(), 3, "{text}");
            for [x, y] in [["34.85", "17.85"], ["0.85", "0.85"], ["339.15", "169.15"]] {
                assert!(text.contains(&format!("cx=\"{x}\" cy=\"{y}\" r=\"5\"")), "{text}");
            }
        }
        // Side by side, 1.7 units; apart by 4 columns, 6.8 units; and twice the same.
        let side_by_side = drawn(&[at(50, 101), at(50, 102)], 200);
        assert_eq!(side_by_side.matches("<circle").count(), 1, "{side_by_side}");
        assert!(side_by_side.contains("cx=\"173.4\" cy=\"85.85\" r=\"5.85\""), "{side_by_side}");
        assert_eq!(drawn(&[at(50, 100), at(50, 104)], 200).matches("<circle").count(), 2);
        assert_eq!(drawn(&[at(50, 100), at(50, 100)], 200).matches("<circle").count(), 1);
    }

    #[test]
    fn any_number_of_points_takes_few_rings_that_hold_them_all() {
        let points: Vec<usize> = (0..20_000).collect();
        let found = rings(&points, [100, 200], [340.0, 170.0]);
        assert_eq!(found.len(), 68 * 34);
        assert!(found.iter().all(|(_, radius)| *radius < 2.0 * RADIUS));
        for point in points {
            let [x, y] = [(point % 200) as f64 + 0.5, (point / 200) as f64 + 0.5].map(|s| 1.7 * s);
            let holds = |(c, r): &([f64; 2], f64)| (x - c[0]).hypot(y - c[1]) < r - 0.99 * RADIUS;
            assert!(found.iter().any(holds), "{x} {y}");
        }
    }
}
