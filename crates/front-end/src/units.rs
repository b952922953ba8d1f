//! Units that people type, by kind of quantity.

/// What kind of quantity an option takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Dimension {
    /// A pure number, written without a unit; a percentage is one too.
    Number,
    /// Metres.
    Length,
    /// Square metres.
    Area,
    /// Per square metre.
    PerArea,
    /// Pascals.
    Pressure,
    /// Newtons.
    Force,
    /// Ohm metres.
    Resistivity,
    /// Watts per metre and kelvin.
    Conductivity,
    /// Joules per square metre.
    #[serde(rename = "energy_per_area")]
    Adhesion,
    /// Pascal seconds.
    Viscosity,
}

/// A unit: its names, parted by spaces, and a factor and a power of ten that make it one of SI.
type UnitScale = (&'static str, f64, i32);

const LENGTHS: &[UnitScale] = &[
    ("m", 1.0, 0),
    ("cm", 1.0, -2),
    ("mm", 1.0, -3),
    ("um micron microns", 1.0, -6),
    ("nm", 1.0, -9),
    ("A angstrom", 1.0, -10),
    ("pm", 1.0, -12),
    ("fm", 1.0, -15),
    ("km", 1.0, 3),
    ("in inch inches", 254.0, -4), // 25.4 mm exactly, since 1959
    ("mil mils thou", 254.0, -7),
];

const PRESSURES: &[UnitScale] = &[
    ("Pa N/m^2", 1.0, 0),
    ("hPa mbar", 1.0, 2),
    ("kPa", 1.0, 3),
    ("MPa N/mm^2", 1.0, 6),
    ("GPa kN/mm^2", 1.0, 9),
    ("TPa", 1.0, 12),
    ("mPa", 1.0, -3),
    ("uPa", 1.0, -6),
    ("bar", 1.0, 5),
    ("atm", 101_325.0, 0),
    ("kbar", 1.0, 8),
    ("kgf/mm^2", 980_665.0, 1), // standard gravity, 9.80665 m/s^2
    ("kgf/cm^2", 980_665.0, -1),
    // 0.45359237 kg of standard gravity on (25.4 mm)^2.
    ("psi", 0.453_592_37 * 9.806_65 / (0.0254 * 0.0254), 0),
    ("ksi", 0.453_592_37 * 9.806_65 / (0.0254 * 0.0254), 3),
];

const FORCES: &[UnitScale] = &[
    ("N", 1.0, 0),
    ("kN", 1.0, 3),
    ("MN", 1.0, 6),
    ("mN", 1.0, -3),
    ("uN", 1.0, -6),
    ("nN", 1.0, -9),
    ("pN", 1.0, -12),
    ("kgf", 980_665.0, -5),
    ("gf", 980_665.0, -8),
    ("lbf", 0.453_592_37 * 9.806_65, 0),
];

/// Units of resistivity, written without what stands between their parts.
const RESISTIVITIES: &[UnitScale] = &[
    ("ohmm", 1.0, 0),
    ("mohmm", 1.0, -3),
    ("uohmm", 1.0, -6),
    ("nohmm", 1.0, -9),
    ("ohmcm", 1.0, -2),
    ("uohmcm", 1.0, -8),
];

/// Units of thermal conductivity, likewise.
const CONDUCTIVITIES: &[UnitScale] =
    &[("W/m/K W/mK", 1.0, 0), ("mW/m/K mW/mK", 1.0, -3), ("W/cm/K", 1.0, 2)];

const ADHESIONS: &[UnitScale] =
    &[("J/m^2 N/m", 1.0, 0), ("mJ/m^2 mN/m erg/cm^2", 1.0, -3), ("uJ/m^2", 1.0, -6)];

/// Units of viscosity, written without what stands between their parts.
const VISCOSITIES: &[UnitScale] =
    &[("Pas kg/ms", 1.0, 0), ("mPas cP", 1.0, -3), ("uPas", 1.0, -6), ("P", 1.0, -1)];

/// What people write who mean a unit of the table: kilograms and pounds are masses.
const MEANT: &[(Dimension, &str, &str)] = &[
    (Dimension::Force, "kg", "kgf"),
    (Dimension::Force, "g", "gf"),
    (Dimension::Force, "lb", "lbf"),
    (Dimension::Force, "lbs", "lbf"),
    (Dimension::Pressure, "kg/mm^2", "kgf/mm^2"),
    (Dimension::Pressure, "kg/cm^2", "kgf/cm^2"),
    (Dimension::Pressure, "kpsi", "ksi"),
];

/// How quantities of a dimension are written.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spelling {
    pub(crate) kind: &'static str,
    pub(crate) si: &'static str,
    pub(crate) units: &'static str,
    /// Units for a number that has none, parted by spaces.
    pub(crate) suggested: &'static str,
    pub(crate) example: &'static str,
    pub(crate) range: &'static str,
}

impl Dimension {
    pub(crate) fn spelling(self) -> Spelling {
        let [kind, si, units] = match self {
            Self::Number => ["a pure number", "", "no unit, or %"],
            Self::Length => ["length", "m", "m, mm, um, nm, A, inch or mil"],
            Self::Area => ["area", "m^2", "m^2, mm^2, um^2 or nm^2"],
            Self::PerArea => ["number per area", "m^-2", "m^-2, mm^-2, um^-2 or nm^-2"],
            Self::Pressure => ["pressure", "Pa", "Pa, kPa, MPa, GPa, bar, psi, kgf/mm^2 or N/mm^2"],
            Self::Force => ["force", "N", "N, kN, mN, uN, nN, kgf or lbf"],
            Self::Resistivity => ["resistivity", "ohm.m", "ohm.m, uohm.m, nohm.m or uohm.cm"],
            Self::Conductivity => ["thermal conductivity", "W/m/K", "W/m/K"],
            Self::Adhesion => ["work of adhesion", "J/m^2", "J/m^2, mJ/m^2 or mN/m"],
            Self::Viscosity => ["viscosity", "Pa.s", "Pa.s, mPa.s, uPa.s or cP"],
        };
        let [suggested, example, range] = match self {
            Self::Number => ["", "for example 0.8", "0.1..10:5"],
            Self::Length => ["um nm", "for example 1.5um", "1nm..1um:16"],
            Self::Area => ["um^2 nm^2", "for example 0.2nm^2", "1nm^2..1um^2:16"],
            Self::PerArea => ["m^-2 um^-2", "for example 3e12m^-2", "1mm^-2..1um^-2:16"],
            Self::Pressure => ["MPa GPa", "for example 50MPa", "1kPa..1GPa:16"],
            Self::Force => ["N kN", "for example 10N", "1N..1kN:16"],
            Self::Resistivity => ["nohm.m uohm.cm", "for example 22nohm.m", "10nohm.m..1uohm.m:16"],
            Self::Conductivity => ["W/m/K", "for example 50W/m/K", "1W/m/K..100W/m/K:16"],
            Self::Adhesion => ["mJ/m^2", "for example 50mJ/m^2", "1mJ/m^2..1J/m^2:16"],
            Self::Viscosity => ["mPa.s Pa.s", "for example 1mPa.s", "1mPa.s..1Pa.s:16"],
        };
        Spelling { kind, si, units, suggested, example, range }
    }

    /// Factor and power of ten of a unit; `None` if it is not a unit of this dimension.
    pub(crate) fn scale(self, unit: &str) -> Option<(f64, i32)> {
        let find = |table: &[UnitScale], unit: &str| {
            let named = |(names, ..): &&UnitScale| names.split(' ').any(|name| name == unit);
            table.iter().find(named).map(|&(_, f, e)| (f, e))
        };
        match self {
            Self::Number => match unit {
                "" => Some((1.0, 0)),
                "%" => Some((1.0, -2)),
                _ => None,
            },
            Self::Length => find(LENGTHS, unit),
            Self::Area => find(LENGTHS, unit.strip_suffix("^2")?).map(|(f, e)| (f * f, 2 * e)),
            Self::PerArea => {
                let length = unit.strip_suffix("^-2").or_else(|| {
                    let squared = unit.strip_prefix("1/").or_else(|| unit.strip_prefix('/'))?;
                    squared.strip_suffix("^2")
                })?;
                find(LENGTHS, length).map(|(f, e)| (1.0 / (f * f), -2 * e))
            }
            Self::Pressure => find(PRESSURES, unit),
            Self::Force => find(FORCES, unit),
            Self::Resistivity => find(RESISTIVITIES, &unit.replace(['.', '*', '-'], "")),
            Self::Conductivity => find(CONDUCTIVITIES, &unit.replace(['.', '*', '(', ')'], "")),
            Self::Adhesion => find(ADHESIONS, unit),
            Self::Viscosity => find(VISCOSITIES, &unit.replace(['.', '*', '-'], "")),
        }
    }

    /// The units with these letters in other cases. An `M` is mega and an `m` may be meant for it, so that of
    /// `mpa` there are two. Of a mass the weight.
    pub(crate) fn near(self, unit: &str) -> Vec<&'static str> {
        let table = match self {
            Self::Length => LENGTHS,
            Self::Pressure => PRESSURES,
            Self::Force => FORCES,
            _ => return Vec::new(),
        };
        let is_meant = |m: &&(Self, &str, &str)| m.0 == self && m.1.eq_ignore_ascii_case(unit);
        if let Some((_, _, meant)) = MEANT.iter().find(is_meant) {
            return vec![meant];
        }
        let names = table.iter().flat_map(|(names, ..)| names.split(' '));
        let near: Vec<&str> = names.filter(|name| name.eq_ignore_ascii_case(unit)).collect();
        let capital = unit.get(..1).filter(|first| first.starts_with(char::is_uppercase));
        match near.iter().find(|name| capital.is_some_and(|first| name.starts_with(first))) {
            Some(only) => vec![only],
            None => near,
        }
    }
}

/// A unit in one spelling: `µm²` is `um^2`.
pub(crate) fn plain(unit: &str) -> String {
    let mut out = String::new();
    for c in unit.chars().filter(|c| !c.is_whitespace()) {
        match c {
            'µ' | 'μ' => out.push('u'),
            'Å' | '\u{212b}' => out.push('A'),
            'Ω' | '\u{2126}' => out.push_str("ohm"),
            '·' => out.push('.'),
            '²' => out.push_str("^2"),
            '⁻' => out.push_str("^-"),
            other => out.push(other),
        }
    }
    // From a superscript minus followed by a superscript two.
    let out = out.replace("^-^2", "^-2");
    // "um2", "N/mm2" and "m-2": the caret is often left out.
    for (short, long) in [("-2", "^-2"), ("2", "^2")] {
        if let Some(base) = out.strip_suffix(short)
            && base.ends_with(|c: char| c.is_ascii_alphabetic())
        {
            return format!("{base}{long}");
        }
    }
    out
}
