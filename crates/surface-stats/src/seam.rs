//! Whether the opposite edges of a map meet.

use contact_types::HeightMap;

/// Jump across the seam over those inside up to which a map counts as one that repeats.
pub const MOST_SEAM_JUMP: f64 = 2.0;

/// Whether opposite edges meet: the jump across them is of the size of those inside.
pub fn repeats(map: &HeightMap) -> bool {
    seam_jump(map) <= MOST_SEAM_JUMP
}

/// Rms jump between opposite edges over that between neighbours inside, the larger of the two
/// axes; 0 for a flat map.
pub fn seam_jump(map: &HeightMap) -> f64 {
    let [ny, nx] = map.grid().shape();
    let (mut across, mut inside) = ([0.0; 2], [0.0; 2]);
    for iy in 0..ny {
        for ix in 0..nx {
            let here = map.at(iy, ix);
            let down = (map.at((iy + 1) % ny, ix) - here).powi(2);
            let right = (map.at(iy, (ix + 1) % nx) - here).powi(2);
            let sums = if iy + 1 == ny { &mut across } else { &mut inside };
            sums[0] += down / if iy + 1 == ny { 1.0 } else { (ny - 1) as f64 };
            let sums = if ix + 1 == nx { &mut across } else { &mut inside };
            sums[1] += right / if ix + 1 == nx { 1.0 } else { (nx - 1) as f64 };
        }
    }
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
