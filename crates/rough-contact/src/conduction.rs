//! `--resistivity`, `--conductivity`, `--gas`: what a joint conducts.

use crate::loads::Forces;
use crate::outcome::Failure;
use crate::units::Dimension::{self, Conductivity, Pressure, Resistivity};
use crate::{args, quantity, text};
use clap::Args;
use rough_contact::compare::{Conductance, Conducted, Estimate, GapGas, Gas, Joint, Property};
use rough_contact::contact_types::Named;
use rough_contact::front_end::bodies::Bodies;
use rough_contact::report;

#[derive(Clone, Copy, Debug)]
enum Both {
    Given([f64; 2]),
    /// Those of the materials.
    Table,
}

/// None is vacuum.
#[derive(Clone, Copy, Debug)]
struct Filling(Option<Gas>);

#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct ConductionOptions {
    /// Resistivity of both bodies, or of each, as 22nohm.m,70nohm.m; `table` for that of two materials: the
    /// resistance to current
    #[arg(long, value_name = "RHO[,RHO]", value_parser = both(Resistivity), allow_hyphen_values = true)]
    resistivity: Option<Both>,
    /// Thermal conductivity of both bodies, or of each, as 400W/m/K,50W/m/K; `table` for that of two
    /// materials: the resistance to heat
    #[arg(long, value_name = "K[,K]", value_parser = both(Conductivity), allow_hyphen_values = true)]
    conductivity: Option<Both>,
    /// Gas in the gap, which conducts heat beside the contact: vacuum, air, helium, argon or nitrogen [default: vacuum]
    #[arg(long, value_name = "GAS", value_parser = filling, ignore_case = true)]
    gas: Option<Filling>,
    /// Its pressure [default: 1 atm]
    #[arg(long, value_name = "P", value_parser = args::one(Pressure), allow_hyphen_values = true)]
    gas_pressure: Option<f64>,
    /// Its temperature, as 350K or 80degC [default: 25degC]
    #[arg(long, value_name = "T", value_parser = temperature, allow_hyphen_values = true)]
    temperature: Option<f64>,
    /// Accommodation coefficients of the walls, above 0 to 1 [default: 1, at which the gas conducts most]
    #[arg(long, value_name = "A[,A]", value_parser = accommodation, allow_hyphen_values = true)]
    accommodation: Option<[f64; 2]>,
}

impl ConductionOptions {
    /// What is asked of the joint, of a part of this area (m²) if that is given.
    pub(crate) fn asked(self, bodies: &mut Bodies, area: Option<f64>) -> Result<Joint, Failure> {
        let mut of = |both: Option<Both>, property, option: &str| match both {
            None => Ok(None),
            Some(Both::Given(values)) => Ok(Some(values)),
            Some(Both::Table) => bodies
                .of_both(property)
                .map(Some)
                .map_err(|failure| failure.adding(&format!("give {option} in numbers"))),
        };
        let joint = Joint {
            resistivities: of(self.resistivity, Property::Resistivity, "--resistivity")?,
            conductivities: of(self.conductivity, Property::Conductivity, "--conductivity")?,
            gas: self.filled(),
            area,
            hardness: None,
        };
        if joint.gas.is_some() && joint.conductivities.is_none() {
            let message = "--gas conducts heat beside the contact, and nothing says how that does; give \
                           --conductivity K[,K] of the bodies";
            return Err(Failure::refused("usage", message));
        }
        let of_gas = self.gas_pressure.or(self.temperature).or(self.accommodation.map(|a| a[0]));
        if of_gas.is_some() && joint.gas.is_none() {
            let message = "--gas-pressure, --temperature and --accommodation are of a gas, and the gap is empty; give \
                           --gas, or leave them out";
            return Err(Failure::refused("usage", message));
        }
        joint.check().map_err(|e| Failure::from(&e))?;
        Ok(joint)
    }

    /// The same of the part that carries the forces, whose area has a use only where something is asked.
    pub(crate) fn of_part(self, bodies: &mut Bodies, forces: &Forces) -> Result<Joint, Failure> {
        if forces.area.is_some() && forces.load.is_none() && !self.is_asked() {
            let message = "--area is the area that --load presses on, or the part whose resistance is asked for, and neither \
                           --load nor --resistivity or --conductivity is given; give one, or leave --area out";
            return Err(Failure::refused("usage", message));
        }
        self.asked(bodies, forces.area.filter(|_| self.is_asked()))
    }

    /// The same, with the numbers of two materials where none are given.
    pub(crate) fn asked_of(self, bodies: &mut Bodies, area: Option<f64>) -> Result<Joint, Failure> {
        if self.is_asked() {
            return self.asked(bodies, area);
        }
        let mut of = |property| bodies.of_both(property).ok().map(Both::Given);
        let resistivity = of(Property::Resistivity);
        let conductivity = of(Property::Conductivity);
        Self { resistivity, conductivity, ..self }.asked(bodies, area)
    }

    fn is_asked(self) -> bool {
        self.resistivity.is_some() || self.conductivity.is_some()
    }

    fn filled(self) -> Option<GapGas> {
        let Filling(gas) = self.gas?;
        let usual = GapGas::new(gas?);
        Some(GapGas {
            temperature: self.temperature.unwrap_or(usual.temperature),
            pressure: self.gas_pressure.unwrap_or(usual.pressure),
            accommodation: self.accommodation.unwrap_or(usual.accommodation),
            ..usual
        })
    }
}

fn filling(text: &str) -> Result<Filling, String> {
    let name = text.trim().to_ascii_lowercase();
    match Gas::of_name(&name) {
        None if name != "vacuum" => Err("write vacuum, air, helium, argon or nitrogen".to_owned()),
        gas => Ok(Filling(gas)),
    }
}

fn temperature(text: &str) -> Result<f64, String> {
    let plain = text.trim().replace('°', "deg");
    let kelvin = plain.strip_suffix('K').map(|number| (number, 0.0));
    let celsius = || plain.strip_suffix("degC").or_else(|| plain.strip_suffix('C'));
    let found = kelvin.or_else(|| Some((celsius()?, 273.15)));
    let way_out = || format!("'{text}' is no temperature with its unit; write 350K or 80degC");
    let (number, zero) = found.ok_or_else(way_out)?;
    let value = quantity::parse(number, Dimension::Number).map_err(|e| e.to_string())? + zero;
    if value > 0.0 { Ok(value) } else { Err(format!("'{text}' is not above absolute zero")) }
}

fn accommodation(text: &str) -> Result<[f64; 2], Failure> {
    let both = pair(text, Dimension::Number, "walls")?;
    if both.iter().all(|a| *a > 0.0 && *a <= 1.0) {
        return Ok(both);
    }
    Err(not_these(text, "an accommodation coefficient is above 0 and at most 1"))
}

fn not_these(text: &str, why: &str) -> Failure {
    Failure::refused("not_these", format!("'{text}': {why}"))
}

/// One number for both, or two.
fn pair(text: &str, dimension: Dimension, of: &str) -> Result<[f64; 2], Failure> {
    match quantity::parse_list(text, dimension)?[..] {
        [both] => Ok([both, both]),
        [first, second] => Ok([first, second]),
        _ => {
            let count = format!("give one number for both {of}, or two, one for each");
            Err(not_these(text, &count))
        }
    }
}

fn both(
    dimension: Dimension,
) -> impl Fn(&str) -> Result<Both, Failure> + Clone + Send + Sync + 'static {
    move |text| {
        if text.trim().eq_ignore_ascii_case("table") {
            return Ok(Both::Table);
        }
        pair(text, dimension, "bodies").map(Both::Given)
    }
}

pub(crate) fn first_headings(asked: &Joint, has_area: bool) -> Vec<&'static str> {
    let (current, heat) = (asked.resistivities.is_some(), asked.conductivities.is_some());
    let names = match (current, heat) {
        (true, true) => ["resistance", "thermal resistance"],
        (_, true) => ["", "resistance"],
        _ => ["resistance", ""],
    };
    let spot = asked.hardness.map(|_| "one spot");
    let each = [current, heat].into_iter().zip(names).filter(|(is_asked, _)| *is_asked && has_area);
    each.flat_map(|(_, name)| [name].into_iter().chain(spot)).collect()
}

/// What stands under the heading of this place: a resistance of the part, or of one spot; a dash where nothing was found.
pub(crate) fn first_cell(found: Option<&Conducted>, asked: &Joint, place: usize) -> String {
    let Some(found) = found else { return "–".to_owned() };
    let of = |(_, value, spot): (_, String, Option<String>)| {
        let spot = asked.hardness.map(|_| text::or_dash(spot, |spot| spot));
        [Some(value), spot].into_iter().flatten()
    };
    let cell = report::resistances(found).into_iter().flat_map(of).nth(place);
    cell.map_or_else(String::new, |cell| text::plain(&cell))
}

/// A conductance of a joint by its heading, with its unit.
type ConductanceColumn = (&'static str, fn(&Conducted) -> Option<Conductance>, &'static str);

/// Conductances per nominal area that are asked for.
pub(crate) fn columns(asked: &Joint) -> Vec<ConductanceColumn> {
    let (current, heat) = (asked.resistivities.is_some(), asked.conductivities.is_some());
    let all: [(bool, ConductanceColumn); 4] = [
        (current, ("electrical", |c| c.electrical, "S/m²")),
        (heat, ("thermal", |c| c.thermal, "W/m²/K")),
        (asked.gas.is_some(), ("gas", |c| c.gas, "W/m²/K")),
        (asked.gas.is_some(), ("joint", |c| c.joint, "W/m²/K")),
    ];
    all.into_iter().filter(|(is_asked, _)| *is_asked).map(|(_, column)| column).collect()
}

/// What must be known about the numbers, at these mean gaps (m).
pub(crate) fn line(asked: &Joint, gaps: &[f64]) -> String {
    if !asked.is_asked() {
        return String::new();
    }
    format!(
        "{} Clean bodies, spots larger than the free path of what carries the current; no film, plating or fritting; \
         beyond the column of bulk material\n",
        text::plain(&report::joint_words(asked, gaps))
    )
    .trim_start()
    .to_owned()
}

/// A conductance, with what is stated of it.
pub(crate) fn cell(found: Option<Conductance>, unit: &str) -> String {
    let Some(h) = found else { return String::new() };
    if !h.value.is_finite() {
        return "∞".to_owned();
    }
    let stated = h.estimate.as_ref().and_then(Estimate::stated);
    let value = format!("{:.3e} {unit}", h.value);
    match text::relative(h.value, stated, |v| format!("{v:.2e}")) {
        dash if dash == "–" => value,
        bar => format!("{value} {bar}"),
    }
}
