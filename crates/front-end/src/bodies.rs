//! The two bodies: contact modulus and hardness of what was given of them, numbers or names of the table of materials.

use crate::failure::Failure;
use contact_compare::{Body, Material, MaterialUse, Property, material};
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
        let number = |used: &MaterialUse| listed(known(&used.name)?, property);
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
        let each = || self.bodies.iter().zip(listed.iter().copied());
        let (modulus, bodies) = match self.modulus {
            Some(pascals) => {
                (ContactModulus::from_pascals(pascals).map_err(|e| failure(&e))?, Vec::new())
            }
            None if self.bodies.is_empty() => return Ok(None),
            None => {
                let bodies = each().map(|(body, listed)| body.elastic(listed));
                let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
                (contact_modulus(&bodies)?, bodies)
            }
        };
        // Whichever yields first, of those whose hardness is known.
        let of_table = |m: Option<&Material>| Some(m?.get(Property::Hardness)?.value);
        let known = each().enumerate().filter_map(|(i, (body, listed))| {
            Some((i, body.hardness.or_else(|| of_table(listed))?))
        });
        let softest = known.min_by(|a, b| a.1.total_cmp(&b.1));
        let softest = softest.filter(|_| !self.elastic && self.hardness.is_none());
        let used = each().enumerate().filter_map(|(i, (body, listed))| {
            let elastic = [(Property::Young, body.young), (Property::Poisson, body.poisson)];
            let elastic = elastic.into_iter().filter(|(_, own)| own.or(self.modulus).is_none());
            let yields =
                body.hardness.is_none() && softest.is_some_and(|(softest, _)| softest == i);
            let taken = elastic.map(|(property, _)| property);
            let taken = taken.chain(yields.then_some(Property::Hardness)).collect();
            Some(MaterialUse { name: listed?.name.to_owned(), taken })
        });
        Ok(Some(Bodies {
            modulus,
            bodies,
            hardness: self.hardness.filter(|_| !self.elastic).or(softest.map(|(_, h)| h)),
            materials: used.collect(),
        }))
    }
}

impl BodyInput {
    fn elastic(&self, listed: Option<&Material>) -> Result<Body, Failure> {
        let number = |own: Option<f64>, property| match (own, listed) {
            (Some(own), _) => Ok(own),
            (None, Some(material)) => self::listed(material, property),
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

/// The material of this name.
///
/// # Errors
/// [`Failure`] of a name that is not in the table, with those near it.
pub fn known(name: &str) -> Result<&'static Material, Failure> {
    material(name).map_err(|near| {
        let near = near.join(", ");
        let message = format!("{name} is not in the table of materials; near it: {near}");
        Failure::refused("material", message)
    })
}

/// A number of the table.
fn listed(material: &Material, property: Property) -> Result<f64, Failure> {
    material.get(property).map(|listed| listed.value).ok_or_else(|| {
        let (what, of) = (name_of(property), material.name);
        let message = format!(
            "the table has no {what} of {of} that a source could be named for; give your own"
        );
        Failure::refused("material", message)
    })
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

/// E* of one body against a rigid one, or of two.
fn contact_modulus(bodies: &[Body]) -> Result<ContactModulus, Failure> {
    let elastic = |body: &Body| Elastic::new(body.young, body.poisson);
    let modulus = match bodies {
        [only] => elastic(only).and_then(|only| ContactModulus::of_pair(only, None)),
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
            let message = format!("{quantity} = {value} must be above {low} and at most {high}");
            Failure::refused("material", message)
        }
        other => Failure::from(other),
    }
}
