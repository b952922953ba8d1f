//! A table of materials: Young's modulus, Poisson's ratio, hardness, resistivity, conductivity, each with its
//! range and where it was read.
//!
//! Typical values of data sheets and collections, at room temperature and in one condition each. Two batches of one
//! material differ by more than two pages: they are to begin with, not to end with.

use contact_types::Named;
use serde::{Deserialize, Serialize};
use std::sync::OnceLock;

const TABLE: &str = include_str!("../data/materials.tsv");
const SOURCES: &str = include_str!("../data/sources.tsv");

/// Projected area of a Vickers indentation over that of its pyramid, the sine of half the angle between
/// opposite faces (136°): HV is force over the latter, the pressure that a body bears over the former.
const VICKERS: f64 = 0.927_183_854_566_787_4;

/// What the table knows of a material.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Property {
    /// Young's modulus (Pa).
    Young,
    /// Poisson's ratio \[-\].
    Poisson,
    /// Mean pressure of an indentation (Pa).
    Hardness,
    /// Electrical resistivity (Ω m).
    Resistivity,
    /// Thermal conductivity (W/m/K).
    Conductivity,
}

impl Named for Property {
    const NAMES: &'static [(Self, &'static str)] = &[
        (Self::Young, "young"),
        (Self::Poisson, "poisson"),
        (Self::Hardness, "hardness"),
        (Self::Resistivity, "resistivity"),
        (Self::Conductivity, "conductivity"),
    ];
}

/// One number of a material.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Listed {
    /// The number. SI.
    pub value: f64,
    /// Spread of the sources, not a tolerance.
    pub range: [f64; 2],
    /// How a hardness was measured: `HV`, `HK`, `HB`, `ball` or `indentation`; else empty.
    pub scale: &'static str,
    /// Where it was read: the key by which notes name it, as `S21`, and the place, as `olinbrass.com C26000`.
    pub sources: Vec<(&'static str, &'static str)>,
    /// What to know about it.
    pub note: &'static str,
}

/// A material in one condition.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Material {
    /// What it is asked for by, as `steel-304`.
    pub name: &'static str,
    /// What it is.
    pub title: &'static str,
    /// In which condition.
    pub condition: &'static str,
    numbers: Vec<(Property, Listed)>,
}

impl Material {
    /// What the table knows of it; `None` where no source could be named.
    pub fn get(&self, property: Property) -> Option<&Listed> {
        self.numbers.iter().find(|(p, _)| *p == property).map(|(_, listed)| listed)
    }
}

/// A material of the table whose numbers were used.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MaterialUse {
    /// Its name.
    pub name: String,
    /// What was taken from the table; the others were given, or not asked for.
    pub taken: Vec<Property>,
}

/// The table, in its order.
pub fn materials() -> &'static [Material] {
    static READ: OnceLock<Vec<Material>> = OnceLock::new();
    READ.get_or_init(|| {
        let mut all: Vec<Material> = Vec::new();
        for line in TABLE.lines().filter(|line| !line.starts_with('#')) {
            let mut fields = line.split('\t');
            let mut next = || fields.next().unwrap_or("");
            let (name, title, condition, quantity) = (next(), next(), next(), next());
            let numbers = [next(), next(), next()].map(|x| x.parse().unwrap_or(f64::NAN));
            let (scale, sources, note) = (next(), next(), next());
            let Some(property) = Property::of_name(quantity) else {
                continue; // a test holds that there is none
            };
            let [value, low, high] =
                if scale == "HV" { numbers.map(|x: f64| x / VICKERS) } else { numbers };
            // A test holds that every key is listed.
            let sources = sources.split(' ').map(|key| (key, source_of(key))).collect();
            let listed = Listed { value, range: [low, high], scale, sources, note };
            if all.last().is_none_or(|m| m.name != name) {
                all.push(Material { name, title, condition, numbers: Vec::new() });
            }
            if let Some(material) = all.last_mut() {
                material.numbers.push((property, listed));
            }
        }
        all
    })
}

/// Relative half widths of contact modulus and hardness that the table leaves, of what was taken from it: the logarithm
/// to the farther end of the range, of one source alone the median of the others. The least known modulus counts, and the
/// hardness of the softest.
pub(crate) fn spreads(used: &[MaterialUse]) -> [f64; 2] {
    let taken = |property: Property| {
        let of = used.iter().filter(move |u| u.taken.contains(&property));
        of.filter_map(move |u| material(&u.name).ok()?.get(property))
    };
    let modulus =
        taken(Property::Young).map(|listed| spread(listed, Property::Young)).fold(0.0, f64::max);
    let softest = taken(Property::Hardness).min_by(|a, b| a.value.total_cmp(&b.value));
    [modulus, softest.map_or(0.0, |listed| spread(listed, Property::Hardness))]
}

fn spread(listed: &Listed, property: Property) -> f64 {
    let own =
        |Listed { value, range: [low, high], .. }: &Listed| (high / value).max(value / low).ln();
    if own(listed) > 0.0 {
        return own(listed);
    }
    let all = materials().iter().filter_map(|m| m.get(property)).map(own);
    contact_accuracy::median(all.filter(|s| *s > 0.0)).unwrap_or(0.0)
}

/// The material of this name, in any case.
///
/// # Errors
/// Names like it, if there is none.
pub fn material(name: &str) -> Result<&'static Material, Vec<&'static str>> {
    let asked = name.trim().to_ascii_lowercase().replace(['_', ' '], "-");
    let all = materials();
    if let Some(found) = all.iter().find(|m| m.name == asked) {
        return Ok(found);
    }
    // A kind of material, or part of a name; else what is spelled most like it.
    let holds = |m: &&Material| {
        m.name.contains(&asked) || m.title.to_ascii_lowercase().contains(&asked.replace('-', " "))
    };
    let mut near: Vec<&'static str> = all.iter().filter(holds).map(|m| m.name).collect();
    if asked.is_empty() || near.is_empty() {
        let mut by_distance: Vec<_> =
            all.iter().map(|m| (distance(&asked, m.name), m.name)).collect();
        by_distance.sort_unstable();
        near = by_distance.into_iter().take(3).map(|(_, name)| name).collect();
    }
    Err(near)
}

/// Where a source is; empty if it is not listed.
fn source_of(key: &str) -> &'static str {
    let mut listed = SOURCES.lines().filter_map(|line| line.split_once('\t'));
    listed.find(|(k, _)| *k == key).map_or("", |(_, place)| place)
}

/// Insertions, deletions and changes of letters between two words (Levenshtein).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut corner = i;
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let changed = corner + usize::from(x != *y);
            corner = row[j + 1];
            row[j + 1] = changed.min(row[j] + 1).min(corner + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every line was read; materials without Poisson's ratio are those without a source of one.
    #[test]
    fn every_number_has_a_source() {
        let lines = TABLE.lines().filter(|line| !line.starts_with('#')).count();
        let all = materials();
        assert_eq!(all.iter().map(|m| m.numbers.len()).sum::<usize>(), lines);
        let without: Vec<&str> =
            all.iter().filter(|m| m.get(Property::Poisson).is_none()).map(|m| m.name).collect();
        assert_eq!(without, ["zirconia", "dlc-ach", "dlc-tac", "ptfe", "peek", "pmma"]);
        for m in all {
            assert!(m.get(Property::Young).is_some(), "{}", m.name);
            assert!(!m.condition.is_empty() && !m.title.is_empty());
            for (property, listed) in &m.numbers {
                let [low, high] = listed.range;
                let what = format!("{} {property:?}", m.name);
                assert!(low <= listed.value && listed.value <= high && low > 0.0, "{what}");
                assert!(!listed.sources.is_empty(), "{what}");
                assert!(listed.sources.iter().all(|(_, place)| !place.is_empty()), "{what}");
                let is_hardness = *property == Property::Hardness;
                assert_eq!(is_hardness, !listed.scale.is_empty(), "{what}");
            }
        }
    }

    /// Metals obey Wiedemann and Franz, `ρ k = L T` with L = 2.44e-8 W Ω/K² at 293 K, to a quarter; alloys have
    /// phonons beside: a slip of a unit would be a factor of ten.
    #[test]
    fn metals_conduct_heat_as_they_conduct_charge() {
        let mut metals = 0;
        for m in materials() {
            let [rho, k] = [Property::Resistivity, Property::Conductivity].map(|p| m.get(p));
            let Some((rho, k)) = rho.zip(k).filter(|(rho, _)| rho.value < 1e-5) else { continue };
            let over = rho.value * k.value / (2.44e-8 * 293.0);
            let most = if rho.value > 5e-7 { 1.8 } else { 1.3 };
            assert!((0.8..most).contains(&over), "{}: {over}", m.name);
            metals += 1;
        }
        assert!(metals >= 15, "{metals}");
    }

    #[test]
    fn names_are_found_and_near_ones_offered() {
        assert_eq!(material("Steel_304").map(|m| m.name), Ok("steel-304"));
        let near = |name: &str| material(name).expect_err("no material");
        assert_eq!(near("steel"), ["steel-100cr6", "steel-304", "steel-316", "steel-1020"]);
        assert_eq!(near("stainless"), ["steel-304", "steel-316"]);
        assert_eq!(near("cooper")[0], "copper");
        assert_eq!(near("").len(), 3);
        for (a, b, edits) in [("kitten", "sitting", 3), ("", "ab", 2), ("ab", "ab", 0)] {
            assert_eq!(distance(a, b), edits);
        }
    }

    /// HV 129 is 129 kgf on a square millimetre of the pyramid.
    #[test]
    fn a_hardness_is_the_pressure_of_its_indentation() {
        let h = material("steel-304").expect("in the table").get(Property::Hardness).expect("H");
        let exact = 129.0 * 9.80665e6 / 68f64.to_radians().sin();
        assert!((h.value / exact - 1.0).abs() < 1e-4, "{}", h.value);
    }
}
