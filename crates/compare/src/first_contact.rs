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
