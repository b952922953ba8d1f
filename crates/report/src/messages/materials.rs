//! Materials of the table, in words and for other programs.

use crate::numbers::{PASCALS, quantity, significant};
use contact_compare::{Listed, Material, MaterialUse, Property, material};
use contact_types::Named;
use serde_json::{Map, Value, json};

fn shown(property: Property, value: f64) -> String {
    match property {
        Property::Young | Property::Hardness => quantity(value, PASCALS, 3),
        Property::Poisson => significant(value, 2),
        Property::Resistivity => format!("{value:.3e} Ω m"),
        Property::Conductivity => format!("{} W/m/K", significant(value, 3)),
    }
}

fn letter(property: Property) -> &'static str {
    match property {
        Property::Young => "E",
        Property::Poisson => "ν",
        Property::Hardness => "H",
        Property::Resistivity => "ρ",
        Property::Conductivity => "k",
    }
}

/// "E = 117 GPa (117 GPa to 130 GPa)", "H = 398 MPa (HV)".
fn number(property: Property, listed: &Listed) -> String {
    let [low, high] = listed.range;
    let range =
        (high > low).then(|| format!("{} to {}", shown(property, low), shown(property, high)));
    let scale = (!listed.scale.is_empty()).then(|| listed.scale.to_owned());
    let beside: Vec<String> = range.into_iter().chain(scale).collect();
    let beside =
        if beside.is_empty() { String::new() } else { format!(" ({})", beside.join("; ")) };
    format!("{} = {}{beside}", letter(property), shown(property, listed.value))
}

/// Where numbers were read, each place once.
fn places<'a>(numbers: impl Iterator<Item = &'a Listed>) -> String {
    let mut all: Vec<&str> = Vec::new();
    for (_, place) in numbers.flat_map(|listed| &listed.sources) {
        if !all.contains(place) {
            all.push(place);
        }
    }
    all.join("; ")
}

fn heading(found: &Material) -> String {
    format!("{} ({}; {})", found.name, found.title, found.condition)
}

/// What was taken of a material, with its condition and sources, as plain text.
pub fn material_line(used: &MaterialUse) -> String {
    let Ok(found) = material(&used.name) else { return used.name.clone() };
    let taken: Vec<_> = used.taken.iter().filter_map(|p| Some((*p, found.get(*p)?))).collect();
    if taken.is_empty() {
        return format!("{}: no number of the table is used", heading(found));
    }
    let numbers: Vec<String> = taken.iter().map(|(p, listed)| number(*p, listed)).collect();
    let read = places(taken.iter().map(|(_, listed)| *listed));
    format!("{}: {}. Typical values, read in: {read}", heading(found), numbers.join(", "))
}

/// All that the table knows of a material, a line for each number, as plain text.
pub fn material_in_full(found: &Material) -> String {
    let mut out = heading(found) + "\n";
    for property in Property::all() {
        let line = found.get(property).map_or_else(
            || format!("{}: no number that a source could be named for", letter(property)),
            |listed| {
                let note = if listed.note.is_empty() { "" } else { "; " };
                // With the keys that notes name them by.
                let place = |(key, place): &(&str, &str)| format!("{key} {place}");
                let read = listed.sources.iter().map(place).collect::<Vec<_>>().join("; ");
                format!("{}; {read}{note}{}", number(property, listed), listed.note)
            },
        );
        out += &format!("  {}\n", line.replace('\u{202F}', " "));
    }
    out
}

/// A material and these numbers of it. SI units.
pub fn material_json(found: &Material, properties: impl IntoIterator<Item = Property>) -> Value {
    let mut numbers = Map::new();
    for property in properties {
        let listed = found.get(property).map(|listed| {
            json!({
                "value": listed.value,
                "range": listed.range,
                "scale": Some(listed.scale).filter(|s| !s.is_empty()),
                "sources": listed.sources.iter().map(|(_, place)| place).collect::<Vec<_>>(),
                "note": Some(listed.note).filter(|n| !n.is_empty()),
            })
        });
        numbers.insert(property.name().to_owned(), json!(listed));
    }
    json!({
        "name": found.name, "title": found.title, "condition": found.condition, "numbers": numbers,
    })
}

/// The materials whose numbers were taken, with these.
pub fn materials_json(used: &[MaterialUse]) -> Value {
    let one = |used: &MaterialUse| {
        material(&used.name).ok().map(|m| material_json(m, used.taken.iter().copied()))
    };
    used.iter().map(one).collect()
}
