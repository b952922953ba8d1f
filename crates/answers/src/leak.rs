//! The leak through the gap, as a user asks for it.

use crate::failure::Failure;
use contact_accuracy::{Axis, Leak as Along, Leaks, NotSolved};
use serde_json::{Map, Value, json};

/// What is asked of the leak.
#[derive(Clone, Debug, PartialEq)]
pub struct Leak {
    /// Directions of the pressure drop.
    pub axes: Vec<Axis>,
    /// The seal and its fluid, for a rate.
    pub seal: Option<Seal>,
}

/// A seal and its fluid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seal {
    /// Viscosity η (Pa s).
    pub viscosity: f64,
    /// Pressure drop Δp (Pa).
    pub pressure_drop: f64,
    /// Length L of the way through the seal (m).
    pub length: f64,
    /// Width W across the flow (m).
    pub width: f64,
}

/// Names of the numbers of a seal, in their order, whether 0 is allowed, and how they are written.
const NUMBERS: [(&str, bool, &str); 4] = [
    ("viscosity", false, "Pa s, for example 1mPa.s"),
    ("pressure drop", true, "Pa, for example 1MPa; the flow runs from the higher pressure"),
    ("seal length", false, "m, for example 1mm"),
    ("seal width", false, "m, for example 10mm"),
];

impl Leak {
    /// From `x`, `y` or `both` and the numbers of the seal: viscosity, pressure drop, length, width (SI).
    ///
    /// # Errors
    /// [`Failure`] of numbers that are none, or not all that a rate takes.
    pub fn asked(axes: Option<&str>, numbers: [Option<f64>; 4]) -> Result<Option<Self>, Failure> {
        let refused = |message: String| Err(Failure::refused("leak", message));
        let given = numbers.iter().flatten().count();
        let axes = match axes {
            None if given > 0 => {
                return refused(
                    "viscosity, pressure drop, seal length and seal width are for the leak; ask for it along \
                     x, y or both"
                        .to_owned(),
                );
            }
            None => return Ok(None),
            Some("x") => vec![Axis::X],
            Some("y") => vec![Axis::Y],
            Some("both") => Axis::BOTH.to_vec(),
            Some(other) => {
                return refused(format!(
                    "'{other}' is no direction of the leak; write x, y or both"
                ));
            }
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
        Ok(Some(Self { axes, seal }))
    }

    /// What stands beside the points.
    pub(crate) fn object(&self, yields: bool) -> Value {
        json!({
            "axes": self.axes.iter().map(|axis| axis.name()).collect::<Vec<_>>(),
            "gap": if yields { "yielded" } else { "elastic" },
            "viscosity": self.seal.map(|s| s.viscosity),
            "pressure_drop": self.seal.map(|s| s.pressure_drop),
            "seal_length": self.seal.map(|s| s.length),
            "seal_width": self.seal.map(|s| s.width),
        })
    }

    /// What stands in a point.
    pub(crate) fn point(&self, leaks: &Leaks) -> Value {
        let plates = leaks.mean_gap.powi(3);
        let mut object = Map::new();
        for (axis, found) in &leaks.along {
            object.insert(axis.name().to_owned(), self.along(found, plates));
        }
        let closed = [
            ("mean_gap_cubed", plates, leaks.seconds[1]),
            ("bruggeman", leaks.bruggeman, leaks.seconds[2]),
        ];
        let form = |(name, permeability, seconds): (&str, f64, f64)| {
            let errors: Map<String, Value> = leaks
                .along
                .iter()
                .map(|(axis, found)| (axis.name().to_owned(), json!(error(permeability, found))))
                .collect();
            json!({ "name": name, "permeability": permeability, "error": errors, "seconds": seconds })
        };
        object.insert("closed_forms".to_owned(), json!(closed.map(form)));
        object.insert("seconds".to_owned(), json!(leaks.seconds[0]));
        Value::Object(object)
    }

    fn along(&self, found: &Result<Along, NotSolved>, plates: f64) -> Value {
        let leak = match found {
            Ok(leak) => leak,
            Err(error) => return json!({ "error": error.to_string() }),
        };
        let (k, flow) = (permeability(leak), &leak.flow);
        let rate = |k: f64| self.seal.map(|seal| seal.rate(k));
        let interval = leak.interval();
        json!({
            "channel": channel(leak),
            "permeability": k,
            "interval": interval,
            "flow_factor": k.map(|k| k / plates).filter(|f| f.is_finite()),
            "rate": k.and_then(rate),
            "rate_interval": interval.and_then(|ends| Some([rate(ends[0])?, rate(ends[1])?])),
            "bottleneck": flow.bottleneck.map(|b| json!({
                "row": b.place[0], "column": b.place[1], "height": b.height, "points_across": b.width,
            })),
            "arithmetic_faces": flow.arithmetic,
            "coarser": leak.coarser,
            "imbalance": flow.imbalance,
        })
    }
}

impl Seal {
    /// Leak rate Q = K W Δp/(12 η L) (m³/s) of a permeability (m³).
    pub fn rate(&self, permeability: f64) -> f64 {
        permeability * self.width * self.pressure_drop / (12.0 * self.viscosity * self.length)
    }
}

/// Permeability K (m³); `None` where there is a bound only.
pub fn permeability(leak: &Along) -> Option<f64> {
    leak.is_rate().then_some(leak.flow.permeability)
}

/// Whether a channel is `open`, too `narrow` for a rate, or none is: `sealed`.
pub fn channel(leak: &Along) -> &'static str {
    match (&leak.flow.bottleneck, leak.is_rate()) {
        (None, _) => "sealed",
        (_, true) => "open",
        (_, false) => "narrow",
    }
}

/// Relative error of a closed form, where there is a permeability above 0.
pub fn error(closed: f64, found: &Result<Along, NotSolved>) -> Option<f64> {
    let k = permeability(found.as_ref().ok()?).filter(|k| *k > 0.0)?;
    Some(closed / k - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Poiseuille's flow between plates of 1 µm: h³ W Δp/(12 η L).
    #[test]
    fn a_rate_is_that_between_plates() {
        let numbers = [1e-3, 1e6, 1e-3, 1e-2].map(Some);
        let seal = Leak::asked(Some("x"), numbers).unwrap().unwrap().seal.unwrap();
        assert!(
            (seal.rate(1e-18) / (1e-18 * 1e-2 * 1e6 / (12.0 * 1e-3 * 1e-3)) - 1.0).abs() < 1e-14
        );
        assert_eq!(Leak::asked(None, [None; 4]), Ok(None));
    }

    #[test]
    fn numbers_that_are_none_are_refused() {
        let good = [1e-3, 1e6, 1e-3, 1e-2];
        let of = |place: usize, value: f64| {
            let mut numbers = good.map(Some);
            numbers[place] = Some(value);
            Leak::asked(Some("both"), numbers).map_err(|e| e.message().to_owned())
        };
        for (place, value) in [(0, 0.0), (0, -1.0), (1, -1.0), (2, 0.0), (3, f64::NAN), (3, -2.0)] {
            let message = of(place, value).unwrap_err();
            assert!(message.contains(NUMBERS[place].0) && message.contains("must be"), "{message}");
        }
        assert!(of(1, 0.0).is_ok(), "no pressure drop is a limit");
        let missing = Leak::asked(Some("x"), [Some(1e-3), None, Some(1e-3), None]).unwrap_err();
        assert!(missing.message().contains("pressure drop is"), "{}", missing.message());
        assert!(
            Leak::asked(None, good.map(Some)).is_err()
                && Leak::asked(Some("z"), [None; 4]).is_err()
        );
    }
}
