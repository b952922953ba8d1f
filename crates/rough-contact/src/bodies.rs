//! `--modulus`, `--young`, `--poisson`, `--material`: what the bodies are made of; `rough-contact materials`, the table.

use crate::args;
use crate::outcome::{Failure, Reply};
use crate::text::{self, Columns};
use crate::units::Dimension::{Number, Pressure};
use clap::Args;
use rough_contact::compare::{Material, Property, STEEL, materials};
use rough_contact::contact_types::Named;
use rough_contact::front_end::bodies::{Bodies, BodyInput, BothBodies, known};
use rough_contact::report;
use serde_json::json;

/// The elastic constants, given or those of the table.
#[derive(Args, Clone, Debug)]
pub(crate) struct BodyOptions {
    /// Contact modulus E*, 1/E* = sum of (1 - nu^2)/E over both bodies
    #[arg(long, value_name = "E", value_parser = args::one(Pressure), allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["young", "poisson"])]
    modulus: Option<f64>,
    /// Young's modulus, instead of --modulus; twice for two elastic bodies
    #[arg(long, value_name = "E", value_parser = args::one(Pressure), allow_hyphen_values = true)]
    young: Vec<f64>,
    /// Poisson's ratio to each --young
    #[arg(long, value_name = "NU", value_parser = args::one(Number), allow_hyphen_values = true)]
    poisson: Vec<f64>,
    /// Material, as copper, in place of these, with its hardness; two for two bodies, as steel-304,copper. Own numbers override
    /// those of the table that `rough-contact materials` shows
    #[arg(long, value_name = "NAME[,NAME]", value_delimiter = ',')]
    material: Vec<String>,
}

impl BodyOptions {
    /// Steel on steel, with the same materials.
    pub(crate) fn steel(&self) -> Self {
        let [young, poisson] = [STEEL.young, STEEL.poisson].map(|number| vec![number; 2]);
        Self { young, poisson, ..self.clone() }
    }

    /// An elastic constant that was typed in.
    pub(crate) fn typed(&self) -> Option<&'static str> {
        let bodies = [(&self.young, "--young"), (&self.poisson, "--poisson")];
        let typed = bodies.iter().find(|(given, _)| !given.is_empty());
        self.modulus.map(|_| "--modulus").or(typed.map(|(_, name)| *name))
    }

    /// In numbers, with this hardness of the softer body, infinite for `elastic`; `None` if nothing was given of them.
    pub(crate) fn given(&self, hardness: Option<f64>) -> Result<Option<Bodies>, Failure> {
        let found = self.asked(hardness)?.resolve();
        let way_out = "`rough-contact materials` shows the table; --young, --poisson, --hardness take any number";
        found.map_err(|failure| failure.adding(if self.material.is_empty() { "" } else { way_out }))
    }

    /// The same; an error if they were not given.
    pub(crate) fn required(&self, hardness: Option<f64>) -> Result<Bodies, Failure> {
        self.given(hardness)?.ok_or_else(|| {
            Failure::refused(
                "usage",
                "the contact modulus is missing; give --modulus E*, for example --modulus 110GPa, \
                 --young 210GPa --poisson 0.3, or --material copper, twice for two elastic bodies",
            )
        })
    }

    /// The options, one body each.
    fn asked(&self, hardness: Option<f64>) -> Result<BothBodies, Failure> {
        let [young, poisson, materials] =
            [self.young.len(), self.poisson.len(), self.material.len()];
        let refused = |message| Err(Failure::refused("usage", message));
        if materials > 2 {
            return refused(format!("--material given {materials} times; two bodies touch"));
        }
        if materials == 0 && (young != poisson || young > 2) {
            return refused(format!(
                "--young given {young} times and --poisson {poisson} times; give both once \
                 (the other body is rigid) or both twice"
            ));
        }
        for (option, count) in [("--young", young), ("--poisson", poisson)] {
            if materials > 0 && count > 0 && count != materials {
                return refused(format!(
                    "{option} given {count} times and --material {materials} times; give it for each material, \
                     or not at all"
                ));
            }
        }
        let body = |i: usize| BodyInput {
            material: self.material.get(i).cloned(),
            young: self.young.get(i).copied(),
            poisson: self.poisson.get(i).copied(),
            hardness: None,
        };
        Ok(BothBodies {
            modulus: self.modulus,
            bodies: (0..materials.max(young)).map(body).collect(),
            hardness: hardness.filter(|h| *h != f64::INFINITY),
            elastic: hardness == Some(f64::INFINITY),
        })
    }
}

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
