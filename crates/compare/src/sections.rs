//! Which row of a map a section through the contact shows.

use contact_types::HeightMap;

/// Share of the points that counts as high: about what touches at a typical load.
const HIGH: f64 = 0.02;
/// Classes of height by which the high points are found.
const CLASSES: usize = 4096;

/// The row of the middle four fifths of a map that has the most high points, where contact is soonest and
/// longest seen; the first of several.
pub(crate) fn telling_row(map: &HeightMap) -> usize {
    let [ny, nx] = map.grid().shape();
    let (low, high) = map.range();
    if high <= low {
        return ny / 2;
    }
    let class = |h: f64| (((h - low) / (high - low) * CLASSES as f64) as usize).min(CLASSES - 1);
    let rows = ny / 10..ny - ny / 10;
    let middle = &map.heights()[rows.start * nx..rows.end * nx];
    let mut counts = vec![0_usize; CLASSES];
    for h in middle {
        counts[class(*h)] += 1;
    }
    let wanted = (HIGH * middle.len() as f64).ceil() as usize;
    let mut above = 0;
    let level = (0..CLASSES).rev().find(|k| {
        above += counts[*k];
        above >= wanted
    });
    let level = level.unwrap_or(0);
    let count = |row: usize| {
        let row = &map.heights()[row * nx..(row + 1) * nx];
        row.iter().filter(|h| class(**h) >= level).count()
    };
    rows.map(|row| (count(row), row))
        .max_by_key(|(count, row)| (*count, ny - row))
        .map_or(0, |m| m.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;

    #[test]
    fn the_row_crosses_the_most_summits_away_from_the_edges() {
        let grid = Grid::new([50, 60], [1e-6, 1e-6]).unwrap();
        let mut heights: Vec<f64> = (0..3000).map(|i| f64::from((i * 37) % 101) * 1e-9).collect();
        for x in 0..60 {
            heights[2 * 60 + x] = 3e-7; // too near the edge
        }
        for x in 10..35 {
            heights[31 * 60 + x] = 2e-7;
            heights[40 * 60 + x - 5] = if x < 15 { 0.0 } else { 2e-7 };
        }
        let map = HeightMap::new(grid, heights).unwrap();
        assert_eq!(telling_row(&map), 31);
        let flat = HeightMap::from_fn(grid, |_, _| 1.0).unwrap();
        assert_eq!(telling_row(&flat), 25);
        let line = Grid::new([1, 60], [1e-6, 1e-6]).unwrap();
        assert_eq!(telling_row(&HeightMap::from_fn(line, |_, x| x).unwrap()), 0);
    }
}
