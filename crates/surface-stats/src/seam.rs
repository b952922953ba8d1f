//! Whether the opposite edges of a map meet.

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
    let [ny, nx] = map.grid().shape();
    let row = |iy: usize| &map.heights()[iy * nx..(iy + 1) * nx];
    let squares = |from: &[f64], to: &[f64]| -> f64 {
        from.iter().zip(to).map(|(a, b)| (b - a).powi(2)).sum()
    };
    let across = [
        squares(row(ny - 1), row(0)),
        (0..ny).map(|iy| squares(&row(iy)[nx - 1..], row(iy))).sum(),
    ];
    let inside = [
        (1..ny).map(|iy| squares(row(iy - 1), row(iy))).sum::<f64>() / (ny as f64 - 1.0),
        (0..ny).map(|iy| squares(row(iy), &row(iy)[1..])).sum::<f64>() / (nx as f64 - 1.0),
    ];
    let ratio = |axis: usize| {
        if inside[axis] > 0.0 { (across[axis] / inside[axis]).sqrt() } else { 0.0 }
    };
    ratio(0).max(ratio(1))
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
