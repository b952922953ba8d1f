//! `--resistivity`, `--conductivity`: what a contact conducts.

use crate::quantity::{self, QuantityError};
use crate::text;
use crate::units::Dimension;
use answers::Conducted;
use clap::Args;

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

/// The same of a study.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct StudyConduction {
    /// Resistivity of both bodies, or of each, as 22nohm.m,70nohm.m: the study says what the contact conducts
    #[arg(long, value_name = "RHO[,RHO]", value_parser = resistivities, allow_hyphen_values = true)]
    #[arg(conflicts_with = "accuracy")]
    resistivity: Option<Pair>,
    /// Thermal conductivity of both bodies, or of each, as 400W/m/K,50W/m/K: the same for heat
    #[arg(long, value_name = "K[,K]", value_parser = conductivities, allow_hyphen_values = true)]
    #[arg(conflicts_with = "accuracy")]
    conductivity: Option<Pair>,
}

impl StudyConduction {
    /// Resistivities and conductivities, where they were given.
    pub(crate) fn given(self) -> [Option<[f64; 2]>; 2] {
        [self.resistivity, self.conductivity].map(|pair| pair.map(|Pair(values)| values))
    }
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

    /// What is asked of the solver.
    pub(crate) fn asked(self) -> answers::Conduction {
        let of = |pair: Option<Pair>| pair.map(|Pair(values)| values);
        answers::Conduction {
            resistivities: of(self.resistivity),
            conductivities: of(self.conductivity),
        }
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

/// What a load conducts, as cells of its row.
pub(crate) fn cells(found: &Conducted) -> Vec<String> {
    let per_area = |unit: &'static str| move |value: f64| format!("{value:.3e} {unit}");
    let mut cells = vec![shown(found.stiffness, text::stiffness)];
    cells.extend(found.electrical.map(|value| shown(value, per_area("S/m²"))));
    cells.extend(found.thermal.map(|value| shown(value, per_area("W/m²/K"))));
    cells
}

fn shown(value: f64, text: impl Fn(f64) -> String) -> String {
    if value.is_finite() { text(value) } else { "∞".to_owned() }
}
