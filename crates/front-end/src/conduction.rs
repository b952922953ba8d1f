//! What a contact conducts.

use contact_accuracy::Budget;
use contact_compare::{Conducted, ContactModulus, Joint};
use fft_bem_solver::SetStiffness;
use serde_json::{Value, json};

/// Adds what the contact of a solution conducts to its point, if that was asked for.
pub(crate) fn add(
    (joint, modulus): (&Joint, ContactModulus),
    point: &mut Value,
    set: &SetStiffness,
    budget: &Budget,
) -> Option<Conducted> {
    if !joint.is_asked() {
        return None;
    }
    let found = joint.of_budget(set.per_area, budget, modulus);
    if let Value::Object(keys) = point {
        let of_set = match set.per_area {
            k if k <= 0.0 => "none",
            k if k.is_finite() => "part",
            _ => "everything",
        };
        let conduction = json!({
            "residual": set.residual, "transforms": set.transforms, "iterations": set.iterations,
        });
        let stiffness = Some(set.per_area).filter(|k| k.is_finite());
        keys.extend(contact_report::conducted_keys(&found));
        keys.insert("stiffness".into(), json!(stiffness));
        keys.insert("contact_set".into(), json!(of_set));
        keys.insert("conduction".into(), conduction);
    }
    Some(found)
}
