//! Numbers as NetCDF and its conventions for climate and forecast (CF) pack them, in the classic
//! format and in HDF5.
//!
//! | attribute | content |
//! |---|---|
//! | `_FillValue`, `missing_value`, `No Data` | stored numbers that mark missing points |
//! | `valid_range`, `valid_min`, `valid_max` | stored numbers beyond are missing points |
//! | `scale_factor`, `add_offset` | value = stored × factor + offset; 1 and 0 if absent |

use crate::cells::is_mark;

/// How the numbers of one variable are stored.
pub(crate) struct Packing {
    missing: Vec<f64>,
    valid: [f64; 2],
    factor: f64,
    offset: f64,
}

impl Packing {
    /// As the attributes say; `numbers` gives those of one name.
    pub(crate) fn of<'n>(numbers: impl Fn(&str) -> Option<&'n [f64]>) -> Self {
        let one = |key: &str| numbers(key).and_then(|all| all.first().copied());
        let marks = ["_FillValue", "missing_value", "No Data"];
        let [low, high] = match numbers("valid_range") {
            Some(&[low, high]) => [Some(low), Some(high)],
            _ => [one("valid_min"), one("valid_max")],
        };
        Self {
            missing: marks.iter().filter_map(|key| numbers(key)).flatten().copied().collect(),
            valid: [low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY)],
            factor: one("scale_factor").unwrap_or(1.0),
            offset: one("add_offset").unwrap_or(0.0),
        }
    }

    /// Stored numbers become values; NaN where a point is missing.
    pub(crate) fn unpack(&self, stored: &mut [f64]) {
        let [low, high] = self.valid;
        for value in stored {
            let is_missing = self.missing.iter().any(|mark| is_mark(*value, *mark))
                || *value < low
                || *value > high;
            *value = if is_missing { f64::NAN } else { *value * self.factor + self.offset };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_and_limits_are_of_stored_numbers() {
        let packing = Packing::of(|key| match key {
            "scale_factor" => Some(&[0.5]),
            "add_offset" => Some(&[100.0]),
            "missing_value" => Some(&[-1.0, -2.0]),
            "valid_range" => Some(&[-10.0, 20.0]),
            _ => None,
        });
        let mut values = [4.0, -1.0, -2.0, 20.0, 21.0, -11.0];
        packing.unpack(&mut values);
        let right = [102.0, f64::NAN, f64::NAN, 110.0, f64::NAN, f64::NAN];
        assert_eq!(values.map(f64::to_bits), right.map(f64::to_bits));
    }
}
