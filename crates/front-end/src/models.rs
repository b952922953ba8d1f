//! Closed-form models as objects.

use contact_compare::Card;
use serde_json::{Value, json};

/// What a theory is.
pub fn card(card: &Card) -> Value {
    json!({
        "name": card.name,
        "title": card.title,
        "citation": card.citation,
        "inputs": card.needs,
        "domain": card.domain,
        "separation": card.has_separation,
    })
}
