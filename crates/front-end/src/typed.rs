//! A model made from numbers typed in: which of its sets of inputs they are, and what they lack.

use crate::failure::Failure;
use contact_compare::{Card, ContactModulus, Input, InputSet, Inputs, SpectralMoments};
use contact_types::{AsperityStatistics, FractalParameters, ModelError};
use multiscale_models::{SelfAffineSpectrum, SphereLevel};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Numbers typed in, SI; of most inputs one.
type Typed = BTreeMap<Input, Vec<f64>>;

/// The number given, of a list the first.
fn one(typed: &Typed, input: Input) -> Option<f64> {
    typed.get(&input).and_then(|values| values.first().copied())
}

/// What one height parameter does not say.
const NO_SLOPE: &str = " (no slope follows from Ra or an rms height: measure a profile or a map, whose statistics have it)";

/// A number, named `given`, that the model of `card` has no use for.
pub fn unused(card: &Card, given: &str, name: impl Fn(Input) -> String) -> Failure {
    let takes = sets(card, &name);
    let message = format!("{given} is no input of {}, which takes {takes}", card.name);
    Failure::refused("usage", message)
}

/// The sets of inputs that a model can be made from.
fn sets(card: &Card, name: impl Fn(Input) -> String) -> String {
    card.inputs.iter().map(|set| set.shown(&name, " ")).collect::<Vec<_>>().join(", or ")
}

/// Refuses numbers of which no set of `card` holds all, or that lack something of each.
fn check(
    typed: &Typed,
    card: &Card,
    name: impl Fn(Input) -> String,
    ways: Option<&str>,
) -> Result<(), Failure> {
    let model = &card.name;
    let list = |all: &[Input]| all.iter().map(|i| name(*i)).collect::<Vec<_>>().join(" ");
    let given: Vec<Input> = typed.keys().copied().collect();
    if let Some(input) = given.iter().find(|input| !card.takes(**input)) {
        return Err(unused(card, &name(*input), name));
    }
    let lacks = |set: &InputSet| -> Vec<Input> {
        set.required.iter().copied().filter(|input| !typed.contains_key(input)).collect()
    };
    let foreign = |set: &InputSet| given.iter().copied().find(|input| !set.takes(*input));
    let complete = || card.inputs.iter().filter(|set| lacks(set).is_empty());
    if complete().any(|set| foreign(set).is_none()) {
        return Ok(());
    }
    if let Some((set, input)) = complete().find_map(|set| Some((set, foreign(set)?))) {
        let (own, input, sets) = (list(&set.required), name(input), sets(card, &name));
        let message = format!("{own} and {input} do not go together; {model} takes {sets}");
        return Err(Failure::refused("usage", message));
    }
    // The one that most was given of, then the one that lacks least; the first of equals.
    let rank = |set: &&InputSet| {
        let of_set = given.iter().filter(|input| set.takes(**input)).count();
        (usize::MAX - of_set, lacks(set).len())
    };
    let missing = card.inputs.iter().min_by_key(rank).map_or_else(Vec::new, lacks);
    let ways = match ways.filter(|_| given.is_empty()) {
        Some(ways) => format!("give {ways}"),
        None => format!("it takes {}", sets(card, &name)),
    };
    let beside = match given[..] {
        [] => String::new(),
        _ if missing.contains(&Input::MeanSlope) => format!(" beside {}{NO_SLOPE}", list(&given)),
        _ => format!(" beside {}", list(&given)),
    };
    let message = format!("{model} needs {}{beside}; {ways}", list(&missing));
    Err(Failure::refused("missing_input", message))
}

/// What the model of `card` is made from, each input called as `name` calls it; `ways` are those to make it where
/// nothing was given.
///
/// # Errors
/// [`Failure`] of numbers that make no model.
pub fn inputs(
    typed: &BTreeMap<Input, Vec<f64>>,
    card: &Card,
    modulus: ContactModulus,
    name: impl Fn(Input) -> String,
    ways: Option<&str>,
) -> Result<Inputs, Failure> {
    check(typed, card, &name, ways)?;
    let of_bodies = "give one of each, that of both together, or two, those of two surfaces";
    let of_levels = "give both for each level, coarse to fine";
    let together: [(&[Input], usize, &str); 2] = [
        (&[Input::RmsHeight, Input::Ra, Input::MeanSlope], 2, of_bodies),
        (&[Input::SphereRadius, Input::SphereDensity], usize::MAX, of_levels),
    ];
    for (inputs, most, way_out) in together {
        let count = |input: &Input| Some((name(*input), typed.get(input)?.len()));
        let counts: Vec<_> = inputs.iter().filter_map(count).collect();
        if counts.iter().any(|(_, count)| *count > most || *count != counts[0].1) {
            let counts: Vec<_> = counts.iter().map(|(name, n)| format!("{name}: {n}")).collect();
            let message = format!("numbers of {}; {way_out}", counts.join(", "));
            return Err(Failure::refused("usage", message));
        }
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
    // Of two surfaces the squares add, and one may be smooth; of Gaussian heights σ = √(π/2) Ra.
    let both = |input: Input| {
        let of_each = typed.get(&input)?;
        let wrong = of_each.iter().copied().find(|x| x.is_nan() || *x < 0.0);
        Some(wrong.unwrap_or_else(|| of_each.iter().copied().fold(0.0, f64::hypot)))
    };
    inputs.mean_slope = both(Input::MeanSlope);
    let of_ra = || Some((0.5 * PI).sqrt() * both(Input::Ra)?);
    inputs.rms_height = both(Input::RmsHeight).or_else(of_ra);
    if let Some(hurst) = one(Input::Hurst) {
        let spectrum = self_affine(typed, hurst).map_err(|e| Failure::from(&e))?;
        inputs.self_affine = Some(spectrum);
        inputs.moments = Some(spectrum.moments());
        if card.takes(Input::RecordLength) {
            let longest = one(Input::Longest).or(one(Input::Rolloff)).unwrap_or(f64::NAN);
            let record = one(Input::RecordLength).unwrap_or(longest);
            let amplitudes = spectrum.profile_amplitudes(record).map_err(|e| Failure::from(&e))?;
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

#[cfg(test)]
mod tests {
    use super::*;

    fn option(input: Input) -> String {
        format!("--{}", input.name())
    }

    fn made(model: &str, given: &[(Input, f64)]) -> Result<Inputs, Failure> {
        let theory = contact_compare::find(model).expect("a model");
        let modulus = ContactModulus::from_pascals(1e11).expect("a modulus");
        let typed = given.iter().map(|(input, value)| (*input, vec![*value])).collect();
        inputs(&typed, theory.card(), modulus, option, None)
    }

    /// What a set requires makes the model; without any one of these, that one is named.
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
                        Err(failure) if failure.kind == "missing_input" => {
                            let (_, text) = failure.message.split_once(" needs ").expect("what");
                            let missing = text.split([';', ' ']).take_while(|w| *w != "beside");
                            let missing: Vec<&str> =
                                missing.take_while(|w| !w.is_empty()).collect();
                            assert!(!missing.is_empty(), "{failure}");
                            let mut given = rest.iter().map(|r| option(r.0));
                            assert!(!given.any(|g| missing.contains(&&*g)), "{failure}");
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
        let told = |model: &str, given: &[(Input, f64)]| {
            made(model, given).expect_err("a refusal").message
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
