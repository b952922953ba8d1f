//! `--hardness`: what is said of a contact that yields, beside its numbers.

use crate::text;
use rough_contact::compare::{BULK_YIELD, Hardness, typical_hardness};
use rough_contact::front_end::shown::unusual_hardness;
use rough_contact::surface_stats::SurfaceStatistics;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// What stands below the table; `highest` is the largest mean pressure that was solved for (Pa).
pub(crate) fn lines(given: Hardness, highest: f64) -> String {
    let mut out = format!("hardness {}", text::pressure(given.pascals));
    if let Some(ratio) = given.indices(None).modulus_gradient_over_hardness {
        let _ = write!(
            out,
            ": E* g/H = {}; the area of elastic contact holds while that is below about 1",
            text::number(ratio)
        );
    }
    out.push('\n');
    if let Some(said) = unusual_hardness(given) {
        let _ = writeln!(out, "check the hardness: {said}");
    }
    if highest > BULK_YIELD * given.pascals {
        let _ = writeln!(
            out,
            "beyond {} of the hardness the body yields in its volume, which is not modelled",
            text::percent(BULK_YIELD)
        );
    }
    out + "one hardness at every scale; nothing hardens or piles up; loading only, no friction\n"
}

/// Whether the contact of heights with these statistics will yield: text and object. Nothing is solved for.
pub(crate) fn forecast(
    modulus: f64,
    hardness: Option<f64>,
    s: &SurfaceStatistics,
) -> (String, Value) {
    let limit = modulus * s.rms_gradient;
    let yields = typical_hardness(modulus).is_some();
    let mut object = json!({
        "modulus": modulus,
        "hardness": hardness,
        "elastic_limit": (yields && limit > 0.0).then_some(limit),
    });
    let Some(pascals) = hardness else {
        let text = if yields {
            format!(
                "E* g = {}: for a hardness of that or more the area of elastic contact is right to 2 %\n",
                text::pressure(limit)
            )
        } else {
            "solids of this contact modulus do not yield in a contact\n".to_owned()
        };
        return (text, object);
    };
    let given = Hardness { pascals, modulus, gradient: Some(s.rms_gradient) };
    let found = given.indices(s.asperities);
    object["modulus_gradient_over_hardness"] = json!(found.modulus_gradient_over_hardness);
    object["greenwood_williamson"] = json!(found.greenwood_williamson);
    object["mikic"] = json!(found.mikic);
    object["warning"] = json!(unusual_hardness(given));
    let number = |value: Option<f64>| text::or_dash(value, text::number);
    let verdict = if found.modulus_gradient_over_hardness.is_some_and(|r| r <= 1.0) {
        "the area of elastic contact is right to 2 % at any load"
    } else {
        "the contact yields: solve and compare take --hardness"
    };
    let mut text = format!(
        "E* g/H = {}: {verdict}\nplasticity indices: Greenwood–Williamson {} (summits elastic below 0.6, plastic above 1: \
         1966), Mikic {} (E* m/H, = E* g/H over √π; no limit of it could be read)\n",
        number(found.modulus_gradient_over_hardness),
        number(found.greenwood_williamson),
        number(found.mikic)
    );
    if let Some(said) = unusual_hardness(given) {
        let _ = writeln!(text, "check the hardness: {said}");
    }
    (text, object)
}
