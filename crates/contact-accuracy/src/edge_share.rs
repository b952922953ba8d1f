//! How much of a contact stands at the edge of the map, where a map that does not repeat meets
//! its own other side.

use contact_types::Grid;

/// Width of the strip as a part of the shorter side.
const PART: usize = 64;

/// Shares of the strip along the edge: its points over all, and what it carries over the whole.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct EdgeShare {
    /// Width of the strip (points).
    pub width: usize,
    /// Its part of the map (-).
    pub map: f64,
    /// Its part of the touching points (-).
    pub contact: f64,
    /// Its part of the load (-).
    pub load: f64,
}

impl EdgeShare {
    /// The strip a 64th of the shorter side wide, in `pressure` on `grid`; `None` if nothing
    /// touches, the map is too narrow for a strip and an inside, or the field is not of this grid.
    pub fn of(pressure: &[f64], grid: Grid) -> Option<Self> {
        let [ny, nx] = grid.shape();
        let width = (ny.min(nx) / PART).max(1);
        if pressure.len() != grid.len() || ny.min(nx) <= 2 * width {
            return None;
        }
        let inside = (ny - 2 * width) * (nx - 2 * width);
        let [mut contact, mut load] = [[0.0; 2]; 2]; // strip, all
        for (i, &p) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            let (iy, ix) = (i / nx, i % nx);
            let is_edge = iy < width || ix < width || iy >= ny - width || ix >= nx - width;
            let part = f64::from(u8::from(is_edge));
            contact[0] += part;
            contact[1] += 1.0;
            load[0] += part * p;
            load[1] += p;
        }
        (load[1] > 0.0).then(|| Self {
            width,
            map: 1.0 - inside as f64 / grid.len() as f64,
            contact: contact[0] / contact[1],
            load: load[0] / load[1],
        })
    }

    /// Relative change of the area at this load that the strip makes directly: what its contact
    /// adds to the ratio of area to load. With area in proportion to load, as at light load, the
    /// inside alone would have an area of (1 − contact)/(1 − load) of the whole.
    pub fn direct_effect(&self) -> f64 {
        (1.0 - self.load) / (1.0 - self.contact).max(f64::MIN_POSITIVE) - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 8 x 10 points: the strip is one point wide and holds 80 − 6·8 = 32 of them.
    #[test]
    fn shares_of_a_map_counted_by_hand() {
        let grid = Grid::new([8, 10], [1.0, 2.0]).unwrap();
        let even = EdgeShare::of(&[3.0; 80], grid).unwrap();
        assert_eq!((even.width, even.map), (1, 0.4));
        assert!((even.contact - 0.4).abs() < 1e-15 && (even.load - 0.4).abs() < 1e-15);
        assert!((even.load / even.map - 1.0).abs() < 1e-12 && even.direct_effect().abs() < 1e-12);

        let mut pressure = [0.0; 80];
        pressure[0] = 1.0; // a corner
        pressure[39] = 2.0; // end of the fourth row
        pressure[45] = 9.0; // inside
        let share = EdgeShare::of(&pressure, grid).unwrap();
        assert!((share.contact - 2.0 / 3.0).abs() < 1e-15);
        assert!((share.load - 0.25).abs() < 1e-15);
        // The inside carries 3/4 of the load on 1/3 of the points: 4/9 of the area per load.
        assert!((share.direct_effect() - 1.25).abs() < 1e-12);
    }

    #[test]
    fn the_strip_grows_with_the_map_and_needs_an_inside() {
        let square = |n| Grid::new([n, n], [1.0, 1.0]).unwrap();
        assert_eq!(EdgeShare::of(&vec![1.0; 256 * 256], square(256)).unwrap().width, 4);
        assert_eq!(EdgeShare::of(&[1.0; 4], square(2)), None);
        assert_eq!(EdgeShare::of(&[0.0; 64], square(8)), None);
        assert_eq!(EdgeShare::of(&[1.0; 63], square(8)), None);
    }
}
