//! `--resistivity`, `--conductivity`: what a contact conducts.

use crate::outcome::Failure;
use crate::quantity::{self, QuantityError};
use crate::text;
use crate::units::Dimension;
use clap::Args;
use contact_types::ContactModulus;
use fft_bem_solver::{Conductors, SetStiffness, Solver};
use serde_json::{Value, json};

/// Two numbers, one for each body.
#[derive(Clone, Copy, Debug)]
struct Pair([f64; 2]);

#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Conduction {
    /// Resistivity of both bodies, or of each, as 22nohm.m,70nohm.m: the electrical conductance of
    /// each contact
    #[arg(long, value_name = "RHO[,RHO]", value_parser = resistivities, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["accuracy", "stiffness", "plane_strain"])]
    resistivity: Option<Pair>,
    /// Thermal conductivity of both bodies, or of each, as 400W/m/K,50W/m/K: the thermal conductance
    /// of each contact
    #[arg(long, value_name = "K[,K]", value_parser = conductivities, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["accuracy", "stiffness", "plane_strain"])]
    conductivity: Option<Pair>,
}

fn resistivities(text: &str) -> Result<Pair, QuantityError> {
    pair(text, Dimension::Resistivity)
}

fn conductivities(text: &str) -> Result<Pair, QuantityError> {
    pair(text, Dimension::Conductivity)
}

fn pair(text: &str, dimension: Dimension) -> Result<Pair, QuantityError> {
    let refused = |why| QuantityError::NotThese { text: text.to_owned(), why };
    let values = quantity::parse_list(text, dimension)?;
    if values.iter().any(|v| *v < 0.0) {
        return Err(refused("it must not be negative; 0 is a limit that is allowed"));
    }
    match values[..] {
        [both] => Ok(Pair([both, both])),
        [first, second] => Ok(Pair([first, second])),
        _ => Err(refused("give one number for both bodies, or two, one for each")),
    }
}

impl Conduction {
    /// Headings of the table.
    pub(crate) fn headings(self) -> Vec<&'static str> {
        let asked = self.resistivity.is_some() || self.conductivity.is_some();
        let stiffness = asked.then_some("stiffness");
        let electrical = self.resistivity.map(|_| "electrical");
        stiffness
            .into_iter()
            .chain(electrical)
            .chain(self.conductivity.map(|_| "thermal"))
            .collect()
    }

    /// Adds what the contact of the last solution conducts to a point and its row. `area` is that of the
    /// map (m²).
    pub(crate) fn add(
        self,
        point: &mut Value,
        cells: &mut Vec<String>,
        solver: &mut Solver,
        area: f64,
    ) -> Result<(), Failure> {
        if self.headings().is_empty() {
            return Ok(());
        }
        let modulus = solver.modulus();
        let set = solver.contact_stiffness().map_err(|e| Failure::from_error(&e))?;
        point["stiffness"] = finite(set.per_area);
        point["contact_set"] = json!(match set.per_area {
            k if k <= 0.0 => "none",
            k if k.is_finite() => "part",
            _ => "everything",
        });
        point["conduction"] = json!({
            "residual": set.residual, "transforms": set.transforms, "iterations": set.iterations,
        });
        cells.push(shown(set.per_area, text::stiffness));
        let of = |pair: Option<Pair>, kind: fn([f64; 2]) -> Conductors| {
            pair.map(|Pair(values)| conductance(&set, modulus, kind(values))).transpose()
        };
        let electrical = of(self.resistivity, Conductors::Resistivities)?;
        let thermal = of(self.conductivity, Conductors::Conductivities)?;
        for (key, found, unit) in
            [("electrical", electrical, "S/m²"), ("thermal", thermal, "W/m²/K")]
        {
            let Some(found) = found else { continue };
            point[format!("{key}_conductance")] = finite(found);
            point[format!("{key}_conductance_interval")] = Value::Null;
            point[format!("{key}_conductance_of_map")] = finite(found * area);
            cells.push(shown(found, |value| format!("{value:.3e} {unit}")));
        }
        Ok(())
    }

    /// What must be known about the numbers.
    pub(crate) fn line(self) -> &'static str {
        if self.headings().is_empty() {
            return "";
        }
        "conductance of the contact alone, per nominal area: clean metal, spots larger than the free path of \
         what carries the current; no film, no current through the gap. It has no ± yet: from 4 to 16 points \
         per shortest wave it moved by at most 0.6 %, of yielding contact by 1.6 %; another map of the surface was \
         not studied\n"
    }
}

fn conductance(
    set: &SetStiffness,
    modulus: ContactModulus,
    conductors: Conductors,
) -> Result<f64, Failure> {
    set.conductance(modulus, conductors).map_err(|e| Failure::from_error(&e))
}

/// A number of JSON, which has no infinity: `contact_set` says what `null` is.
fn finite(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}

fn shown(value: f64, text: impl Fn(f64) -> String) -> String {
    if value.is_finite() { text(value) } else { "∞".to_owned() }
}
