//! Which part of a map is cut out, and where it lies.

use crate::error::ReadError;
use std::fmt;
use std::str::FromStr;

/// A part of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Cut {
    /// `[y0, x0, ny, nx]`: ny × nx points from row y0, column x0.
    Rectangle([usize; 4]),
    /// The largest rectangle without a missing point, by its number of points.
    Complete,
    /// The middle half of each side.
    Middle,
}

impl Cut {
    /// `[y0, x0, ny, nx]` of this part of a map of `shape` points, NaN where one is missing.
    ///
    /// # Errors
    /// [`ReadError::NothingComplete`] if no 2 × 2 points without a missing one are there.
    pub(crate) fn of(self, shape: [usize; 2], heights: &[f64]) -> Result<[usize; 4], ReadError> {
        match self {
            Self::Rectangle(part) => Ok(part),
            Self::Complete => {
                complete_part(shape, heights).ok_or(ReadError::NothingComplete(shape))
            }
            Self::Middle => {
                let [[y0, ny], [x0, nx]] = shape.map(|n| [n / 4, n.div_ceil(2)]);
                Ok([y0, x0, ny, nx])
            }
        }
    }
}

/// As [`Cut::from_str`] takes it.
impl fmt::Display for Cut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rectangle([y0, x0, ny, nx]) => write!(f, "{y0},{x0},{ny},{nx}"),
            Self::Complete => f.write_str("complete"),
            Self::Middle => f.write_str("middle"),
        }
    }
}

/// `Y0,X0,NY,NX`, `complete` or `middle`.
impl FromStr for Cut {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "complete" => return Ok(Self::Complete),
            "middle" => return Ok(Self::Middle),
            _ => {}
        }
        let numbers: Result<Vec<usize>, _> = text.split(',').map(|n| n.trim().parse()).collect();
        let part = numbers.ok().and_then(|all| <[usize; 4]>::try_from(all).ok());
        part.map(Self::Rectangle).ok_or_else(|| {
            format!(
                "'{text}' is not Y0,X0,NY,NX; write for example 0,0,512,512, or 'complete' for the largest part \
                 without missing points, or 'middle' for the middle half of each side"
            )
        })
    }
}

/// The largest rectangle of at least 2 × 2 points none of which is NaN; of equal ones the first by its last row, then its
/// first column. One pass: above each row stand columns of points, and a rectangle ends where a lower column begins.
fn complete_part([ny, nx]: [usize; 2], heights: &[f64]) -> Option<[usize; 4]> {
    let mut columns = vec![0_usize; nx];
    // Columns that rise from left to right: where each begins, and how high it is.
    let mut rising: Vec<[usize; 2]> = Vec::new();
    let mut best: Option<[usize; 4]> = None;
    for (iy, row) in heights.chunks_exact(nx).enumerate().take(ny) {
        for (column, height) in columns.iter_mut().zip(row) {
            *column = if height.is_nan() { 0 } else { *column + 1 };
        }
        rising.clear();
        for (ix, &high) in columns.iter().chain(&[0]).enumerate() {
            let mut begins = ix;
            while let Some([x0, ny]) = rising.pop_if(|[_, above]| *above >= high) {
                let (nx, least) = (ix - x0, best.map_or(0, |[.., ny, nx]| ny * nx));
                if ny >= 2 && nx >= 2 && ny * nx > least {
                    best = Some([iy + 1 - ny, x0, ny, nx]);
                }
                begins = x0;
            }
            rising.push([begins, high]);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Every rectangle, one after the other.
    fn by_trial([ny, nx]: [usize; 2], heights: &[f64]) -> usize {
        let complete = |y0: usize, x0: usize, y1: usize, x1: usize| {
            (y0..y1).all(|y| (x0..x1).all(|x| !heights[y * nx + x].is_nan()))
        };
        let mut most = 0;
        for y0 in 0..ny {
            for x0 in 0..nx {
                for y1 in y0 + 2..=ny {
                    for x1 in x0 + 2..=nx {
                        if complete(y0, x0, y1, x1) {
                            most = most.max((y1 - y0) * (x1 - x0));
                        }
                    }
                }
            }
        }
        most
    }

    proptest! {
        #[test]
        fn no_rectangle_is_larger(
            shape in prop::array::uniform2(1_usize..9),
            holes in prop::collection::vec(prop::bool::weighted(0.2), 64),
        ) {
            let heights: Vec<f64> =
                holes[..shape[0] * shape[1]].iter().map(|&hole| if hole { f64::NAN } else { 1.0 }).collect();
            let most = by_trial(shape, &heights);
            match complete_part(shape, &heights) {
                None => prop_assert_eq!(most, 0),
                Some([y0, x0, ny, nx]) => {
                    prop_assert_eq!(ny * nx, most);
                    let inside = |y: usize| &heights[y * shape[1] + x0..y * shape[1] + x0 + nx];
                    prop_assert!((y0..y0 + ny).flat_map(inside).all(|h| !h.is_nan()));
                }
            }
        }
    }

    #[test]
    fn parts_are_named_as_they_are_read() {
        for text in ["1,2,30,40", "complete", "middle"] {
            assert_eq!(text.parse::<Cut>().unwrap().to_string(), text);
        }
        for bad in ["", "1,2,3", "1,2,3,4,5", "1,2,3,-4", "half"] {
            assert!(bad.parse::<Cut>().unwrap_err().contains("Y0,X0,NY,NX"), "{bad}");
        }
    }
}
