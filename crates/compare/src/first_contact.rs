//! The contact of every load of a curve, in one byte a point.
//!
//! Under an elastic flat the contact grows with the load: a point that touches at one load touches at every
//! higher one. The load at which each point first touches therefore holds the contact of them all. Where iteration leaves
//! a point out again, which it does only within its tolerance, that is written down beside it.

use serde::Serialize;

/// A curve of more loads is not kept.
const MOST_LOADS: usize = 240;

/// At which load each point of the grid solved first carries pressure.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct FirstContact {
    /// Index of that load, row-major; `u8::MAX` where no load makes the point touch.
    pub first: Vec<u8>,
    /// Load and point where a point is out of contact again at a higher load.
    pub lost: Vec<(usize, usize)>,
}

impl FirstContact {
    /// True where `point` carries pressure at the load of index `load`.
    #[cfg(test)]
    fn touches(&self, load: usize, point: usize) -> bool {
        usize::from(self.first[point]) <= load && !self.lost.contains(&(load, point))
    }

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
    fn holds_the_contact_of_every_load_also_where_a_point_comes_off() {
        let loads = [[0.0, 1.0, 0.0, 0.0], [0.5, 2.0, 0.0, 0.0], [0.0, 3.0, 1.0, 0.0]];
        let wide = |row: [f64; 4]| -> Vec<f64> { row.into_iter().cycle().take(400).collect() };
        let mut kept = None;
        for (i, load) in loads.iter().enumerate() {
            let field = wide(*load);
            kept = FirstContact::with(kept, i, &field);
            if i == 2 {
                assert_eq!(kept, None, "a quarter of the points came off");
            }
        }
        let mut field = wide(loads[1]);
        let mut kept = FirstContact::with(None, 0, &field);
        field[0] = 0.0;
        kept = FirstContact::with(kept, 1, &field);
        let kept = kept.unwrap();
        assert!(kept.touches(0, 0) && !kept.touches(1, 0) && kept.touches(1, 4));
        assert!(!kept.touches(1, 3) && kept.first[3] == u8::MAX);
        assert_eq!(FirstContact::with(Some(kept), 2, &field[..3]), None);
        assert_eq!(FirstContact::with(None, 1, &field), None, "the load before has no solution");
    }
}
