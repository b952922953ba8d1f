//! The built-in theories: one row each, in the order of tables and figures. A new one is a row here.

use crate::needs::{Input, InputSet, Inputs, OfMap, in_words};
use crate::theory::{Assumes, BuildError, Card, Theory};
use Input::{
    Area, AsperityDensity, AsperityHeightStd, AsperityRadius, CriticalArea, Cutoff, Dimension,
    Gamma, Hardness, Hurst, Longest, M0, M2, M4, MaxAmplitudeRatio, MeanOffset, MeanSlope, Ra,
    RecordLength, RmsHeight, Rolloff, Roughness, SphereDensity, SphereRadius,
};
use asperity_models::thermal_conductance::ConductanceCorrelation;
use asperity_models::{ChangEtsionBogy, SummitLaw, SummitModel};
use contact_types::{
    AmplitudeSpectrum, Citation, ContactModel, ContactState, FractalParameters, ModelError,
    SeparationModel, SpectralMoments,
};
use gw_closed_form::GreenwoodWilliamson;
use multiscale_models::{
    Archard, Equation, JacksonStreator, MajumdarBhushan, Persson, PerssonWithYield, PlasticSpots,
    Stacked, YanKomvopoulos,
};
use std::sync::Arc;

/// One set of inputs: all of the first, any of the second.
type Set = (&'static [Input], &'static [Input]);

const MOMENTS: Set = (&[M0, M2, M4], &[]);
const SELF_AFFINE: Set = (&[Hurst, Rolloff, Cutoff, M0], &[Longest]);
const OF_RECORD: Set = (&[Hurst, Rolloff, Cutoff, M0], &[Longest, RecordLength]);

/// One theory; see [`Card`] for the words. `needs` are the sets of numbers it can be made from, the usual first.
struct ModelDescriptor {
    /// Its key, its label in figures, and its name in full.
    names: [&'static str; 3],
    needs: &'static [Set],
    /// What a map is read for beside the moments; `None` where a map does not give all it needs.
    of_map: Option<OfMap>,
    domain: &'static str,
    assumes: Assumes,
    build: Build,
}

/// How a model is made: one whose theory has a separation of the undeformed planes, or one that
/// knows the pressure only.
#[derive(Clone, Copy)]
enum Build {
    Separation(fn(&Inputs) -> Result<Box<dyn SeparationModel>, BuildError>),
    Pressure(fn(&Inputs) -> Result<Box<dyn ContactModel>, BuildError>),
    /// Of bodies without elasticity: no modulus is asked for.
    Rigid(fn(&Inputs) -> Result<Box<dyn ContactModel>, BuildError>),
}

const ROWS: &[ModelDescriptor] = &[
    ModelDescriptor {
        names: ["gw", "GW", "Greenwood–Williamson, exact"],
        needs: &[
            MOMENTS,
            (&[AsperityDensity, AsperityRadius, AsperityHeightStd], &[MeanOffset]),
            SELF_AFFINE,
        ],
        of_map: Some(OfMap::Moments),
        domain: "isotropic Gaussian surface, contact below about 10 % of it",
        assumes: Assumes::Summits,
        build: Build::Separation(|inputs| {
            if let Some(asperities) = inputs.asperities {
                return Ok(Box::new(GreenwoodWilliamson::new(asperities, inputs.modulus)?));
            }
            let moments = moments(inputs, "Greenwood-Williamson")?;
            Ok(Box::new(GreenwoodWilliamson::from_moments(moments, inputs.modulus)?))
        }),
    },
    ModelDescriptor {
        names: ["bgt", "BGT", "Bush–Gibson–Thomas"],
        needs: &[MOMENTS, SELF_AFFINE],
        of_map: Some(OfMap::Moments),
        domain: "isotropic Gaussian surface with bandwidth of at least 1.5, light contact",
        assumes: Assumes::Summits,
        build: Build::Separation(|inputs| {
            let moments = moments(inputs, "Bush-Gibson-Thomas")?;
            Ok(Box::new(SummitModel::new(SummitLaw::BushGibsonThomas, moments, inputs.modulus)?))
        }),
    },
    ModelDescriptor {
        names: ["greenwood-elliptical", "Elliptical", "Greenwood simplified elliptical"],
        needs: &[MOMENTS, SELF_AFFINE],
        of_map: Some(OfMap::Moments),
        domain: "isotropic Gaussian surface with bandwidth of at least 1.5, light contact",
        assumes: Assumes::Summits,
        build: Build::Separation(|inputs| {
            let moments = moments(inputs, "Greenwood simplified elliptical")?;
            Ok(Box::new(SummitModel::new(SummitLaw::GreenwoodElliptical, moments, inputs.modulus)?))
        }),
    },
    ModelDescriptor {
        names: ["persson", "Persson", "Persson"],
        needs: &[(&[Hurst, Rolloff, Cutoff, M0], &[Longest, Gamma]), (&[M2], &[M0, M4])],
        of_map: Some(OfMap::Spectrum),
        domain: "isotropic Gaussian surface, any load; reads low at light load; the mean gap needs a spectrum",
        assumes: Assumes::Gaussian,
        build: Build::Pressure(persson),
    },
    ModelDescriptor {
        names: ["stacked", "Stacked", "Stacked multiscale"],
        needs: &[(&[MaxAmplitudeRatio], &[]), OF_RECORD],
        of_map: Some(OfMap::Amplitudes),
        domain: "depends on the record length and on the direction of the rows",
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(|inputs| {
            let ratio = match inputs.max_amplitude_ratio {
                Some(ratio) => ratio,
                None => amplitudes(inputs, "Stacked multiscale")?.max_amplitude_ratio(),
            };
            Ok(Box::new(Stacked::new(ratio, inputs.modulus)?))
        }),
    },
    ModelDescriptor {
        names: ["multiscale", "Multiscale", "Jackson–Streator multiscale"],
        needs: &[OF_RECORD],
        of_map: Some(OfMap::Amplitudes),
        domain: "depends on the record length and on the direction of the rows",
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(|inputs| {
            let amplitudes = amplitudes(inputs, "Jackson-Streator multiscale")?;
            Ok(Box::new(JacksonStreator::new(amplitudes.clone(), inputs.modulus)))
        }),
    },
    ModelDescriptor {
        names: ["archard", "Archard", "Archard, spheres on spheres"],
        needs: &[(&[SphereRadius, SphereDensity], &[])],
        of_map: None,
        domain: "many spheres per contact of the level above, and far apart",
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(|inputs| {
            let spheres = Some(&inputs.spheres).filter(|spheres| !spheres.is_empty());
            let spheres = missing(spheres, "Archard", "the radius and density of its spheres")?;
            Ok(Box::new(Archard::new(spheres, inputs.modulus)?))
        }),
    },
    ModelDescriptor {
        names: ["majumdar-bhushan", "MB", "Majumdar–Bhushan"],
        needs: &[
            (&[Dimension, Roughness, Area], &[CriticalArea]),
            (&[Dimension, Roughness, Area, Hardness], &[]),
        ],
        of_map: Some(OfMap::Fractal),
        domain: "profile with 1 < D < 1.5, with a critical area or hardness D < 2; elastic without hardness",
        assumes: Assumes::Fractal,
        build: Build::Pressure(|inputs| {
            let (fractal, area) = fractal(inputs, "Majumdar-Bhushan")?;
            Ok(Box::new(MajumdarBhushan::new(fractal, area, inputs.modulus, plastic(inputs))?))
        }),
    },
    ModelDescriptor {
        names: ["yan-komvopoulos", "YK", "Yan–Komvopoulos"],
        needs: &[
            (&[Dimension, Roughness, Area], &[CriticalArea]),
            (&[Dimension, Roughness, Area, Hardness], &[]),
        ],
        of_map: None,
        domain: "surface with 2 < D < 2.5, with a critical area or hardness D < 3; elastic without hardness",
        assumes: Assumes::Fractal,
        build: Build::Pressure(|inputs| {
            let (fractal, area) = fractal(inputs, "Yan-Komvopoulos")?;
            let FractalParameters { dimension, roughness } = fractal;
            let (modulus, plastic) = (inputs.modulus, plastic(inputs));
            Ok(Box::new(YanKomvopoulos::new(dimension, roughness, area, modulus, plastic)?))
        }),
    },
    ModelDescriptor {
        names: ["equation", "Equation", "The equation (fitted)"],
        needs: &[MOMENTS, SELF_AFFINE],
        of_map: Some(OfMap::Moments),
        domain: "isotropic Gaussian surface, area from 0.1 %: 95 % within 47 % there, 13 % at 1 %, 5 % at 7 %",
        assumes: Assumes::Gaussian,
        build: Build::Pressure(|inputs| {
            let moments = moments(inputs, "The equation")?;
            Ok(Box::new(Equation::from_moments(moments, inputs.modulus)?))
        }),
    },
    ModelDescriptor {
        names: ["ceb", "CEB", "Chang–Etsion–Bogy"],
        needs: &[
            (&[Hardness, M0, M2, M4], &[]),
            (&[Hardness, AsperityDensity, AsperityRadius, AsperityHeightStd], &[MeanOffset]),
            (&[Hardness, Hurst, Rolloff, Cutoff, M0], &[Longest]),
        ],
        of_map: None,
        domain: "isotropic Gaussian surface whose summits yield, contact below about 10 % of it",
        assumes: Assumes::Summits,
        build: Build::Separation(|inputs| {
            const NAME: &str = "Chang-Etsion-Bogy";
            let what = "asperities, or the spectral moments m0, m2 and m4";
            let asperities = missing(inputs.asperities(), NAME, what)?;
            let hardness = missing(inputs.hardness, NAME, "a hardness")?;
            let (modulus, poisson) = (inputs.modulus, inputs.poisson);
            Ok(Box::new(ChangEtsionBogy::new(asperities, modulus, hardness, poisson)?))
        }),
    },
    ModelDescriptor {
        names: ["persson-yield", "Persson, H", "Persson with yield"],
        needs: &[
            (&[Hardness, M2], &[M0, M4]),
            (&[Hardness, Hurst, Rolloff, Cutoff, M0], &[Longest]),
        ],
        of_map: None,
        domain: "isotropic Gaussian surface that yields, any load below the hardness; reads low",
        assumes: Assumes::Gaussian,
        build: Build::Pressure(|inputs| {
            const NAME: &str = "Persson with yield";
            let m2 = missing(inputs.m2(), NAME, "the moment m2")?;
            let hardness = missing(inputs.hardness, NAME, "a hardness")?;
            let gradient = (2.0 * m2).sqrt();
            Ok(Box::new(PerssonWithYield::new(gradient, inputs.modulus, hardness)?))
        }),
    },
    ModelDescriptor {
        names: ["cmy", "CMY", "Cooper–Mikic–Yovanovich conductance"],
        needs: &[(&[RmsHeight, MeanSlope, Hardness], &[]), (&[Ra, MeanSlope, Hardness], &[])],
        of_map: None,
        domain: "Gaussian heights that yield at once, load over hardness from 1e-6 to 0.02",
        assumes: Assumes::Gaussian,
        build: Build::Rigid(|inputs| {
            const NAME: &str = "Cooper-Mikic-Yovanovich";
            let (slope, height) = joint(inputs, NAME)?;
            let hardness = missing(inputs.hardness, NAME, "a hardness")?;
            Ok(Box::new(ConductanceCorrelation::plastic(slope, height, hardness)?))
        }),
    },
    ModelDescriptor {
        names: ["mikic", "Mikic", "Mikic conductance, elastic"],
        needs: &[(&[RmsHeight, MeanSlope], &[]), (&[Ra, MeanSlope], &[])],
        of_map: None,
        domain: "Gaussian heights, elastic, area 1e-6 to 0.1",
        assumes: Assumes::Gaussian,
        build: Build::Pressure(|inputs| {
            let (slope, height) = joint(inputs, "Mikic")?;
            Ok(Box::new(ConductanceCorrelation::elastic(slope, height, inputs.modulus)?))
        }),
    },
];

/// Spots that are plastic by a critical area, or else by a hardness.
fn plastic(inputs: &Inputs) -> PlasticSpots {
    match (inputs.critical_area, inputs.hardness) {
        (Some(critical), _) => PlasticSpots::Below(critical),
        (None, Some(hardness)) => PlasticSpots::OfHardness(hardness),
        (None, None) => PlasticSpots::None,
    }
}

/// Mean absolute slope and rms height of both surfaces together.
fn joint(inputs: &Inputs, model: &'static str) -> Result<(f64, f64), BuildError> {
    let what = "rms height and mean absolute slope, or the moments m0 and m2";
    Ok((missing(inputs.mean_slope(), model, what)?, missing(inputs.rms_height(), model, what)?))
}

fn persson(inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
    let with_gamma = |model: Persson| model.with_gamma(inputs.weight());
    if let Some(spectrum) = inputs.self_affine {
        let model = Persson::from_self_affine(spectrum, inputs.modulus);
        return Ok(Box::new(with_gamma(model)?));
    }
    let of_m2 = |m2| {
        let moments = SpectralMoments { m0: 0.0, m2, m4: 0.0 };
        Persson::from_moments(moments, inputs.modulus)
    };
    let Some(spectrum) = &inputs.spectrum else {
        let m2 = missing(inputs.m2(), "Persson", "a spectrum or the moment m2")?;
        return Ok(Box::new(of_m2(m2)?));
    };
    let whole = with_gamma(Persson::from_spectrum(spectrum, inputs.modulus)?)?;
    Ok(match inputs.m2() {
        Some(m2) => Box::new(AreaAndGap { area: of_m2(m2)?, gap: whole }),
        None => Box::new(whole),
    })
}

/// The area by the moments that every model is given, the mean gap by the spectrum, which has
/// another m2: it sees the waves near two points in full.
struct AreaAndGap {
    area: Persson,
    gap: Persson,
}

impl ContactModel for AreaAndGap {
    fn citation(&self) -> Citation {
        self.area.citation()
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let gap = self.gap.at_pressure(mean_pressure)?;
        let area = self.area.at_pressure(mean_pressure)?;
        Ok(ContactState { separation: gap.separation, mean_gap: gap.mean_gap, ..area })
    }
}

/// An input, or that it is missing.
fn missing<T>(value: Option<T>, model: &'static str, needs: &'static str) -> Result<T, BuildError> {
    value.ok_or_else(|| BuildError::Missing { model: model.into(), needs: needs.into() })
}

fn moments(inputs: &Inputs, model: &'static str) -> Result<SpectralMoments, BuildError> {
    missing(inputs.moments, model, "the spectral moments m0, m2 and m4")
}

fn amplitudes<'a>(
    inputs: &'a Inputs,
    model: &'static str,
) -> Result<&'a AmplitudeSpectrum, BuildError> {
    missing(inputs.amplitudes.as_ref(), model, "the amplitudes of profiles")
}

fn fractal(inputs: &Inputs, model: &'static str) -> Result<(FractalParameters, f64), BuildError> {
    let what = "a fractal fit with 1 < D < 2 over at least an octave, or dimension and roughness";
    let parameters = missing(inputs.fractal, model, what)?;
    Ok((parameters, missing(inputs.nominal_area, model, "the nominal area")?))
}

/// Every built-in theory.
pub(crate) fn all() -> Vec<Arc<dyn Theory>> {
    ROWS.iter().map(|row| Arc::new(row.theory()) as Arc<dyn Theory>).collect()
}

impl ModelDescriptor {
    /// Its card says what the model says of its source.
    fn theory(&self) -> BuiltIn {
        let example = Inputs::examples().iter().find_map(|i| self.build.pressure(i).ok());
        let example = example.expect("a test makes every row from these inputs");
        let set = |(required, optional): &Set| InputSet {
            required: required.to_vec(),
            optional: optional.to_vec(),
        };
        let inputs: Vec<InputSet> = self.needs.iter().map(set).collect();
        let [name, label, title] = self.names;
        let mut card = Card::new(name, title, example.citation());
        card.formula = example.formula().unwrap_or_default().into();
        card.label = label.into();
        card.needs = in_words(&inputs).into();
        card.inputs = inputs;
        card.of_map = self.of_map.unwrap_or_default();
        card.domain = self.domain.into();
        card.assumes = self.assumes;
        card.from_map = self.of_map.is_some();
        card.yields = self.needs.iter().all(|(required, _)| required.contains(&Hardness));
        card.has_separation = matches!(self.build, Build::Separation(_));
        card.is_rigid = matches!(self.build, Build::Rigid(_));
        BuiltIn { card, build: self.build }
    }
}

impl Build {
    fn pressure(self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        match self {
            Self::Separation(build) => Ok(build(inputs)?),
            Self::Pressure(build) | Self::Rigid(build) => build(inputs),
        }
    }
}

struct BuiltIn {
    card: Card,
    build: Build,
}

impl Theory for BuiltIn {
    fn card(&self) -> &Card {
        &self.card
    }

    fn build(&self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        self.build.pressure(inputs)
    }

    fn build_separation(
        &self,
        inputs: &Inputs,
    ) -> Option<Result<Box<dyn SeparationModel>, BuildError>> {
        match self.build {
            Build::Separation(build) => Some(build(inputs)),
            Build::Pressure(_) | Build::Rigid(_) => None,
        }
    }
}
