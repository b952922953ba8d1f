//! What the bodies and loads come to, before they are computed.

use crate::numbers::{count, pressure};
use crate::pace::{Pace, StudyCost};
use crate::place::Host;
use crate::request::{Facts, LoadBy, Request};
use crate::trouble::Trouble;
use contact_compare::{EdgesName, Property, Settings, loads_of_study};
use contact_front_end::Failure;
use contact_report::numbers::{PASCALS, duration, quantity};
use contact_types::ContactModulus;
use serde_json::{Value, json};

/// Modulus, loads and cost, as the page says them.
pub(crate) fn answer(request: &Request) -> Result<Value, Trouble> {
    let facts = request.facts;
    let settings = request.settings(facts.map_or(1.0, |f| f.area))?;
    let bears = bears(&settings, !request.hardness.trim().is_empty());
    let modulus = ContactModulus::from_pascals(settings.modulus).map_err(|e| Failure::from(&e))?;
    let pressures = match (facts, &settings.pressures) {
        (Some(facts), _) => Some(loads_of_study(&settings, modulus, facts.gradient)),
        (None, given) => given.clone(),
    };
    let said = pressures.as_deref().map(|list| loads(list, request.load.by));
    let pace = Pace::after(request.pace, request.place)?;
    let cost = facts.zip(pressures.as_ref()).map(|(facts, list)| {
        // Bodies that yield are solved as elastic ones, too; what a contact conducts is half a load more.
        let each = if settings.hardness.is_some() { 2.0 } else { 1.0 };
        let each = if settings.joint().is_asked() { 1.5 * each } else { each };
        cost(facts, settings.edges, each * list.len() as f64, (request.place, pace))
    });
    Ok(json!({
        "pace": pace,
        "modulus": format!("Together they act as one elastic body of contact modulus E* = {}.", pressure(settings.modulus)),
        "bears": bears,
        "loads": said, "count": pressures.map(|list| list.len()), "cost": cost,
    }))
}

fn bears(settings: &Settings, is_given: bool) -> String {
    let softer = settings.materials.iter().find(|m| m.taken.contains(&Property::Hardness));
    match (settings.hardness, softer) {
        (Some(h), Some(softer)) => format!(
            "They yield at {}, the hardness of {} in the table of materials.",
            quantity(h, PASCALS, 3),
            softer.name
        ),
        (Some(h), None) => format!("They yield at {}.", quantity(h, PASCALS, 3)),
        (None, _) if is_given => "They are elastic, whatever they bear.".to_owned(),
        (None, _) => "No hardness of them is known: they are elastic at any pressure. The result says where solids of \
                      this modulus would yield."
            .to_owned(),
    }
}

fn loads(pressures: &[f64], by: LoadBy) -> String {
    let low = pressures.iter().copied().fold(f64::INFINITY, f64::min);
    let high = pressures.iter().copied().fold(0.0, f64::max);
    let (low, high) = (pressure(low), pressure(high));
    let range = match pressures.len() {
        1 => format!("One load: {low} over the nominal area."),
        n => format!("{n} loads: {low} to {high} over the nominal area."),
    };
    match by {
        LoadBy::Auto => format!("{range} From about 0.1 % to half of this surface touching."),
        LoadBy::Pressure => format!("{range} Force over the whole map, not over the spots."),
        LoadBy::Force => range,
    }
}

fn cost(facts: Facts, edges: EdgesName, loads: f64, (place, pace): (Host, Pace)) -> String {
    let points = if edges == EdgesName::Mirrored { 4.0 * facts.points } else { facts.points };
    let memory = place.memory(points);
    let [low, high] = memory.map(|bytes| two(bytes / 1e6));
    let work = StudyCost { points: facts.points, solved: points, loads };
    let [short, long] = pace.seconds(work).map(duration);
    let warning = place.too_much(memory[1]).map(|warning| format!(". {warning}"));
    format!(
        "{} points; about {short} and {low} MB of memory, up to {long} and {high} MB where the grid has to be refined{}",
        count(points as usize),
        warning.unwrap_or_default()
    )
}

fn two(value: f64) -> f64 {
    let unit = 10f64.powf(value.log10().floor() - 1.0);
    (value / unit).round() * unit
}
