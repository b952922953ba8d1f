//! What is kept of every load of a curve: its contact and its pressure, in one byte a point or a dot; of the fields only that of
//! the headline is kept whole.

use contact_accuracy::round_to_digits;
use contact_types::Grid;
use serde::Serialize;

/// Most dots along the longer side.
const LARGEST: usize = 512;

/// The pressure of each load in squares of points.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PressureMaps {
    /// Points along the side of a dot; those at the far edges may cover fewer.
    pub block: usize,
    /// Dots `[ny, nx]`.
    pub shape: [usize; 2],
    /// One map for each load.
    pub loads: Vec<PressureMap>,
}

/// The pressure of one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PressureMap {
    /// Pressure of the highest class (Pa), see [`pressure_top`].
    pub top: f64,
    /// Whether points carry more than that.
    pub clipped: bool,
    /// Highest pressure of the points of each dot, row-major: 0 where none touches, else 1 to 255, of which 255 stands for
    /// the top and more.
    pub classes: Vec<u8>,
}

impl PressureMaps {
    /// With the pressure (Pa) of the load of index `load` on `grid`; `None` if it or one before has no solution.
    pub(crate) fn with(
        kept: Option<Self>,
        load: usize,
        grid: Grid,
        pressure: &[f64],
    ) -> Option<Self> {
        let [ny, nx] = grid.shape();
        let block = ny.max(nx).div_ceil(LARGEST);
        let shape = [ny, nx].map(|n| n.div_ceil(block));
        let mut kept = match kept {
            None if load == 0 => Self { block, shape, loads: Vec::new() },
            kept => kept?,
        };
        if pressure.len() != grid.len() {
            return None;
        }
        let (top, clipped) = pressure_top(pressure);
        let mut highest = vec![0.0_f64; shape[0] * shape[1]];
        for (iy, row) in pressure.chunks_exact(nx).enumerate() {
            let dots = &mut highest[iy / block * shape[1]..][..shape[1]];
            for (dot, points) in dots.iter_mut().zip(row.chunks(block)) {
                *dot = points.iter().copied().fold(*dot, f64::max);
            }
        }
        let classes = highest.iter().map(|p| pressure_class(*p, top)).collect();
        kept.loads.push(PressureMap { top, clipped, classes });
        Some(kept)
    }
}

/// The class of a pressure: 0 without contact, else 1 to 255, linear up to `top`.
pub fn pressure_class(pressure: f64, top: f64) -> u8 {
    if pressure > 0.0 { ((pressure / top).min(1.0) * 255.0).round().max(1.0) as u8 } else { 0 }
}

/// Upper end of a scale of pressures: the 99th percentile of those in contact, rounded to two digits, and whether any
/// lies above it.
pub fn pressure_top(pressure: &[f64]) -> (f64, bool) {
    let mut contact: Vec<f64> = pressure.iter().copied().filter(|p| *p > 0.0).collect();
    let highest = contact.iter().copied().fold(0.0, f64::max);
    if contact.is_empty() {
        return (1.0, false);
    }
    let place = (contact.len() - 1) * 99 / 100;
    let (_, high, _) = contact.select_nth_unstable_by(place, f64::total_cmp);
    let rounded = round_to_digits(*high, 2);
    (rounded, highest > rounded)
}

/// Loads of a curve beyond which its [`FirstContact`] is not kept: an index is one byte.
const MOST_LOADS: usize = 240;

/// At which load each point of the grid solved first carries pressure.
///
/// Under an elastic flat a point that touches at one load touches at every higher one, so that this holds the contact of
/// them all. Where iteration leaves a point out again, which it does only within its tolerance, that is written down beside it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct FirstContact {
    /// Index of that load, row-major; `u8::MAX` where no load makes the point touch.
    pub first: Vec<u8>,
    /// Load and point where a point is out of contact again at a higher load.
    pub lost: Vec<(usize, usize)>,
}

impl FirstContact {
    /// With the contact of the load of index `load`, higher than those before; `None` if the field has another size or
    /// there are too many loads, or more than a hundredth of the points was lost again.
    pub(crate) fn with(kept: Option<Self>, load: usize, pressure: &[f64]) -> Option<Self> {
        let mut kept = match kept {
            None if load == 0 => Self { first: vec![u8::MAX; pressure.len()], lost: Vec::new() },
            kept => kept?,
        };
        if load >= MOST_LOADS || kept.first.len() != pressure.len() {
            return None;
        }
        for (point, (first, p)) in kept.first.iter_mut().zip(pressure).enumerate() {
            if *p > 0.0 {
                *first = (*first).min(load as u8); // below MOST_LOADS
            } else if *first != u8::MAX {
                kept.lost.push((load, point));
            }
        }
        (kept.lost.len() <= pressure.len() / 100).then_some(kept)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_hold_the_highest_of_their_points_at_every_load() {
        let grid = Grid::new([3, 1025], [1e-6; 2]).unwrap();
        let mut field = vec![0.0; grid.len()];
        (field[4], field[1025 + 3], field[2 * 1025 + 1024]) = (2e6, 1e6, 1e3);
        let maps = PressureMaps::with(None, 0, grid, &field).unwrap();
        assert_eq!((maps.block, maps.shape), (3, [1, 342]));
        field[5] = 4e6;
        let maps = PressureMaps::with(Some(maps), 1, grid, &field).unwrap();
        let [light, heavy] = &maps.loads[..] else { panic!("two loads") };
        // Of few points the 99th percentile is the last but one.
        assert_eq!((light.top, light.clipped, heavy.top), (1e6, true, 2e6));
        assert_eq!((light.classes[1], light.classes[341], light.classes[0]), (255, 1, 0));
        assert_eq!((heavy.classes[1], heavy.classes[341]), (255, 1));
        assert_eq!(heavy.classes.iter().filter(|c| **c > 0).count(), 2);
        assert_eq!(PressureMaps::with(Some(maps), 2, grid, &[]), None, "no solution");
        assert_eq!(pressure_top(&[0.0]), (1.0, false));
        assert_eq!(PressureMaps::with(None, 1, grid, &field), None, "the load before has none");
    }

    #[test]
    fn holds_the_contact_of_every_load_also_where_a_point_comes_off() {
        let wide = |row: [f64; 4]| row.into_iter().cycle().take(400).collect::<Vec<f64>>();
        let kept = FirstContact::with(None, 0, &wide([0.0, 1.0, 0.0, 0.0]));
        let mut field = wide([0.5, 2.0, 0.0, 0.0]);
        field[1] = 0.0;
        let kept = FirstContact::with(kept, 1, &field).unwrap();
        assert_eq!((&kept.first[..4], &kept.lost[..]), (&[1, 0, 255, 255][..], &[(1, 1)][..]));
        let without = wide([0.0, 3.0, 1.0, 0.0]);
        assert_eq!(FirstContact::with(Some(kept.clone()), 2, &without), None, "a quarter came off");
        assert_eq!(FirstContact::with(Some(kept), 2, &field[..3]), None);
        assert_eq!(FirstContact::with(None, 1, &field), None, "the load before has no solution");
    }
}
