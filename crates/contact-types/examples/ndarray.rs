//! Heights from an `ndarray::Array2` and back.
//!
//! `cargo run -p contact-types --example ndarray`
#![allow(clippy::print_stdout, reason = "an example shows what it does")]

use contact_types::{Grid, HeightMap, SurfaceError};
use ndarray::{Array2, ArrayView2, ShapeError};

/// Takes heights in metres, rows along y, on pixels of `[dy, dx]` metres. Any memory order is right:
/// a transposed view or a slice with steps is copied in the order of its rows.
///
/// # Errors
/// [`SurfaceError`] for an empty array, a pixel that is no length, or a height that is not finite.
fn from_array(array: &ArrayView2<'_, f64>, pixel: [f64; 2]) -> Result<HeightMap, SurfaceError> {
    let (ny, nx) = array.dim();
    HeightMap::new(Grid::new([ny, nx], pixel)?, array.iter().copied().collect())
}

/// Gives the heights away without a copy.
fn to_array(map: HeightMap) -> Result<Array2<f64>, ShapeError> {
    let [ny, nx] = map.grid().shape();
    Array2::from_shape_vec((ny, nx), map.into_heights())
}

/// Looks at the heights without a copy.
fn view(map: &HeightMap) -> Result<ArrayView2<'_, f64>, ShapeError> {
    let [ny, nx] = map.grid().shape();
    ArrayView2::from_shape((ny, nx), map.heights())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let array = Array2::from_shape_fn((3, 4), |(iy, ix)| 1e-9 * ix as f64 + 1e-7 * iy as f64);
    let map = from_array(&array.view(), [3e-6, 2e-6])?;
    println!("highest: {:e} m, mean: {:e} m", map.range().1, view(&map)?.sum() / 12.0);
    println!("the same again: {}", to_array(map)? == array);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Axis;

    #[test]
    fn both_ways_in_any_memory_order() {
        let array = Array2::from_shape_fn((3, 4), |(iy, ix)| (10 * iy + ix) as f64);
        let map = from_array(&array.view(), [3.0, 2.0]).unwrap();
        assert_eq!((map.at(2, 1), map.grid().shape()), (21.0, [3, 4]));
        assert_eq!(view(&map).unwrap(), array);
        assert_eq!(to_array(map).unwrap(), array);

        let transposed = from_array(&array.t(), [2.0, 3.0]).unwrap(); // column-major
        assert_eq!((transposed.at(1, 2), transposed.grid().shape()), (21.0, [4, 3]));
        let mut strided = array.view();
        strided.invert_axis(Axis(0)); // rows from the last to the first
        let flipped = from_array(&strided, [3.0, 2.0]).unwrap();
        assert_eq!((flipped.at(0, 1), flipped.at(2, 3)), (21.0, 3.0));

        assert!(from_array(&Array2::zeros((0, 4)).view(), [1.0, 1.0]).is_err());
        assert!(from_array(&Array2::from_elem((2, 2), f64::NAN).view(), [1.0, 1.0]).is_err());
    }
}
