//! What the page shows before anything is read.

use crate::numbers::length;
use crate::place::Host;
use crate::trouble::Trouble;
use contact_compare::{Property, STEEL, built_in_recipes, materials};
use contact_front_end::Failure;
use contact_report::numbers::{PASCALS, quantity};
use serde_json::{Value, json};
use surface_io::FORMATS;

/// Points per side of the pictures of built-in surfaces: a part of each at its own distance of points.
const PART: usize = 128;

pub(crate) fn answer(place: Host) -> Result<Value, Trouble> {
    let recipes = built_in_recipes();
    let mut examples = Vec::with_capacity(recipes.len());
    for recipe in recipes {
        let mut part = recipe.clone();
        part.shape = recipe.shape.map(|n| n.min(PART));
        let map = part.make().map_err(|e| Failure::from(&e))?.heights;
        let (picture, _) = contact_report::height_picture(map.heights(), map.grid(), PART);
        let [ny, nx] = recipe.shape;
        examples.push(json!({
            "name": recipe.name, "description": recipe.description, "picture": picture,
            "size": format!("{} × {}", length(nx as f64 * recipe.pixel[1]), length(ny as f64 * recipe.pixel[0])),
            "points": format!("{ny} × {nx} points"),
        }));
    }
    let formats: Vec<Value> =
        FORMATS.iter().map(|f| json!({ "name": f.name, "endings": f.extensions })).collect();
    Ok(json!({
        "version": env!("CARGO_PKG_VERSION"), "examples": examples, "formats": formats,
        "materials": table(), "place": place.json(),
    }))
}

/// Materials whose modulus and Poisson's ratio have a source; steel, as the defaults of the command have it; rigid.
fn table() -> Vec<Value> {
    let one = |name: &str, title: &str, young: String, poisson: String, said: String| json!({ "name": name, "title": title, "young": young, "poisson": poisson, "said": said });
    let giga = |pascals: f64| (pascals / 1e9).to_string();
    let mut all = vec![
        one("", "Steel", giga(STEEL.young), STEEL.poisson.to_string(), "Common values.".to_owned()),
        one("", "Rigid", "∞".to_owned(), "0".to_owned(), "Does not deform.".to_owned()),
    ];
    for material in materials() {
        let number = |property| material.get(property);
        let (Some(young), Some(poisson)) = (number(Property::Young), number(Property::Poisson))
        else {
            continue;
        };
        let mut sources: Vec<_> = young.sources.iter().chain(&poisson.sources).collect();
        sources.sort_unstable();
        sources.dedup();
        let places: Vec<&str> = sources.into_iter().map(|(_, place)| *place).collect();
        let hardness = number(Property::Hardness).map_or_else(String::new, |hardness| {
            format!(" Hardness {}.", quantity(hardness.value, PASCALS, 3))
        });
        let (condition, places) = (material.condition, places.join("; "));
        let [low, high] = young.range.map(giga);
        let said = format!(
            "{condition}.{hardness} Sources: {places}. E from {low} to {high} GPa among them."
        );
        let [young, poisson] = [giga(young.value), poisson.value.to_string()];
        all.push(one(material.name, material.title, young, poisson, said));
    }
    all
}
