//! `rough-contact materials`: the table.

use crate::outcome::{Failure, Reply};
use crate::text::{self, Columns};
use clap::Args;
use rough_contact::compare::{Material, Property, materials};
use rough_contact::contact_types::Named;
use rough_contact::front_end::bodies::known;
use rough_contact::report;
use serde_json::json;

#[derive(Args)]
pub(crate) struct Materials {
    /// Of these only, with range, source and notes of each number
    #[arg(value_name = "NAME")]
    names: Vec<String>,
}

const FOOT: &str = "typical values at room temperature, of pages and data sheets; batches of one material differ by more than \
two pages do. Hardness: the pressure of an indentation. `rough-contact materials NAME` shows range, source and notes\n";

impl Materials {
    pub(crate) fn run(&self) -> Result<Reply, Failure> {
        if self.names.is_empty() {
            let all: Vec<&Material> = materials().iter().collect();
            return Ok(Reply::new(table(&all), json(&all)));
        }
        let chosen = self.names.iter().map(|name| known(name)).collect::<Result<Vec<_>, _>>()?;
        let text: String = chosen.iter().map(|m| report::material_in_full(m) + "\n").collect();
        Ok(Reply::new(text, json(&chosen)))
    }
}

fn json(chosen: &[&Material]) -> serde_json::Value {
    let all: Vec<_> = chosen.iter().map(|m| report::material_json(m, Property::all())).collect();
    json!({ "materials": all })
}

fn table(chosen: &[&Material]) -> String {
    let mut columns =
        Columns::new(&["name", "E", "nu", "hardness", "resistivity", "conductivity", "condition"]);
    for m in chosen {
        let cell = |property, show: fn(f64) -> String| {
            text::or_dash(m.get(property), |listed| show(listed.value))
        };
        columns.row([
            m.name.to_owned(),
            cell(Property::Young, text::pressure),
            cell(Property::Poisson, |nu| format!("{nu}")),
            cell(Property::Hardness, text::pressure),
            cell(Property::Resistivity, |rho| format!("{rho:.2e} ohm.m")),
            cell(Property::Conductivity, |k| format!("{k} W/m/K")),
            m.condition.to_owned(),
        ]);
    }
    columns.to_string() + FOOT
}
