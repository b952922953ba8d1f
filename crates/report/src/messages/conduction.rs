//! What a contact conducts, in words and numbers.

use crate::numbers::{
    AREAS, KELVINS_PER_WATT, METRES, OHMS, PASCALS, SPACE, power_of_ten, quantity, quantity_within,
    significant,
};
use contact_compare::{Conducted, Conduction, Joint, SurfaceComparison};
use contact_types::Named;

/// A kind of conductance: what it is called and its units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConductanceKind {
    pub(crate) name: &'static str,
    pub(crate) resistance: &'static str,
    /// Unit of the resistance of a unit of area.
    pub(crate) of_area: &'static str,
    /// Per area, in letters that every program reads.
    pub(crate) plain_unit: &'static str,
    /// Per stiffness.
    pub(crate) factor: f64,
}

const KINDS: [[&str; 4]; 2] =
    [["electrical", "Ω", "Ω m²", "S/m^2"], ["thermal", "K/W", "K m²/W", "W/m^2/K"]];

/// Those that were asked for.
pub(crate) fn kinds(found: &Conduction) -> Vec<ConductanceKind> {
    let kind =
        |([name, resistance, of_area, plain_unit], factor): ([&'static str; 4], Option<f64>)| {
            Some(ConductanceKind { name, resistance, of_area, plain_unit, factor: factor? })
        };
    KINDS.into_iter().zip(found.factors).filter_map(kind).collect()
}

/// A resistance of the part in words: what is resisted, "1.20 ± 0.05 mΩ", and that of one spot of the same load and
/// hardness, if that is known.
pub(crate) type ResistanceWords = (&'static str, String, Option<String>);

/// Those of the part, if its area is known.
pub fn resistances(found: &Conducted) -> Vec<ResistanceWords> {
    let kinds = [("Contact resistance", OHMS), ("Thermal resistance", KELVINS_PER_WATT)];
    let each = kinds.into_iter().zip(found.resistances().into_iter().zip(found.one_spot));
    each.filter_map(|((name, units), (r, spot))| {
        let (value, stated) = (r?.value, r?.prediction.or(r?.interval));
        let shown = |value: f64, ends: Option<[f64; 2]>| match value {
            r if r.is_infinite() => "∞".to_owned(),
            r if r <= 0.0 => quantity(0.0, units, 3),
            r => quantity_within(r, ends, units),
        };
        let one_spot = spot.map(|spot| shown(spot, None));
        Some((name, shown(value, stated), one_spot))
    })
    .collect()
}

/// "Thermal resistance 30 ± 3 mK/W at 10 MPa (one spot 16.5 K/W)" for each, in plain text.
pub(crate) fn resistance_lines(surface: &SurfaceComparison) -> Vec<String> {
    let at = super::headline_load(surface);
    let line = |(name, value, spot): ResistanceWords| {
        let spot = spot.map_or_else(String::new, |spot| format!(" (one spot {spot})"));
        format!("{name} {value} at {at}{spot}").replace(SPACE, " ")
    };
    surface.conducted(surface.headline).iter().flat_map(resistances).map(line).collect()
}

/// Knudsen numbers at which slip, transition and free flight of the molecules begin.
const REGIMES: [f64; 3] = [0.01, 0.1, 10.0];
/// Stefan and Boltzmann's constant (W/m²/K⁴).
const STEFAN_BOLTZMANN: f64 = 5.670_374_419e-8;

/// What is in the gap of this joint, with its regime at these mean gaps (m), and of what the resistances are.
pub fn joint_words(joint: &Joint, gaps: &[f64]) -> String {
    let mut text = match &joint.gas {
        None if joint.conductivities.is_some() => "Vacuum in the gap.".to_owned(),
        None => String::new(),
        Some(gas) => {
            let widest = gaps.iter().copied().fold(0.0, f64::max);
            let narrowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
            let knudsen = [widest, narrowest].map(|gap| gas.free_path() / gap);
            let regime = match knudsen[1] {
                k if k < REGIMES[0] => "continuum",
                k if k <= REGIMES[1] => "slip",
                k if k <= REGIMES[2] => "transition, where M is an approximation",
                _ => "free-molecular",
            };
            let regime = match knudsen.map(|k| significant(k, 2)) {
                _ if widest <= 0.0 || narrowest <= 0.0 => String::new(),
                [k, other] if k == other => format!("; free path over mean gap {k}: {regime}"),
                [k, other] => format!("; free path over mean gap {k} to {other}: {regime}"),
            };
            let (name, temperature) = (gas.gas.name(), significant(gas.temperature, 3));
            let (pressure, jump) =
                (quantity(gas.pressure, PASCALS, 3), quantity(gas.jump(), METRES, 2));
            let [a, b] = gas.accommodation.map(|a| significant(a, 2));
            let k = significant(gas.conductivity(), 3);
            let radiation = significant(4.0 * STEFAN_BOLTZMANN * gas.temperature.powi(3), 2);
            format!(
                "In the gap {name} at {temperature}{SPACE}K and {pressure}, {k}{SPACE}W/m/K, jumps of temperature M = {jump} (accommodation {a} and {b}; at 1 it conducts most){regime}. Far-field radiation adds at most {radiation}{SPACE}W/m²/K."
            )
        }
    };
    if let Some(area) = joint.area {
        if !text.is_empty() {
            text.push(' ');
        }
        text.push_str(&format!("Resistances of {}.", quantity(area, AREAS, 4)));
    }
    text
}

/// Conductance of a stiffness: nothing without contact, and no end of it in full contact between bodies that
/// conduct; an insulator lets nothing through either way.
pub(crate) fn conductance(kind: ConductanceKind, stiffness: f64) -> f64 {
    if stiffness <= 0.0 || kind.factor <= 0.0 { 0.0 } else { stiffness * kind.factor }
}

/// "2.16 × 10¹⁰ S/m²", "∞ S/m²".
pub(crate) fn scientific(value: f64, unit: &str) -> String {
    let number = match value {
        v if v.is_infinite() => "∞".into(),
        v if v <= 0.0 => "0".into(),
        v if (0.01..1e4).contains(&v) => significant(v, 3),
        v => {
            let exponent = v.log10().floor();
            let mantissa = significant(v / 10f64.powf(exponent), 3);
            format!("{mantissa} × {}", power_of_ten(exponent as i32))
        }
    };
    format!("{number}{SPACE}{unit}")
}
