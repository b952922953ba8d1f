//! Whether the opposite edges of a map meet.

use crate::differences::{add, mean};
use contact_types::HeightMap;

/// Jump across the seam over those inside up to which a map counts as one that repeats.
pub(crate) const MOST_SEAM_JUMP: f64 = 2.0;

/// Whether opposite edges meet: the jump across them is of the size of those inside.
pub fn repeats(map: &HeightMap) -> bool {
    seam_jump(map) <= MOST_SEAM_JUMP
}

/// Rms jump between opposite edges over that between neighbours inside, the larger of the two
/// axes; 0 for a flat map.
pub fn seam_jump(map: &HeightMap) -> f64 {
    seam_jump_on(map, [0.0; 2])
}

/// The same of the map without a plane that rises so much from point to point along `[y, x]` (m).
pub(crate) fn seam_jump_on(map: &HeightMap, rise: [f64; 2]) -> f64 {
    let [ny, nx] = map.grid().shape();
    let row = |iy: usize| &map.heights()[iy * nx..(iy + 1) * nx];
    let back = [rise[0] * (1.0 - ny as f64), rise[1] * (1.0 - nx as f64)];
    let mut sums = [(0.0, 0); 4];
    for iy in 0..ny {
        let here = row(iy);
        let mut jumps = |k: usize, from: &[f64], to: &[f64], rise: f64| {
            add(&mut sums[k], from.iter().zip(to).map(|(a, b)| (b - a - rise).powi(2)));
        };
        let (k, rise_y) = if iy + 1 < ny { (0, rise[0]) } else { (1, back[0]) };
        jumps(k, here, row((iy + 1) % ny), rise_y);
        jumps(2, here, &here[1..], rise[1]);
        jumps(3, &here[nx - 1..], here, back[1]);
    }
    let [inside_y, across_y, inside_x, across_x] = sums.map(mean);
    let ratio =
        |across: f64, inside: f64| if inside > 0.0 { (across / inside).sqrt() } else { 0.0 };
    ratio(across_y, inside_y).max(ratio(across_x, inside_x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;
    use std::f64::consts::TAU;

    /// A ramp of one per pixel over 16 pixels falls by 15 at the seam; each axis counts by itself.
    #[test]
    fn a_ramp_jumps_by_its_length() {
        let grid = Grid::new([64, 16], [1.0, 2.0]).unwrap();
        let wave = |y: f64| 3.0 * (TAU * y / 64.0).sin();
        let ramp = HeightMap::from_fn(grid, |y, x| x / 2.0 + wave(y)).unwrap();
        assert!((seam_jump(&ramp) - 15.0).abs() < 1e-12 && !repeats(&ramp));
        let whole = HeightMap::from_fn(grid, |y, x| wave(y) + (TAU * x / 32.0).cos()).unwrap();
        assert!(repeats(&whole));
        assert!(seam_jump(&HeightMap::from_fn(grid, |_, _| 1.0).unwrap()) <= 0.0);
    }
}
