//! The two bodies: contact modulus and hardness of what was given of them, numbers or names of the table of materials.

use crate::failure::Failure;
use contact_compare::{Body, Inputs, Listed, Material, MaterialUse, Property, material};
use contact_types::{ContactModulus, Elastic, SurfaceError};
use serde::{Deserialize, Serialize};

/// What is given of a body that deforms. Own numbers come before those of the table. SI units.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BodyInput {
    /// Name in the table of materials.
    pub material: Option<String>,
    /// Young's modulus (Pa).
    pub young: Option<f64>,
    /// Poisson's ratio \[-\].
    pub poisson: Option<f64>,
    /// Hardness (Pa).
    pub hardness: Option<f64>,
}

/// What is given of two bodies. Every front end asks by this, so that all know the same of a material.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BothBodies {
    /// Contact modulus E* (Pa), before the elastic constants.
    pub modulus: Option<f64>,
    /// One against a rigid body, or two.
    pub bodies: Vec<BodyInput>,
    /// Hardness of the softer body (Pa), before those of the bodies.
    pub hardness: Option<f64>,
    /// The bodies do not yield, whatever is known of their hardness.
    pub elastic: bool,
}

/// The two bodies in numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Bodies {
    /// Contact modulus E*.
    pub modulus: ContactModulus,
    /// The elastic bodies it is made of; none if E* was given.
    pub bodies: Vec<Body>,
    /// Hardness of the softer body (Pa); `None` for elastic bodies, or where it is not known.
    pub hardness: Option<f64>,
    /// What was taken from the table.
    pub materials: Vec<MaterialUse>,
}

impl Bodies {
    /// Bodies of which nothing is known but the hardness of the softer one (Pa): those of a theory without elasticity.
    pub fn rigid(hardness: Option<f64>) -> Self {
        let modulus = ContactModulus::RIGID;
        Self { modulus, bodies: Vec::new(), hardness, materials: Vec::new() }
    }

    /// With what no roughness says.
    #[must_use]
    pub fn add(&self, inputs: Inputs) -> Inputs {
        Inputs {
            hardness: self.hardness,
            poisson: contact_compare::poisson(&self.bodies),
            ..inputs
        }
    }

    /// A number of both bodies out of the table, noted as taken.
    ///
    /// # Errors
    /// [`Failure`] where fewer than two materials were given, or one has no such number.
    pub fn of_both(&mut self, property: Property) -> Result<[f64; 2], Failure> {
        let name = name_of(property);
        let [first, second] = &self.materials[..] else {
            let message = format!(
                "the {name} of the table is that of two materials; give two, or the numbers"
            );
            return Err(Failure::refused("material", message));
        };
        let number = |used: &MaterialUse| {
            let known = known(&used.name)?;
            known.get(property).map(|l| l.value).ok_or_else(|| missing(known, property))
        };
        let both = [number(first)?, number(second)?];
        self.materials.iter_mut().for_each(|used| used.taken.push(property));
        Ok(both)
    }
}

impl BothBodies {
    /// The bodies in numbers; `None` if neither a modulus nor a body was given.
    ///
    /// # Errors
    /// [`Failure`] of constants out of their domain, a name that is not in the table, or a number that it lacks.
    pub fn resolve(&self) -> Result<Option<Bodies>, Failure> {
        let mut given = self.bodies.iter().filter_map(|body| body.hardness).chain(self.hardness);
        if let Some(wrong) = given.find(|h| !(*h > 0.0 && h.is_finite())) {
            let message = format!(
                "hardness {wrong} Pa: a hardness is a pressure above 0 Pa, for example 2GPa; leave it out for \
                 elastic contact"
            );
            return Err(Failure::refused("hardness", message));
        }
        let listed: Vec<Option<&Material>> = self
            .bodies
            .iter()
            .map(|body| body.material.as_deref().map(known).transpose())
            .collect::<Result<_, _>>()?;
        let bodies = match self.modulus {
            Some(_) => Vec::new(),
            None => self
                .bodies
                .iter()
                .zip(&listed)
                .map(|(body, listed)| body.elastic(*listed))
                .collect::<Result<Vec<_>, _>>()?,
        };
        let modulus = match self.modulus {
            Some(pascals) => of_modulus(pascals)?,
            None if bodies.is_empty() => return Ok(None),
            None => contact_modulus(&bodies)?,
        };
        let softest = self.softest(&listed).filter(|_| !self.elastic && self.hardness.is_none());
        let of_table = softest.filter(|(i, _)| self.bodies[*i].hardness.is_none());
        let used = |(i, (body, listed)): (usize, (&BodyInput, Option<&Material>))| {
            let elastic = [(Property::Young, body.young), (Property::Poisson, body.poisson)];
            let of_modulus = self.modulus.is_none();
            let taken = elastic.into_iter().filter(|(_, own)| of_modulus && own.is_none());
            let hardness = of_table.is_some_and(|(softest, _)| softest == i);
            let taken = taken.map(|(p, _)| p).chain(hardness.then_some(Property::Hardness));
            listed.map(|m| MaterialUse { name: m.name.to_owned(), taken: taken.collect() })
        };
        Ok(Some(Bodies {
            modulus,
            hardness: self.hardness.filter(|_| !self.elastic).or(softest.map(|(_, h)| h)),
            materials: self
                .bodies
                .iter()
                .zip(listed.iter().copied())
                .enumerate()
                .filter_map(used)
                .collect(),
            bodies,
        }))
    }

    /// Whichever yields first, of those whose hardness is known (Pa).
    fn softest(&self, listed: &[Option<&Material>]) -> Option<(usize, f64)> {
        let of_table = |m: Option<&Material>| m.and_then(|m| m.get(Property::Hardness)).map(value);
        let each = self.bodies.iter().zip(listed.iter().copied()).enumerate();
        let known = each.filter_map(|(i, (b, m))| Some((i, b.hardness.or_else(|| of_table(m))?)));
        known.min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

impl BodyInput {
    /// E and ν.
    fn elastic(&self, listed: Option<&Material>) -> Result<Body, Failure> {
        let number = |own: Option<f64>, property| match (own, listed) {
            (Some(own), _) => Ok(own),
            (None, Some(m)) => m.get(property).map(value).ok_or_else(|| missing(m, property)),
            (None, None) => {
                let message = format!("a body needs a material, or its {}", name_of(property));
                Err(Failure::refused("material", message))
            }
        };
        Ok(Body {
            young: number(self.young, Property::Young)?,
            poisson: number(self.poisson, Property::Poisson)?,
        })
    }
}

fn value(listed: &Listed) -> f64 {
    listed.value
}

fn known(name: &str) -> Result<&'static Material, Failure> {
    material(name).map_err(|near| {
        let near = near.join(", ");
        Failure::refused(
            "material",
            format!("{name} is not in the table of materials; near it: {near}"),
        )
    })
}

fn missing(material: &Material, property: Property) -> Failure {
    let message = format!(
        "the table has no {} of {} that a source could be named for; give your own",
        name_of(property),
        material.name
    );
    Failure::refused("material", message)
}

fn name_of(property: Property) -> &'static str {
    match property {
        Property::Young => "Young's modulus",
        Property::Poisson => "Poisson's ratio",
        Property::Hardness => "hardness",
        Property::Resistivity => "resistivity",
        Property::Conductivity => "thermal conductivity",
    }
}

/// E* itself (Pa).
///
/// # Errors
/// [`Failure`] of a number that is no modulus.
pub fn of_modulus(pascals: f64) -> Result<ContactModulus, Failure> {
    ContactModulus::from_pascals(pascals).map_err(|e| failure(&e))
}

/// E* of one body against a rigid one, or of two.
///
/// # Errors
/// [`Failure`] of constants out of their domain, or of another number of bodies.
pub(crate) fn contact_modulus(bodies: &[Body]) -> Result<ContactModulus, Failure> {
    let elastic = |body: &Body| Elastic::new(body.young, body.poisson);
    let modulus = match bodies {
        [only] => elastic(only).and_then(ContactModulus::against_rigid),
        [first, second] => {
            elastic(first).and_then(|first| ContactModulus::of_pair(first, elastic(second)?))
        }
        _ => {
            let message =
                format!("{} elastic bodies make no contact; give one or two", bodies.len());
            return Err(Failure::refused("material", message));
        }
    };
    modulus.map_err(|e| failure(&e))
}

fn failure(error: &SurfaceError) -> Failure {
    match error {
        SurfaceError::Material { quantity, value, unit: "", domain } => {
            let (low, high) = (domain.start(), domain.end());
            let message = format!("{quantity} = {value} is outside its domain, {low} to {high}");
            Failure::refused("material", message)
        }
        other => Failure::from_error(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(names: &[&str]) -> BothBodies {
        let body =
            |name: &&str| BodyInput { material: Some((*name).to_owned()), ..BodyInput::default() };
        BothBodies { bodies: names.iter().map(body).collect(), ..BothBodies::default() }
    }

    fn solved(given: &BothBodies) -> Bodies {
        given.resolve().expect("bodies").expect("given")
    }

    /// HV of annealed copper is 369 MPa over the area of the pyramid; steel 304 is three times as hard.
    #[test]
    fn the_hardness_of_the_softer_material_is_taken() {
        let both = solved(&of(&["steel-304", "copper"]));
        let softer = 369e6 / 68f64.to_radians().sin();
        assert!((both.hardness.expect("known") / softer - 1.0).abs() < 1e-9);
        assert!(!both.materials[0].taken.contains(&Property::Hardness));
        assert!(both.materials[1].taken.contains(&Property::Hardness));
        // Without a Poisson's ratio no modulus, but a modulus of one's own leaves the hardness.
        assert!(of(&["pmma"]).resolve().is_err());
        let own = solved(&BothBodies { modulus: Some(1e11), ..of(&["copper"]) });
        assert!(own.hardness == both.hardness && own.bodies.is_empty());
    }

    #[test]
    fn own_numbers_come_before_the_table() {
        let mut given = of(&["copper"]);
        given.bodies[0].hardness = Some(1e9);
        given.bodies[0].young = Some(130e9);
        let own = solved(&given);
        assert_eq!((own.hardness, own.bodies[0].young), (Some(1e9), 130e9));
        assert_eq!(own.materials[0].taken, [Property::Poisson]);
        let both = solved(&BothBodies { hardness: Some(3e9), ..given.clone() });
        assert_eq!(both.hardness, Some(3e9));
        let elastic = BothBodies { elastic: true, ..given };
        assert_eq!(solved(&elastic).hardness, None);
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let wrong = BothBodies { hardness: Some(wrong), ..of(&["copper"]) };
            assert!(wrong.resolve().is_err(), "{wrong:?}");
        }
        assert_eq!(BothBodies::default().resolve(), Ok(None));
    }

    #[test]
    fn a_number_of_both_is_noted_where_it_was_taken() {
        let mut both = solved(&of(&["steel-304", "copper"]));
        assert_eq!(both.of_both(Property::Conductivity), Ok([16.2, 394.0]));
        assert!(both.materials.iter().all(|m| m.taken.contains(&Property::Conductivity)));
        assert!(solved(&of(&["copper"])).of_both(Property::Conductivity).is_err());
        let error = solved(&of(&["steel-100cr6", "copper"])).of_both(Property::Resistivity);
        assert!(error.is_err_and(|e| e.message().contains("resistivity of steel-100cr6")));
    }
}
