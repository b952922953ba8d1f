//! A height map with rings round single points of it.

use crate::draw::svg::{Figure, num};
use crate::figures::heights::heights as height_map;
use crate::figures::maps::map_size;
use contact_types::Grid;
use std::collections::BTreeMap;

/// Radius of the ring round one point, in units of the figure.
const RADIUS: f64 = 5.0;
/// Side of a square whose points share a ring, in units of the figure: so that very many points take no time.
const SQUARE: f64 = 5.0;
/// Widths of the light line of a ring and of the dark one outside it, in units of the figure.
const LINES: [f64; 2] = [1.4, 1.0];

/// A circle, in units of the figure.
#[derive(Debug, Clone, Copy, PartialEq)]
struct MapRing {
    /// `[x, y]`, down from the upper left corner of the map.
    centre: [f64; 2],
    radius: f64,
}

/// Rings that hold all `points` (indices into a grid of this `shape`) on a map of this `size` (units).
fn rings(points: &[usize], [ny, nx]: [usize; 2], [width, height]: [f64; 2]) -> Vec<MapRing> {
    // The box of the points in each square.
    let mut boxes: BTreeMap<[usize; 2], [f64; 4]> = BTreeMap::new();
    for point in points {
        let x = ((point % nx) as f64 + 0.5) / nx as f64 * width;
        let y = ((point / nx) as f64 + 0.5) / ny as f64 * height;
        boxes
            .entry([y, x].map(|s| (s / SQUARE) as usize))
            .and_modify(|[x0, y0, x1, y1]| {
                (*x0, *y0) = (x0.min(x), y0.min(y));
                (*x1, *y1) = (x1.max(x), y1.max(y));
            })
            .or_insert([x, y, x, y]);
    }
    let round = |[x0, y0, x1, y1]: [f64; 4]| MapRing {
        centre: [0.5 * (x0 + x1), 0.5 * (y0 + y1)],
        radius: RADIUS + 0.5 * (x1 - x0).hypot(y1 - y0),
    };
    boxes.into_values().map(round).collect()
}

/// The map of [`height_map`](crate::height_map) with a ring round each of `points`, indices into the grid row by
/// row. Rings that lie on one another have one outline.
///
/// # Errors
/// If the picture cannot be encoded.
///
/// # Panics
/// If `heights` are fewer than the points of the grid.
pub fn ring_points(
    heights: &[f64],
    grid: Grid,
    points: &[usize],
    limit: usize,
    key: &str,
) -> Result<Figure, png::EncodingError> {
    let mut figure = height_map(heights, grid, limit, key)?;
    let size = map_size(grid.size());
    let circles: String = rings(points, grid.shape(), size)
        .iter()
        .map(|MapRing { centre: [x, y], radius }| {
            format!("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>", num(*x), num(*y), num(*radius))
        })
        .collect();
    // The mask hides the inside of every ring and with it the lines of the others there. What is left of a line is
    // its outer half: light, then dark, so that no colour of the map hides both.
    let [light, dark] = [2.0 * LINES[0], 2.0 * (LINES[0] + LINES[1])];
    let margin = 4.0 * RADIUS;
    let [width, height] = size.map(|s| num(s + 2.0 * margin));
    let place = format!("x=\"-{0}\" y=\"-{0}\" width=\"{width}\" height=\"{height}\"", num(margin));
    figure.canvas.raw(&format!(
        "<mask id=\"{key}-m\" maskUnits=\"userSpaceOnUse\" {place}>\
         <rect {place} fill=\"#fff\"/><use href=\"#{key}-r\" fill=\"#000\"/></mask>\
         <g class=\"rings\" mask=\"url(#{key}-m)\" fill=\"none\" stroke=\"#fff\" stroke-width=\"{}\">\
         <use href=\"#{key}-r\" stroke=\"#111\" stroke-width=\"{}\"/><g id=\"{key}-r\">{circles}</g></g>",
        num(light),
        num(dark)
    ));
    figure.title = "Shaded height map with ringed points".into();
    figure.description = format!("{} Ringed points: {}.", figure.description, points.len());
    Ok(figure)
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
        let figure = ring_points(&heights, grid, points, limit, "k").unwrap();
        let body = figure.canvas.body();
        body[body.find("class=\"rings\"").unwrap()..].to_owned()
    }

    #[test]
    fn rings_lie_round_their_points_however_small_the_picture() {
        // The map is 340 units wide, 1.7 for each point.
        let points = [at(10, 20), at(0, 0), at(99, 199)];
        for limit in [1000, 200, 37] {
            let text = drawn(&points, limit);
            assert_eq!(text.matches("<circle").count(), 3, "{text}");
            for [x, y] in [["34.85", "17.85"], ["0.85", "0.85"], ["339.15", "169.15"]] {
                assert!(text.contains(&format!("cx=\"{x}\" cy=\"{y}\" r=\"5\"")), "{text}");
            }
        }
    }

    #[test]
    fn points_close_together_share_a_ring() {
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
        assert!(found.iter().all(|r| r.radius < 2.0 * RADIUS));
        for point in points {
            let [x, y] = [(point % 200) as f64 + 0.5, (point / 200) as f64 + 0.5].map(|s| 1.7 * s);
            let holds =
                |r: &MapRing| (x - r.centre[0]).hypot(y - r.centre[1]) < r.radius - 0.99 * RADIUS;
            assert!(found.iter().any(holds), "{x} {y}");
        }
    }
}
