//! What the page shows before anything is read.

use crate::message::Messages;
use crate::numbers::length;
use crate::trouble::Trouble;
use answers::Failure;
use compare::{STEEL, built_in_recipes};
use serde_json::{Value, json};
use surface_io::FORMATS;

/// Points per side of the pictures of built-in surfaces: a part of each at its own distance of points.
const PART: usize = 128;

pub(crate) fn answer(out: &mut Messages<'_>) -> Result<(), Trouble> {
    let recipes = built_in_recipes().map_err(|e| Failure::from_error(&e))?;
    let mut examples = Vec::with_capacity(recipes.len());
    for recipe in recipes {
        let mut part = recipe.clone();
        part.shape = recipe.shape.map(|n| n.min(PART));
        let map = part.heights().map_err(|e| Failure::from_error(&e))?;
        let picture = report::thumbnail(map.heights(), map.grid(), PART)
            .data_address()
            .map_err(|e| Failure::from_error(&e))?;
        let [ny, nx] = recipe.shape;
        examples.push(json!({
            "name": recipe.name, "description": recipe.description, "picture": picture,
            "size": format!("{} × {}", length(nx as f64 * recipe.pixel[1]), length(ny as f64 * recipe.pixel[0])),
            "points": format!("{ny} × {nx} points"),
        }));
    }
    let formats: Vec<Value> = FORMATS
        .iter()
        .map(|f| json!({ "name": f.format.name(), "endings": f.extensions }))
        .collect();
    out.tell(
        "done",
        json!({
            "version": env!("CARGO_PKG_VERSION"), "examples": examples, "formats": formats,
            "materials": [
                { "name": "Steel", "young": giga(STEEL.young), "poisson": STEEL.poisson.to_string() },
                { "name": "Rigid", "young": "∞", "poisson": "0" },
            ],
        }),
    );
    Ok(())
}

fn giga(pascals: f64) -> String {
    format!("{}", pascals / 1e9)
}
