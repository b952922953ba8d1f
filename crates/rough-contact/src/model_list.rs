//! `rough-contact model --list`: every model with its source, inputs and domain.

use crate::outcome::Reply;
use rough_contact::compare::{Theory, built_in};
use rough_contact::contact_types::Citation;
use rough_contact::front_end;
use serde_json::json;
use std::fmt::Write as _;

pub(crate) fn cited(c: &Citation) -> String {
    if c.doi.is_empty() {
        format!("{} {}", c.authors, c.year)
    } else {
        format!("{} {}, doi:{}", c.authors, c.year, c.doi)
    }
}

pub(crate) fn list() -> Reply {
    let mut text = String::new();
    let mut models = Vec::new();
    for card in built_in().iter().map(Theory::card) {
        let c = &card.citation;
        let doi = if c.doi.is_empty() { String::new() } else { format!(" doi:{}", c.doi) };
        let options = crate::roughness::options_of(card).join(", or ");
        let separation = if card.has_separation { "; --separation as well" } else { "" };
        // A String takes everything.
        let _ = writeln!(
            text,
            "{}: {}\n  {} ({}) {}. {}.{doi}\n  inputs: {}\n  domain: {}\n  options: {options}{separation}\n",
            card.name, card.title, c.authors, c.year, c.title, c.journal, card.needs, card.domain,
        );
        let mut object = front_end::models::card(card);
        object["options"] = json!(crate::roughness::options_of(card));
        models.push(object);
    }
    Reply::new(text, json!({ "models": models }))
}
