//! Closed-form models as objects.

use contact_compare::Card;
use contact_types::Citation;
use serde_json::{Value, json};

/// Where a theory was published.
pub(crate) fn citation(c: &Citation) -> Value {
    json!({
        "authors": c.authors, "year": c.year, "title": c.title, "journal": c.journal, "doi": c.doi,
    })
}

/// What a theory is.
pub fn card(card: &Card) -> Value {
    json!({
        "name": card.name,
        "title": card.title,
        "citation": citation(&card.citation),
        "inputs": card.needs,
        "domain": card.domain,
        "separation": card.has_separation,
    })
}
