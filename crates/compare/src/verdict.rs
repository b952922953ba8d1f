//! Does a theory cover this surface? Yes, with caution, or no, each with the measured reason.

use crate::models::{Assumes, BuildError, Inputs, ModelEntry};
use crate::report::{length, pressure};
use crate::result::{Applies, DeterministicPoint, ModelCurve, Verdict};
use contact_types::{Caveat, ModelError};
use surface_stats::SurfaceStatistics;

/// Judges the domain, not the error.
pub(crate) fn verdict(
    entry: &ModelEntry,
    inputs: &Inputs,
    outcome: &Result<ModelCurve, BuildError>,
    loads: &[DeterministicPoint],
    statistics: &SurfaceStatistics,
) -> Verdict {
    let (answer, reason, at_every_load) = match outcome {
        Err(error) => (Applies::No, refusal(error, inputs), true),
        Ok(curve) => {
            let reasons = strains(entry, inputs, curve, loads, statistics);
            let general = reasons.iter().any(|r| !r.by_load);
            if reasons.is_empty() {
                (Applies::Yes, within(entry).into(), true)
            } else {
                let texts: Vec<String> = reasons.into_iter().map(|r| r.text).collect();
                (Applies::Caution, texts.join("; "), general)
            }
        }
    };
    Verdict { answer, reason, at_every_load }
}

fn refusal(error: &BuildError, inputs: &Inputs) -> String {
    match error {
        BuildError::Model(ModelError::OutsideDomain {
            quantity, value, domain, reason, ..
        }) => {
            let bound = if value < domain.start() {
                format!("< {}", plain(*domain.start()))
            } else {
                format!("≥ {}", plain(*domain.end()))
            };
            format!("{quantity} = {} {bound}: {reason}", plain(*value))
        }
        BuildError::Missing { needs, .. } => match inputs.dimension {
            Some(d) if needs.contains("fractal") => {
                format!("fitted D = {}: no profile dimension between 1 and 2", plain(d))
            }
            _ => format!("needs {needs}"),
        },
        BuildError::Model(other) => other.to_string(),
    }
}

fn plain(value: f64) -> String {
    format!("{value:.2}").trim_end_matches('0').trim_end_matches('.').replace('-', "\u{2212}")
}

fn within(entry: &ModelEntry) -> &'static str {
    match entry.assumes {
        Assumes::Summits => "light contact on an isotropic Gaussian surface",
        Assumes::Gaussian => "any load; known to read low at light load",
        Assumes::Amplitudes | Assumes::Fractal => "",
    }
}

/// An assumption that is strained.
struct Strain {
    text: String,
    /// Only some loads strain it.
    by_load: bool,
}

impl Strain {
    fn of_surface(text: String) -> Self {
        Self { text, by_load: false }
    }

    fn of_load(text: String) -> Self {
        Self { text, by_load: true }
    }
}

/// Assumptions that this surface or these loads strain, with the numbers.
fn strains(
    entry: &ModelEntry,
    inputs: &Inputs,
    curve: &ModelCurve,
    loads: &[DeterministicPoint],
    statistics: &SurfaceStatistics,
) -> Vec<Strain> {
    let mut reasons = Vec::new();
    if matches!(entry.assumes, Assumes::Summits | Assumes::Gaussian) {
        if let Some(ratio) = statistics.anisotropy.filter(|r| *r > 2.0) {
            let text = format!("the surface has a lay (slopes {ratio:.1} : 1)");
            reasons.push(Strain::of_surface(text));
        }
        if let (Some(skewness), Some(kurtosis)) = (statistics.skewness, statistics.kurtosis)
            && (skewness.abs() > 0.2 || (kurtosis - 3.0).abs() > 0.3)
        {
            let text = format!("skewness {}, kurtosis {}", plain(skewness), plain(kurtosis));
            reasons.push(Strain::of_surface(text));
        }
    }
    match entry.assumes {
        Assumes::Summits => {
            // Summits begin to feel each other well before the caveat at 10 %.
            let crowded = curve
                .points
                .iter()
                .zip(loads)
                .find(|(m, _)| m.as_ref().is_ok_and(|s| s.area_fraction > 0.05));
            if let Some((_, load)) = crowded {
                reasons.push(Strain::of_load(format!(
                    "area exceeds 5\u{202F}% from {}, where summits no longer act alone",
                    pressure(load.mean_pressure)
                )));
            }
        }
        Assumes::Amplitudes => {
            if let Some(amplitudes) = &inputs.amplitudes {
                let steepest = amplitudes.waves().iter().max_by(|a, b| {
                    (a.amplitude * a.frequency).total_cmp(&(b.amplitude * b.frequency))
                });
                reasons.push(Strain::of_surface(format!(
                    "its input sits at λ = {} and depends on the record length ({})",
                    steepest.map_or("–".into(), |w| length(1.0 / w.frequency)),
                    length(amplitudes.record_length())
                )));
            }
        }
        Assumes::Fractal => {
            if let (Some(d), Some([short, long])) = (inputs.dimension, statistics.fractal_range) {
                reasons.push(Strain::of_surface(format!(
                    "D = {} from the fit between {} and {}; another range gives another D",
                    plain(d),
                    length(short),
                    length(long)
                )));
            }
        }
        Assumes::Gaussian => {}
    }
    reasons.extend(caveat(curve, loads).map(Strain::of_load));
    let failed = curve.points.iter().filter(|p| p.is_err()).count();
    if failed > 0 {
        let text = format!("no answer at {failed} of {} loads", curve.points.len());
        reasons.push(Strain::of_load(text));
    }
    reasons
}

/// The model's own caveat that is not about area, which is judged above.
fn caveat(curve: &ModelCurve, loads: &[DeterministicPoint]) -> Option<String> {
    curve.points.iter().zip(loads).find_map(|(point, load)| {
        match point.as_ref().ok()?.caveat.as_ref()? {
            Caveat::BeyondModel { quantity, value, limit, reason }
                if quantity != "area fraction" =>
            {
                Some(format!("{quantity} {} beyond {}: {reason}", plain(*value), plain(*limit)))
            }
            Caveat::Saturated { .. } => {
                Some(format!("full contact from {}", pressure(load.mean_pressure)))
            }
            _ => None,
        }
    })
}
