//! `--modulus`, `--young`, `--poisson`, `--material`: what the bodies are made of.

use crate::args::{number, pressure};
use crate::hardness;
use crate::outcome::Failure;
use answers::bodies;
use clap::Args;
use compare::{Body, Listed, Material, MaterialUse, Property, material};
use contact_types::ContactModulus;

/// The elastic constants, given or those of the table.
#[derive(Args, Clone, Debug)]
pub(crate) struct Bodies {
    /// Contact modulus E*, 1/E* = sum of (1 - nu^2)/E over both bodies
    #[arg(long, value_name = "E", value_parser = pressure, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["young", "poisson"])]
    modulus: Option<f64>,
    /// Young's modulus, instead of --modulus; twice for two elastic bodies
    #[arg(long, value_name = "E", value_parser = pressure, allow_hyphen_values = true)]
    young: Vec<f64>,
    /// Poisson's ratio to each --young
    #[arg(long, value_name = "NU", value_parser = number, allow_hyphen_values = true)]
    poisson: Vec<f64>,
    /// Material, as copper, in place of these, with its hardness; two for two bodies, as steel-304,copper. Own numbers override
    /// those of the table that `rough-contact materials` shows
    #[arg(long, value_name = "NAME[,NAME]", value_delimiter = ',')]
    material: Vec<String>,
}

impl Bodies {
    /// E*, if any of its options was given.
    pub(crate) fn given(&self) -> Result<Option<ContactModulus>, Failure> {
        let materials = self.materials()?;
        if let Some(pascals) = self.modulus {
            return bodies::of_modulus(pascals).map(Some);
        }
        if !materials.is_empty() {
            return bodies::contact_modulus(&self.constants(&materials)?).map(Some);
        }
        match (self.young.len(), self.poisson.len()) {
            (0, 0) => Ok(None),
            (1, 1) | (2, 2) => bodies::contact_modulus(&self.listed()).map(Some),
            (young, poisson) => {
                let message = format!(
                    "--young given {young} times and --poisson {poisson} times; give both once \
                     (the other body is rigid) or both twice"
                );
                Err(Failure::refused("usage", message))
            }
        }
    }

    /// The elastic bodies as they were given; none with --modulus.
    pub(crate) fn listed(&self) -> Vec<Body> {
        let of_table = self.materials().unwrap_or_default();
        if self.modulus.is_none() && !of_table.is_empty() {
            return self.constants(&of_table).unwrap_or_default();
        }
        let pairs = self.young.iter().zip(&self.poisson);
        pairs.map(|(&young, &poisson)| Body { young, poisson }).collect()
    }

    /// E*; an error if it was not given.
    pub(crate) fn required(&self) -> Result<ContactModulus, Failure> {
        self.given()?.ok_or_else(|| {
            Failure::refused(
                "usage",
                "the contact modulus is missing; give --modulus E*, for example --modulus 110GPa, \
                 --young 210GPa --poisson 0.3, or --material copper, twice for two elastic bodies",
            )
        })
    }

    /// The highest pressure the softer body bears: as given, infinite for elastic bodies; else that of the table.
    pub(crate) fn hardness(&self, given: Option<f64>) -> Result<Option<f64>, Failure> {
        hardness::check(given)?;
        match given {
            Some(given) => Ok(Some(given).filter(|h| h.is_finite())),
            None => Ok(softest(&self.materials()?).map(|(_, h)| h.value)),
        }
    }

    /// A number of both bodies out of the table.
    pub(crate) fn of_both(&self, property: Property, option: &str) -> Result<[f64; 2], Failure> {
        let materials = self.materials()?;
        let [first, second] = materials[..] else {
            let message = format!(
                "{option} table takes a number of both bodies out of the table: give --material twice, or \
                 the numbers"
            );
            return Err(Failure::refused("material", message));
        };
        let of = |material: &Material| {
            let missing = || missing(material, property, option);
            material.get(property).map(|listed| listed.value).ok_or_else(missing)
        };
        Ok([of(first)?, of(second)?])
    }

    /// The materials, and what was taken of each: of `beside` for both.
    pub(crate) fn used(
        &self,
        hardness: Option<f64>,
        beside: &[Property],
    ) -> Result<Vec<MaterialUse>, Failure> {
        let materials = self.materials()?;
        let softest = softest(&materials).filter(|_| hardness.is_none()).map(|(i, _)| i);
        let used = |(i, material): (usize, &&Material)| {
            let is_given = self.modulus.is_some();
            let young = (!is_given && self.young.is_empty()).then_some(Property::Young);
            let poisson = (!is_given && self.poisson.is_empty()).then_some(Property::Poisson);
            let hardness = (softest == Some(i)).then_some(Property::Hardness);
            let taken = young.into_iter().chain(poisson).chain(hardness);
            MaterialUse {
                name: material.name.to_owned(),
                taken: taken.chain(beside.iter().copied()).collect(),
            }
        };
        Ok(materials.iter().enumerate().map(used).collect())
    }

    fn materials(&self) -> Result<Vec<&'static Material>, Failure> {
        if self.material.len() > 2 {
            let message =
                format!("--material given {} times; two bodies touch", self.material.len());
            return Err(Failure::refused("usage", message));
        }
        let find = |name: &String| {
            material(name).map_err(|unknown| {
                let message = format!(
                    "--material {name}: not in the table; near it: {}. `rough-contact materials` shows all; \
                     --young, --poisson, --hardness take any",
                    unknown.near.join(", ")
                );
                Failure::refused("material", message)
            })
        };
        self.material.iter().map(find).collect()
    }

    /// E and ν of each, own numbers before those of the table.
    fn constants(&self, materials: &[&Material]) -> Result<Vec<Body>, Failure> {
        let own = |option: &str, values: &[f64]| {
            if values.is_empty() || values.len() == materials.len() {
                return Ok(());
            }
            let message = format!(
                "{option} given {} times and --material {} times; give it for each material, or not at all",
                values.len(),
                materials.len()
            );
            Err(Failure::refused("usage", message))
        };
        own("--young", &self.young)?;
        own("--poisson", &self.poisson)?;
        let body = |(i, material): (usize, &&Material)| {
            let number = |own: &[f64], property, option| {
                let listed = || material.get(property).map(|listed| listed.value);
                let missing = || missing(material, property, option);
                own.get(i).copied().or_else(listed).ok_or_else(missing)
            };
            Ok(Body {
                young: number(&self.young, Property::Young, "--young")?,
                poisson: number(&self.poisson, Property::Poisson, "--poisson")?,
            })
        };
        materials.iter().enumerate().map(body).collect()
    }
}

/// Whichever yields first, of those whose hardness is known.
fn softest(materials: &[&'static Material]) -> Option<(usize, &'static Listed)> {
    let known = materials.iter().enumerate();
    let known = known.filter_map(|(i, m)| Some((i, m.get(Property::Hardness)?)));
    known.min_by(|a, b| a.1.value.total_cmp(&b.1.value))
}

fn missing(material: &Material, property: Property, option: &str) -> Failure {
    let message = format!(
        "the table has no {} of {} that a source could be named for; give {option}",
        match property {
            Property::Young => "Young's modulus",
            Property::Poisson => "Poisson's ratio",
            Property::Hardness => "hardness",
            Property::Resistivity => "resistivity",
            Property::Conductivity => "thermal conductivity",
        },
        material.name
    );
    Failure::refused("material", message)
}
