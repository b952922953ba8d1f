//! The answers of a model over the loads, whichever model it is.

use crate::needs::Inputs;
use crate::result::ModelCurve;
use crate::theory::{BuildError, Theory};
use contact_types::{Clock, ContactModel, ContactState, ModelError};
use std::hint::black_box;
use std::time::Duration;

/// The answer of the model of this `name`. Theories that add up contacts know no upper end of the area; a surface does.
///
/// # Errors
/// [`ModelError::OutsideDomain`] where more than the whole surface would touch.
pub fn possible(name: &str, state: ContactState) -> Result<ContactState, ModelError> {
    // Rounding may lift full contact by some last digits.
    if state.area_fraction <= 1.0 + 1e-12 {
        return Ok(state);
    }
    Err(ModelError::OutsideDomain {
        model: name.to_owned().into(),
        quantity: "area fraction".into(),
        value: state.area_fraction,
        domain: 0.0..=1.0,
        reason: "more than the whole surface would touch; at this load the theory has no answer"
            .into(),
    })
}

/// For how long a model is asked again and again. The clock of a browser ticks more slowly than a pass takes.
const PASSES: Duration = Duration::from_millis(if cfg!(target_family = "wasm") { 20 } else { 2 });

/// A model's answers at nominal pressures (Pa) and its seconds per load: the median of passes over all loads, as many as
/// fit in [`PASSES`], at least three; in WebAssembly their mean.
fn timed(
    name: &str,
    model: &dyn ContactModel,
    mean_pressures: &[f64],
) -> (Vec<Result<ContactState, ModelError>>, f64) {
    let loads = mean_pressures.len().max(1) as f64;
    let pass = || -> Vec<_> {
        let ask = |p: &f64| possible(name, model.at_pressure(black_box(*p))?);
        mean_pressures.iter().map(ask).collect()
    };
    let begin = Clock::now();
    let mut passes: Vec<Duration> = Vec::new();
    let mut answers = Vec::new();
    while passes.len() < 3 || (begin.elapsed() < PASSES && passes.len() < 999) {
        let start = Clock::now();
        answers = black_box(pass());
        passes.push(start.elapsed());
    }
    let mean = begin.elapsed().as_secs_f64() / passes.len() as f64;
    passes.sort();
    let one =
        if cfg!(target_family = "wasm") { mean } else { passes[passes.len() / 2].as_secs_f64() };
    (answers, one / loads)
}

/// A theory's answers at nominal pressures (Pa). One that refuses every load does not apply: its reason is the outcome.
pub(crate) fn curve_of(
    theory: &dyn Theory,
    inputs: &Inputs,
    pressures: &[f64],
) -> Result<ModelCurve, BuildError> {
    let model = theory.build(inputs)?;
    let (points, seconds) = timed(&theory.card().title, model.as_ref(), pressures);
    if let Some(Err(first)) = points.first()
        && points.iter().all(Result::is_err)
    {
        return Err(BuildError::Model(first.clone()));
    }
    Ok(ModelCurve::of(model.as_ref(), points, seconds))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::built_in;

    /// At loads that close any contact.
    #[test]
    fn no_model_answers_more_than_everything() {
        let mut refused = Vec::new();
        for theory in built_in().iter() {
            let model = Inputs::examples().iter().find_map(|i| theory.build(i).ok()).unwrap();
            for exponent in 6..=13 {
                match model.at_pressure(10f64.powi(exponent)).and_then(|s| possible("it", s)) {
                    Ok(state) => assert!(state.area_fraction <= 1.0 + 1e-12, "{state:?}"),
                    Err(ModelError::OutsideDomain { quantity, value, domain, .. })
                        if quantity == "area fraction" =>
                    {
                        assert!(value > *domain.end());
                        refused.push(theory.card().name.clone());
                    }
                    Err(_) => {}
                }
            }
        }
        for name in ["gw", "bgt", "majumdar-bhushan", "archard"] {
            assert!(refused.iter().any(|r| r == name), "{name} has an answer at every load");
        }
    }
}
