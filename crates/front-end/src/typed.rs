//! A model made from numbers typed in: which of its sets of inputs they are, and what they lack.

use crate::failure::Failure;
use contact_compare::{Card, ContactModulus, Input, InputSet, Inputs, SpectralMoments};
use contact_types::{AsperityStatistics, FractalParameters, ModelError};
use multiscale_models::{SelfAffineSpectrum, SphereLevel};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Numbers typed in, SI; of most inputs one.
pub type Typed = BTreeMap<Input, Vec<f64>>;

/// The number given, of a list the first.
fn one(typed: &Typed, input: Input) -> Option<f64> {
    typed.get(&input).and_then(|values| values.first().copied())
}

#[derive(Debug)]
enum Untyped {
    Unused(Input),
    Apart(Input, Vec<Input>),
    /// Of the set that is nearest to what was given, these are missing.
    Incomplete {
        given: Vec<Input>,
        missing: Vec<Input>,
    },
    Bodies(Input, usize),
    Lengths {
        radii: usize,
        densities: usize,
    },
    Model(ModelError),
}

/// The set of `card` that holds all that is given and lacks nothing.
fn set<'a>(typed: &Typed, card: &'a Card) -> Result<&'a InputSet, Untyped> {
    let given = || typed.keys().copied();
    if let Some(unused) = given().find(|input| !card.takes(*input)) {
        return Err(Untyped::Unused(unused));
    }
    let has = |input: &Input| typed.contains_key(input);
    let complete = |set: &&InputSet| set.required.iter().all(has);
    let holds = |set: &&InputSet| given().all(|input| set.takes(input));
    if let Some(set) = card.inputs.iter().find(|set| complete(set) && holds(set)) {
        return Ok(set);
    }
    if let Some(set) = card.inputs.iter().find(complete) {
        let foreign = given().find(|input| !set.takes(*input));
        let foreign = foreign.expect("no set holds all that is given");
        return Err(Untyped::Apart(foreign, set.required.clone()));
    }
    // The one that most was given of, then the one that lacks least; the first of equals.
    let rank = |set: &&InputSet| {
        let of_set = given().filter(|input| set.takes(*input)).count();
        let missing = set.required.iter().filter(|input| !has(input)).count();
        (usize::MAX - of_set, missing)
    };
    let nearest = card.inputs.iter().min_by_key(rank);
    let missing = nearest.map_or_else(Vec::new, |set| {
        set.required.iter().copied().filter(|input| !has(input)).collect()
    });
    Err(Untyped::Incomplete { given: given().collect(), missing })
}

/// What the model of `card` is made from, each input called as `name` calls it; `ways` are those to make it where
/// nothing was given.
///
/// # Errors
/// [`Failure`] of numbers that make no model.
pub fn inputs(
    typed: &Typed,
    card: &Card,
    modulus: ContactModulus,
    name: impl Fn(Input) -> String,
    ways: Option<&str>,
) -> Result<Inputs, Failure> {
    made(typed, card, modulus).map_err(|untyped| untyped.failure(card, name, ways))
}

fn made(typed: &Typed, card: &Card, modulus: ContactModulus) -> Result<Inputs, Untyped> {
    set(typed, card)?;
    let too_many = |(input, values): (&Input, &Vec<f64>)| {
        let is_of_bodies = matches!(input, Input::RmsHeight | Input::MeanSlope | Input::Ra);
        (is_of_bodies && values.len() > 2).then_some(Untyped::Bodies(*input, values.len()))
    };
    if let Some(error) = typed.iter().find_map(too_many) {
        return Err(error);
    }
    let one = |input| one(typed, input);
    let all = |input| typed.get(&input).cloned().unwrap_or_default();
    let mut inputs = Inputs {
        gamma: one(Input::Gamma),
        max_amplitude_ratio: one(Input::MaxAmplitudeRatio),
        nominal_area: one(Input::Area),
        critical_area: one(Input::CriticalArea),
        hardness: one(Input::Hardness),
        ..Inputs::new(modulus)
    };
    // Of two surfaces the squares add; of Gaussian heights σ = √(π/2) Ra.
    let both = |input: Input| {
        let of_each = typed.get(&input)?;
        let wrong = of_each.iter().copied().find(|x| x.is_nan() || *x <= 0.0);
        Some(wrong.unwrap_or_else(|| of_each.iter().copied().fold(0.0, f64::hypot)))
    };
    inputs.mean_slope = both(Input::MeanSlope);
    let of_ra = || Some((0.5 * PI).sqrt() * both(Input::Ra)?);
    inputs.rms_height = both(Input::RmsHeight).or_else(of_ra);
    if let Some(hurst) = one(Input::Hurst) {
        let spectrum = self_affine(typed, hurst).map_err(Untyped::Model)?;
        inputs.self_affine = Some(spectrum);
        inputs.moments = Some(spectrum.moments());
        if card.takes(Input::RecordLength) {
            let longest = one(Input::Longest).or(one(Input::Rolloff)).unwrap_or(f64::NAN);
            let record = one(Input::RecordLength).unwrap_or(longest);
            let amplitudes = spectrum.profile_amplitudes(record).map_err(Untyped::Model)?;
            inputs.amplitudes = Some(amplitudes);
        }
    } else if let Some(m2) = one(Input::M2) {
        match (one(Input::M0), one(Input::M4)) {
            (Some(m0), Some(m4)) => inputs.moments = Some(SpectralMoments { m0, m2, m4 }),
            _ => inputs.mean_square_slope = Some(m2),
        }
    }
    if let (Some(density), Some(radius), Some(height_std)) =
        (one(Input::AsperityDensity), one(Input::AsperityRadius), one(Input::AsperityHeightStd))
    {
        let mean_offset = one(Input::MeanOffset).unwrap_or(0.0);
        let given = AsperityStatistics { density, radius, height_std, mean_offset };
        inputs.asperities = Some(given);
    }
    if let (Some(dimension), Some(roughness)) = (one(Input::Dimension), one(Input::Roughness)) {
        inputs.fractal = Some(FractalParameters { dimension, roughness });
    }
    let (radii, densities) = (all(Input::SphereRadius), all(Input::SphereDensity));
    if radii.len() != densities.len() {
        let (radii, densities) = (radii.len(), densities.len());
        return Err(Untyped::Lengths { radii, densities });
    }
    let level = |(radius, density)| SphereLevel { radius, density };
    inputs.spheres = radii.into_iter().zip(densities).map(level).collect();
    Ok(inputs)
}

fn self_affine(typed: &Typed, hurst: f64) -> Result<SelfAffineSpectrum, ModelError> {
    let number = |input| one(typed, input).unwrap_or(f64::NAN);
    let [rolloff, cutoff, m0] = [Input::Rolloff, Input::Cutoff, Input::M0].map(number);
    match one(typed, Input::Longest) {
        None => SelfAffineSpectrum::from_wavelengths(hurst, rolloff, cutoff, m0),
        Some(longest) => {
            let wavenumbers = [longest, rolloff, cutoff].map(|l| TAU / l);
            SelfAffineSpectrum::from_wavenumbers(hurst, wavenumbers, m0)
        }
    }
}

/// What one height parameter does not say.
const NO_SLOPE: &str = " (no slope follows from Ra or an rms height: measure a profile or a map, whose statistics have it)";

/// An input that the model of `card` has no use for.
pub fn unused(card: &Card, input: Input, name: impl Fn(Input) -> String) -> Failure {
    Untyped::Unused(input).failure(card, name, None)
}

impl Untyped {
    fn failure(&self, card: &Card, name: impl Fn(Input) -> String, ways: Option<&str>) -> Failure {
        let model = &card.name;
        let sets = || {
            let each = card.inputs.iter().map(|set| set.shown(&name, " "));
            each.collect::<Vec<_>>().join(", or ")
        };
        let list = |all: &[Input]| all.iter().map(|i| name(*i)).collect::<Vec<_>>().join(" ");
        let mut kind = "usage";
        let message = match self {
            Self::Unused(input) => {
                format!("{} is no input of {model}, which takes {}", name(*input), sets())
            }
            Self::Apart(input, own) => {
                let (own, input) = (list(own), name(*input));
                format!("{own} and {input} do not go together; {model} takes {}", sets())
            }
            Self::Incomplete { given, missing } => {
                kind = "missing_input";
                let ways = ways.filter(|_| given.is_empty());
                let ways =
                    ways.map_or_else(|| format!("it takes {}", sets()), |w| format!("give {w}"));
                let beside = match given[..] {
                    [] => String::new(),
                    _ if missing.contains(&Input::MeanSlope) => {
                        format!(" beside {}{NO_SLOPE}", list(given))
                    }
                    _ => format!(" beside {}", list(given)),
                };
                format!("{model} needs {}{beside}; {ways}", list(missing))
            }
            Self::Bodies(input, count) => {
                let input = name(*input);
                format!("{input} has {count} numbers; give one, or one for each of two surfaces")
            }
            Self::Lengths { radii, densities } => format!(
                "{} has {radii} levels and {} {densities}; give both for each level, coarse to fine",
                name(Input::SphereRadius),
                name(Input::SphereDensity)
            ),
            Self::Model(error) => return Failure::from(error),
        };
        Failure::refused(kind, message)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn made(model: &str, given: &[(Input, f64)]) -> Result<Inputs, Untyped> {
        let theory = contact_compare::find(model).expect("a model");
        let modulus = ContactModulus::from_pascals(1e11).expect("a modulus");
        let typed = given.iter().map(|(input, value)| (*input, vec![*value])).collect();
        super::made(&typed, theory.card(), modulus)
    }

    /// Every set of every model, with nothing but what it requires, makes the model; without any one of
    /// these, that one is named.
    #[test]
    fn every_set_is_enough_and_nothing_in_it_too_much() {
        let value = |input: Input, model: &str| match input {
            Input::M0 | Input::CriticalArea => 1e-14,
            Input::M2 | Input::Longest | Input::SphereRadius => 1e-3,
            Input::M4 | Input::AsperityDensity => 1e10,
            Input::AsperityRadius | Input::Rolloff | Input::RecordLength => 1e-4,
            Input::AsperityHeightStd => 1e-7,
            Input::Hurst | Input::Gamma => 0.8,
            Input::Cutoff | Input::Area | Input::RmsHeight | Input::Ra => 1e-6,
            Input::SphereDensity => 1e6,
            Input::MaxAmplitudeRatio => 1e-2,
            Input::Dimension if model == "yan-komvopoulos" => 2.3,
            Input::Dimension => 1.3,
            Input::Roughness => 1e-10,
            Input::Hardness => 2e9,
            Input::MeanSlope => 0.1,
            _ => 0.0,
        };
        for theory in contact_compare::built_in().iter() {
            let card = theory.card();
            let model = card.name.as_ref();
            for set in &card.inputs {
                let numbers = |inputs: &[Input]| -> Vec<(Input, f64)> {
                    inputs.iter().map(|i| (*i, value(*i, model))).collect()
                };
                let least = numbers(&set.required);
                let inputs = made(model, &least).unwrap_or_else(|e| panic!("{model}: {e:?}"));
                let built = theory.build(&inputs).unwrap_or_else(|e| panic!("{model}: {e}"));
                assert!(built.at_pressure(1e6).is_ok(), "{model}");
                let all = [least.clone(), numbers(&set.optional)].concat();
                let inputs = made(model, &all).unwrap_or_else(|e| panic!("{model}: {e:?}"));
                assert!(theory.build(&inputs).is_ok(), "{model}");
                for (i, (absent, _)) in least.iter().enumerate() {
                    let rest = [&least[..i], &least[i + 1..]].concat();
                    match made(model, &rest) {
                        Err(Untyped::Incomplete { missing, .. }) => {
                            assert!(
                                !missing.is_empty()
                                    && !missing.iter().any(|m| rest.iter().any(|r| r.0 == *m))
                            );
                        }
                        // What is left may be another set of the model, or the start of one.
                        Ok(_) => assert!(card.inputs.len() > 1, "{model} without {absent:?}"),
                        Err(other) => panic!("{model} without {absent:?}: {other:?}"),
                    }
                }
            }
        }
    }

    #[test]
    fn what_lacks_and_what_is_foreign_is_named() {
        let hardness = (Input::Hardness, 2e9);
        let found = made("persson-yield", &[hardness, (Input::M2, 0.006)]).expect("all it needs");
        assert_eq!((found.m2(), found.moments), (Some(0.006), None));
        let name = |input: Input| format!("--{}", input.name());
        let told = |model: &str, given: &[(Input, f64)]| {
            let card = contact_compare::find(model).expect("a model").card();
            made(model, given).expect_err("a refusal").failure(card, name, None).message
        };
        let lacks = told("gw", &[(Input::M0, 1e-12), (Input::M2, 0.01)]);
        assert!(lacks.starts_with("gw needs --m4 beside --m0 --m2; it takes"), "{lacks}");
        let lacks = told("persson-yield", &[(Input::M2, 0.01)]);
        assert!(lacks.starts_with("persson-yield needs --hardness beside --m2"), "{lacks}");
        let foreign = told("gw", &[(Input::Dimension, 1.4)]);
        assert!(foreign.starts_with("--dimension is no input of gw"), "{foreign}");
        let apart = told("persson", &[(Input::M2, 0.01), (Input::Gamma, 0.5)]);
        assert!(apart.starts_with("--m2 and --gamma do not go together"), "{apart}");
    }
}
