//! What is said of a contact that yields, beside its numbers.

use crate::shown;
use contact_compare::Hardness;
use fft_bem_solver::Solution;
use serde_json::{Value, json};

/// Why the hardness is likely a slip.
pub fn unusual(given: Hardness) -> Option<String> {
    let [low, high] = given.unusual()?;
    Some(format!(
        "solids with this contact modulus have a hardness of about {} to {}: is the unit right?",
        shown::pressure(low),
        shown::pressure(high)
    ))
}

/// What stands beside the points.
pub(crate) fn object(given: Hardness) -> Value {
    json!({
        "pascals": given.pascals,
        "modulus_gradient_over_hardness": given.over_elastic(),
        "warning": unusual(given),
    })
}

/// Adds what has yielded to a point.
pub(crate) fn add(point: &mut Value, solution: &Solution) {
    let Some(yielded) = solution.diagnostics.yielded else { return };
    if let Value::Object(keys) = point {
        keys.extend(contact_report::yield_keys(Some(yielded), solution.touching_fraction()));
    }
}

/// The same keys, absent, in a point that was refused.
pub(crate) fn complete(point: &mut Value) {
    for (key, null) in contact_report::yield_keys(None, 0.0) {
        if point.get(&key).is_none() {
            point[key] = null;
        }
    }
}
