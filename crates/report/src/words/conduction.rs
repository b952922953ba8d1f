//! What a contact conducts, in words and numbers.

use crate::numbers::{METRES, SPACE, length, percent, power_of_ten, quantity, significant, times};
use compare::Conduction;

/// A kind of conductance: what it is called and its units, per area and of the part.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    pub(crate) per_area: &'static str,
    pub(crate) of_part: &'static str,
    /// Per area, in letters that every program reads.
    pub(crate) plain_unit: &'static str,
    /// Per stiffness.
    pub(crate) factor: f64,
}

/// Those that were asked for.
pub(crate) fn kinds(found: &Conduction) -> Vec<Kind> {
    let electrical = found.electrical.map(|factor| Kind {
        name: "electrical",
        per_area: "S/m²",
        of_part: "S",
        plain_unit: "S/m^2",
        factor,
    });
    let thermal = found.thermal.map(|factor| Kind {
        name: "thermal",
        per_area: "W/m²/K",
        of_part: "W/K",
        plain_unit: "W/m^2/K",
        factor,
    });
    electrical.into_iter().chain(thermal).collect()
}

/// Conductance of a stiffness: nothing without contact, and no end of it in full contact between bodies that
/// conduct; an insulator lets nothing through either way.
pub(crate) fn conductance(kind: Kind, stiffness: f64) -> f64 {
    if stiffness <= 0.0 || kind.factor <= 0.0 { 0.0 } else { stiffness * kind.factor }
}

/// "2.16 × 10¹⁰ S/m²", "∞ S/m²".
pub(crate) fn scientific(value: f64, unit: &str) -> String {
    if value.is_infinite() {
        return format!("∞{SPACE}{unit}");
    }
    if value <= 0.0 {
        return format!("0{SPACE}{unit}");
    }
    if (0.01..1e4).contains(&value) {
        return format!("{}{SPACE}{unit}", significant(value, 3));
    }
    let exponent = value.log10().floor();
    format!(
        "{} × {}{SPACE}{unit}",
        significant(value / 10f64.powf(exponent), 3),
        power_of_ten(exponent as i32)
    )
}

/// "12 %", "a factor of 3": a ratio of at least 1.
fn factor(ratio: f64) -> String {
    if ratio < 1.995 { percent(ratio - 1.0) } else { format!("a factor of {}", times(ratio)) }
}

/// Which of area and conductance depends on the shortest wave, with the numbers of this surface.
pub(crate) fn octaves(found: &Conduction) -> Option<String> {
    let [area, conductance] = found.changes()?;
    let removed = found.octaves.len() - 1;
    let last = found.octaves[removed];
    let first = found.octaves[0];
    let numbers = format!(
        "Without {}, that is without waves shorter than {} (the map has {} and longer), the area changes by up to \
         {}, the conductance by up to {}.",
        match removed {
            1 => "its shortest octave".to_owned(),
            n => format!("its {n} shortest octaves"),
        },
        length(last.shortest),
        quantity(first.shortest, METRES, 2),
        factor(area),
        factor(conductance)
    );
    let verdict = if found.is_sturdy()? {
        "The area depends on the shortest wave that was measured; the conductance hardly does."
    } else if area > conductance {
        "On this surface both depend on the shortest wave that was measured, the area more."
    } else if found.yovanovich.is_empty() {
        "On this surface the conductance depends on the shortest wave that was measured more than the area."
    } else {
        "On this surface the conductance depends on the shortest wave that was measured more than the area, \
         which nears load over hardness, whatever the waves, where all of the contact yields."
    };
    Some(format!("<b>{verdict}</b> {numbers}"))
}
