//! Does a theory cover this surface? Yes, with caution, or no, each with the measured reason.

use crate::finding::{Applies, Fact, Reason, Verdict};
use crate::needs::Inputs;
use crate::result::ModelCurve;
use crate::scene::{is_steep, steep};
use crate::theory::{Assumes, BuildError, Card};
use contact_types::{Caveat, ContactState, ModelError, Wave};
use surface_stats::Warning;

/// What a verdict looks at of a surface.
#[derive(Default)]
pub(crate) struct Judged {
    /// Rms gradient \[-\].
    pub(crate) gradient: f64,
    /// That rows stand at heights of their own, if they do.
    pub(crate) rows_jump: Option<Warning>,
    /// Largest over smallest mean square slope \[-\], if it is known.
    pub(crate) anisotropy: Option<f64>,
    /// Skewness and kurtosis \[-\].
    pub(crate) heights: Option<(f64, f64)>,
    /// Wavelengths of the fractal fit (m).
    pub(crate) fractal_range: Option<[f64; 2]>,
    /// What yield adds to the elastic area, if a hardness is given and it does.
    pub(crate) excess: Option<Reason>,
}

/// Judges the domain, not the error.
pub(crate) fn verdict(
    card: &Card,
    inputs: &Inputs,
    outcome: &Result<ModelCurve, BuildError>,
    pressures: &[f64],
    statistics: &Judged,
) -> Verdict {
    let curve = match outcome {
        Ok(curve) => curve,
        Err(error) => {
            let dimension = match error {
                BuildError::Missing { .. } if card.assumes == Assumes::Fractal => inputs.dimension,
                _ => None,
            };
            let reasons = vec![Reason::Refused { error: error.clone(), dimension }];
            return Verdict { answer: Applies::No, reasons, at_every_load: true };
        }
    };
    let reasons = strains(card, inputs, curve, pressures, statistics);
    let answer = if reasons.is_empty() { Applies::Yes } else { Applies::Caution };
    let at_every_load = reasons.is_empty() || reasons.iter().any(|r| !r.is_by_load());
    Verdict { answer, reasons, at_every_load }
}

/// Assumptions that this surface or these loads strain, with the numbers.
fn strains(
    card: &Card,
    inputs: &Inputs,
    curve: &ModelCurve,
    pressures: &[f64],
    statistics: &Judged,
) -> Vec<Reason> {
    let mut reasons = Vec::new();
    let gradient = statistics.gradient;
    if is_steep(gradient) {
        reasons.push(Reason::Surface(steep(gradient)));
    }
    if matches!(card.assumes, Assumes::Summits | Assumes::Gaussian) {
        let mut warned = |warning| reasons.push(Reason::Surface(Fact::Warned(warning)));
        if let Some(rows) = statistics.rows_jump {
            warned(rows);
        } else if let Some(ratio) = statistics.anisotropy.filter(|r| *r > 2.0) {
            warned(Warning::Anisotropic { ratio });
        }
        if let Some((skewness, kurtosis)) = statistics.heights
            && (skewness.abs() > 0.2 || (kurtosis - 3.0).abs() > 0.3)
        {
            warned(Warning::NotGaussian { skewness, kurtosis });
        }
    }
    match card.assumes {
        Assumes::Summits => {
            // Summits begin to feel each other well before the caveat at 10 %.
            let is_crowded = |state: &ContactState| state.area_fraction > 0.05;
            let mut loads = curve.points.iter().zip(pressures);
            let crowded = loads.find(|(point, _)| point.as_ref().is_ok_and(is_crowded));
            reasons.extend(crowded.map(|(_, &from)| Reason::Strained { caveat: None, from }));
        }
        Assumes::Amplitudes => {
            if let Some(amplitudes) = &inputs.amplitudes {
                let ratio = |w: &Wave| w.amplitude * w.frequency;
                let waves = amplitudes.waves().iter();
                let steepest = waves.max_by(|a, b| ratio(a).total_cmp(&ratio(b)));
                let (short, long) =
                    (steepest.map(|w| 1.0 / w.frequency), amplitudes.record_length());
                reasons.push(Reason::Band { dimension: None, short, long });
            }
        }
        Assumes::Fractal => {
            if let (dimension @ Some(_), Some([short, long])) =
                (inputs.dimension, statistics.fractal_range)
            {
                reasons.push(Reason::Band { dimension, short: Some(short), long });
            }
        }
        Assumes::Gaussian | Assumes::Unstated => {}
    }
    reasons.extend(statistics.excess.clone().filter(|_| !card.yields));
    reasons.extend(caveat(&curve.points, pressures));
    let failed = curve.points.iter().filter(|p| p.is_err()).count();
    if failed > 0 {
        reasons.push(Reason::NoAnswer { loads: failed, of: curve.points.len() });
    }
    reasons
}

/// The model's own caveat that is not about area, which is judged above. An area too small for a
/// double is no strain of the theory.
fn caveat(points: &[Result<ContactState, ModelError>], pressures: &[f64]) -> Option<Reason> {
    points.iter().zip(pressures).find_map(|(point, &from)| {
        let caveat = point.as_ref().ok()?.caveat.as_ref()?;
        let strains = match caveat {
            Caveat::BeyondModel { quantity, .. } => quantity != "area fraction",
            Caveat::Saturated { .. } => true,
            _ => false,
        };
        strains.then(|| Reason::Strained { caveat: Some(caveat.clone()), from })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An area that underflows is no strain, and one beyond the model is judged by the loads alone.
    #[test]
    fn a_caveat_that_is_not_about_area_is_a_strain() {
        let beyond = |quantity: &'static str| Caveat::BeyondModel {
            quantity: quantity.into(),
            value: 0.3,
            limit: 0.1,
            reason: "".into(),
        };
        for (given, is_strain) in [
            (Caveat::Underflow { quantity: "area fraction".into() }, false),
            (Caveat::Saturated { quantity: "area fraction".into() }, true),
            (beyond("area fraction"), false),
            (beyond("slope"), true),
        ] {
            let state = ContactState {
                mean_pressure: 2e6,
                area_fraction: 0.01,
                separation: None,
                mean_gap: None,
                caveat: Some(given.clone()),
            };
            let expected = is_strain.then_some(Reason::Strained { caveat: Some(given), from: 2e6 });
            assert_eq!(caveat(&[Ok(state)], &[2e6]), expected);
        }
    }
}
