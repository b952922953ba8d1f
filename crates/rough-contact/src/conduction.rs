//! `--resistivity`, `--conductivity`: what a contact conducts.

use crate::outcome::Failure;
use crate::quantity::{self, QuantityError};
use crate::text;
use crate::units::Dimension;
use answers::Conducted;
use answers::bodies::Bodies;
use clap::Args;
use compare::Estimate;
use compare::Property;

/// A number of each body.
#[derive(Clone, Copy, Debug)]
enum Both {
    Given([f64; 2]),
    /// Those of the materials.
    Table,
}

#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Conduction {
    /// Resistivity of both bodies, or of each, as 22nohm.m,70nohm.m; `table` for that of two materials: the
    /// electrical conductance of each contact
    #[arg(long, value_name = "RHO[,RHO]", value_parser = resistivities, allow_hyphen_values = true)]
    resistivity: Option<Both>,
    /// Thermal conductivity of both bodies, or of each, as 400W/m/K,50W/m/K; `table` for that of two
    /// materials: the thermal conductance of each contact
    #[arg(long, value_name = "K[,K]", value_parser = conductivities, allow_hyphen_values = true)]
    conductivity: Option<Both>,
}

impl Conduction {
    /// What is asked of the contact.
    pub(crate) fn asked(self, bodies: &mut Bodies) -> Result<answers::Conduction, Failure> {
        let mut of = |both: Option<Both>, property, option: &str| match both {
            None => Ok(None),
            Some(Both::Given(values)) => Ok(Some(values)),
            Some(Both::Table) => bodies.of_both(property).map(Some).map_err(|failure| {
                failure.adding(&format!("give --material twice, or {option} in numbers"))
            }),
        };
        Ok(answers::Conduction {
            resistivities: of(self.resistivity, Property::Resistivity, "--resistivity")?,
            conductivities: of(self.conductivity, Property::Conductivity, "--conductivity")?,
        })
    }

    /// Whether anything is.
    pub(crate) fn is_asked(self) -> bool {
        self.resistivity.is_some() || self.conductivity.is_some()
    }
}

fn resistivities(text: &str) -> Result<Both, QuantityError> {
    both(text, Dimension::Resistivity)
}

fn conductivities(text: &str) -> Result<Both, QuantityError> {
    both(text, Dimension::Conductivity)
}

fn both(text: &str, dimension: Dimension) -> Result<Both, QuantityError> {
    if text.trim().eq_ignore_ascii_case("table") {
        return Ok(Both::Table);
    }
    let refused = |why| QuantityError::NotThese { text: text.to_owned(), why };
    let values = quantity::parse_list(text, dimension)?;
    if values.iter().any(|v| *v < 0.0) {
        return Err(refused("it must not be negative; 0 is a limit that is allowed"));
    }
    match values[..] {
        [both] => Ok(Both::Given([both, both])),
        [first, second] => Ok(Both::Given([first, second])),
        _ => Err(refused("give one number for both bodies, or two, one for each")),
    }
}

/// Headings of the table.
pub(crate) fn headings(asked: &answers::Conduction) -> Vec<&'static str> {
    let both = asked.is_asked().then_some(["stiffness", "±", "± sample"]);
    let electrical = asked.resistivities.map(|_| "electrical");
    let thermal = asked.conductivities.map(|_| "thermal");
    both.into_iter().flatten().chain(electrical).chain(thermal).collect()
}

/// What must be known about the numbers.
pub(crate) fn line(asked: &answers::Conduction) -> &'static str {
    if !asked.is_asked() {
        return "";
    }
    "conductance of the contact alone, per nominal area: clean metal, spots larger than the free path of \
     what carries the current; no film, no current through the gap. It is proportional to the stiffness: the ± of one \
     is that of the other\n"
}

/// What a load conducts, as cells of its row, with the errors of its stiffness.
pub(crate) fn cells(found: &Conducted, stiffness: Option<Estimate>) -> Vec<String> {
    let per_area = |unit: &'static str| move |value: f64| format!("{value:.3e} {unit}");
    let bar = |ends: Option<[f64; 2]>| text::relative(found.stiffness, ends, text::stiffness);
    let own = stiffness.and_then(|k| k.interval().ok());
    let sample = stiffness.and_then(|k| k.prediction());
    let mut cells = vec![shown(found.stiffness, text::stiffness), bar(own), bar(sample)];
    cells.extend(found.electrical.map(|value| shown(value, per_area("S/m²"))));
    cells.extend(found.thermal.map(|value| shown(value, per_area("W/m²/K"))));
    cells
}

fn shown(value: f64, text: impl Fn(f64) -> String) -> String {
    if value.is_finite() { text(value) } else { "∞".to_owned() }
}
