//! A model computed elsewhere: its curve as data, with name and citation.

use crate::needs::Inputs;
use crate::progress::StudyError;
use crate::theory::{BuildError, Card, Theory};
use contact_types::{Citation, ContactModel, ContactState, ModelError};
use std::sync::Arc;

/// One point of a curve computed elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct CurvePoint {
    /// Nominal pressure (Pa).
    pub mean_pressure: f64,
    /// Real area fraction (-).
    pub area_fraction: f64,
    /// Mean gap after deformation (m), if the model has one.
    pub mean_gap: Option<f64>,
}

/// A theory that is a curve: area fraction, and perhaps mean gap, over nominal pressure, as another
/// program computed it for one surface and one modulus.
///
/// At a pressure of the curve the answer is the number given; between two of them area and gap are
/// interpolated by straight lines of their logarithms. Outside the curve there is no answer.
#[derive(Debug, Clone)]
pub struct Tabulated {
    card: Card,
    /// Name of the surface that it is for: on others of the study it does not apply. `None` for all.
    pub surface: Option<String>,
    points: Arc<[CurvePoint]>,
}

impl Tabulated {
    /// The curve of the theory that `card` names, by rising pressure.
    ///
    /// # Errors
    /// [`StudyError::EmptyCurve`] and [`StudyError::BadPoint`].
    pub fn new(card: Card, points: Vec<CurvePoint>) -> Result<Self, StudyError> {
        if points.is_empty() {
            return Err(StudyError::EmptyCurve);
        }
        let mut before = 0.0;
        for (index, point) in points.iter().enumerate() {
            let CurvePoint { mean_pressure: p, area_fraction: area, mean_gap } = *point;
            let bad = |quantity, value, requirement| {
                Err(StudyError::BadPoint { index, quantity, value, requirement })
            };
            if !(p.is_finite() && p > before) {
                let must =
                    "Pa must be finite, greater than 0 and greater than that of the point before";
                return bad("nominal pressure", p, must);
            }
            if !(0.0..=1.0).contains(&area) {
                return bad("area fraction", area, "must be from 0 to 1");
            }
            if let Some(gap) = mean_gap.filter(|gap| !(gap.is_finite() && *gap >= 0.0)) {
                return bad("mean gap", gap, "m must be finite and at least 0");
            }
            before = p;
        }
        Ok(Self { card, surface: None, points: points.into() })
    }
}

impl Theory for Tabulated {
    fn card(&self) -> &Card {
        &self.card
    }

    fn build(&self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        if let (Some(own), Some(asked)) = (&self.surface, &inputs.surface)
            && own != asked
        {
            let needs = format!("a curve of this surface; it was computed for '{own}'");
            let model = self.card.title.clone();
            return Err(BuildError::Missing { model, needs: needs.into() });
        }
        Ok(Box::new(self.clone()))
    }
}

impl ContactModel for Tabulated {
    fn citation(&self) -> Citation {
        self.card.citation.clone()
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let (first, last) = (self.points[0], self.points[self.points.len() - 1]);
        let domain = first.mean_pressure..=last.mean_pressure;
        if !domain.contains(&mean_pressure) {
            return Err(ModelError::OutsideDomain {
                model: self.card.title.clone(),
                quantity: "mean pressure in Pa".into(),
                value: mean_pressure,
                domain,
                reason: "the curve that was given ends there".into(),
            });
        }
        let above = self.points.partition_point(|p| p.mean_pressure < mean_pressure);
        let high = self.points[above];
        let low = if high.mean_pressure > mean_pressure { self.points[above - 1] } else { high };
        let part = if high.mean_pressure > low.mean_pressure {
            (mean_pressure / low.mean_pressure).ln() / (high.mean_pressure / low.mean_pressure).ln()
        } else {
            0.0
        };
        Ok(ContactState {
            mean_pressure,
            area_fraction: between(low.area_fraction, high.area_fraction, part),
            separation: None,
            mean_gap: low.mean_gap.zip(high.mean_gap).map(|(a, b)| between(a, b, part)),
            caveat: None,
        })
    }
}

/// By a straight line of the logarithms; of the numbers where one of them is 0.
fn between(low: f64, high: f64, part: f64) -> f64 {
    if part <= 0.0 {
        low
    } else if low > 0.0 && high > 0.0 {
        low * (part * (high / low).ln()).exp()
    } else {
        low + part * (high - low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::ContactModulus;

    fn card() -> Card {
        let citation = Citation::new("A. Nother", 2025, "Elsewhere", "J. 1, 1", "");
        Card::new("elsewhere", "Elsewhere", citation)
    }

    fn point(mean_pressure: f64, area_fraction: f64) -> CurvePoint {
        CurvePoint { mean_pressure, area_fraction, mean_gap: None }
    }

    /// A power law is a straight line of logarithms: exact between its points too.
    #[test]
    fn a_power_law_is_met_everywhere() {
        let law = |p: f64| 1e-7 * p.powf(0.9);
        let points = [1e4_f64, 1e5, 3e6]
            .map(|p| CurvePoint { mean_gap: Some(1e-3 * p.powf(-0.5)), ..point(p, law(p)) });
        let inputs = Inputs::new(ContactModulus::from_pascals(1e9).unwrap());
        let model = Tabulated::new(card(), points.to_vec()).unwrap().build(&inputs).unwrap();
        for p in [1e4, 2e4, 1e5, 1.7e6, 3e6] {
            let state = model.at_pressure(p).unwrap();
            assert!((state.area_fraction / law(p) - 1.0).abs() < 1e-12, "{p}");
            assert!((state.mean_gap.unwrap() / (1e-3 * p.powf(-0.5)) - 1.0).abs() < 1e-12, "{p}");
        }
        for p in [0.9e4, 3.1e6, f64::NAN] {
            let refused = model.at_pressure(p);
            assert!(matches!(refused, Err(ModelError::OutsideDomain { .. })), "{p}");
        }
        assert_eq!(model.citation().authors, "A. Nother");
    }

    #[test]
    fn a_curve_of_another_surface_does_not_apply() {
        let mut curve = Tabulated::new(card(), vec![point(1.0, 0.1)]).unwrap();
        curve.surface = Some("ground".into());
        let mut inputs = Inputs::new(ContactModulus::from_pascals(1e9).unwrap());
        inputs.surface = Some("honed".into());
        assert!(matches!(curve.build(&inputs), Err(BuildError::Missing { .. })));
        inputs.surface = Some("ground".into());
        assert!(curve.build(&inputs).is_ok());
    }

    #[test]
    fn what_is_no_curve_is_refused() {
        let gap = CurvePoint { mean_gap: Some(-1.0), ..point(1.0, 0.1) };
        for (points, said) in [
            (vec![], "a curve needs at least one point"),
            (vec![point(2.0, 0.1), point(1.0, 0.2)], "point 1 of the curve: nominal pressure 1e0"),
            (vec![point(1.0, 1.1)], "point 0 of the curve: area fraction 1.1e0"),
            (vec![gap], "point 0 of the curve: mean gap -1e0 m"),
        ] {
            let refused = Tabulated::new(card(), points).unwrap_err().to_string();
            assert!(refused.starts_with(said), "{refused}");
        }
    }
}
