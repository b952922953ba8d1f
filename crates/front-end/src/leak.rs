//! The leak through the gap, as a user asks for it.

use crate::failure::Failure;
use contact_compare::{Along, LeakRequest, Seal};
use contact_types::Named;

/// Names of the numbers of a seal, in their order, whether 0 is allowed, and how they are written.
const NUMBERS: [(&str, bool, &str); 4] = [
    ("viscosity", false, "Pa s, for example 1mPa.s"),
    ("pressure drop", true, "Pa, for example 1MPa; the flow runs from the higher pressure"),
    ("seal length", false, "m, for example 1mm"),
    ("seal width", false, "m, for example 10mm"),
];

/// From `x`, `y` or `both` and the numbers of the seal: viscosity, pressure drop, length, width (SI).
///
/// # Errors
/// [`Failure`] of numbers that are none, or not all that a rate takes.
pub fn leak_request(
    axes: Option<&str>,
    numbers: [Option<f64>; 4],
) -> Result<Option<LeakRequest>, Failure> {
    let refused = |message: String| Err(Failure::refused("leak", message));
    let given = numbers.iter().flatten().count();
    let Some(name) = axes else {
        let message = "viscosity, pressure drop, seal length and seal width are for the leak; ask for it along \
                       x, y or both";
        return if given > 0 { refused(message.to_owned()) } else { Ok(None) };
    };
    let Some(along) = Along::of_name(name) else {
        return refused(format!("'{name}' is no direction of the leak; write x, y or both"));
    };
    for (number, (name, zero, how)) in numbers.into_iter().zip(NUMBERS) {
        let Some(value) = number else {
            if given > 0 {
                return refused(format!(
                    "a leak rate takes viscosity, pressure drop, seal length and seal width, and the {name} is \
                     missing; give it in {how}, or none of them for the permeability alone"
                ));
            }
            continue;
        };
        if !value.is_finite() || value < 0.0 || (!zero && value <= 0.0) {
            let least = if zero { "0 or more" } else { "more than 0" };
            return refused(format!("{name} {value:e}: it must be {least}, in {how}"));
        }
    }
    let seal = match numbers {
        [Some(viscosity), Some(pressure_drop), Some(length), Some(width)] => {
            Some(Seal { viscosity, pressure_drop, length, width })
        }
        _ => None,
    };
    Ok(Some(LeakRequest { along, seal }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_are_none_are_refused() {
        let good = [1e-3, 1e6, 1e-3, 1e-2];
        let of = |place: usize, value: f64| {
            let mut numbers = good.map(Some);
            numbers[place] = Some(value);
            leak_request(Some("both"), numbers).map_err(|e| e.message)
        };
        for (place, value) in [(0, 0.0), (0, -1.0), (1, -1.0), (2, 0.0), (3, f64::NAN), (3, -2.0)] {
            let message = of(place, value).unwrap_err();
            assert!(message.contains(NUMBERS[place].0) && message.contains("must be"), "{message}");
        }
        assert!(of(1, 0.0).is_ok(), "no pressure drop is a limit");
        let missing = leak_request(Some("x"), [Some(1e-3), None, Some(1e-3), None]).unwrap_err();
        assert!(missing.message.contains("pressure drop is"), "{missing}");
        assert!(leak_request(None, good.map(Some)).is_err());
        assert!(leak_request(Some("z"), [None; 4]).is_err());
    }
}
