//! What a study answers beyond its loads, and what is incomplete about it.

use crate::failure::Failure;
use crate::shown;
use contact_compare::{Comparison, Listener, Reached, StudyError};
use contact_report::plan_reason;

/// What is computed once the loads are: coarser grids, the shortest octaves taken off, a closer look at the headline.
///
/// # Errors
/// [`Failure`] of what was not finished.
pub fn look_around(
    comparison: &mut Comparison,
    listener: &mut Listener<'_>,
) -> Result<(), Failure> {
    let incomplete = |(stage, why): (&str, StudyError)| Failure::incomplete(stage, why.to_string());
    comparison.look_around(listener).map_err(incomplete)
}

fn not_converged(comparison: &Comparison) -> Option<Failure> {
    let mut lines = Vec::new();
    for surface in &comparison.surfaces {
        for point in &surface.deterministic {
            if let Some(trouble) = &point.trouble {
                let pressure = shown::pressure(point.mean_pressure);
                lines.push(format!("{}, {pressure}: {trouble}", surface.name));
            }
        }
    }
    (!lines.is_empty()).then(|| Failure::incomplete("not_converged", lines.join("\n")))
}

/// Surfaces without a study, loads that did not converge, and plans that miss the accuracy asked for.
pub fn not_met(comparison: &Comparison) -> Option<Failure> {
    let unmet = comparison
        .surfaces
        .iter()
        .filter_map(|surface| unmet(&surface.name, surface.plan.as_ref()?));
    let refused = comparison.refused.iter().map(|r| {
        let message = if r.reason.contains(&r.name) {
            r.reason.clone()
        } else {
            format!("{}: {}", r.name, r.reason)
        };
        Failure::incomplete("files_failed", format!("no answer: {message}"))
    });
    refused.chain(not_converged(comparison)).chain(unmet).reduce(Failure::and)
}

/// A request that is not met ends with exit status 1.
pub(crate) fn unmet(surface: &str, reached: &Reached) -> Option<Failure> {
    let reason = plan_reason(reached)?;
    let percent = 100.0 * reached.request?.relative();
    let of = if surface.is_empty() { String::new() } else { format!("{surface}: ") };
    let message = format!("{of}an accuracy of {percent} % of the area is not met: {reason}");
    Some(Failure::incomplete("accuracy_not_met", message))
}
