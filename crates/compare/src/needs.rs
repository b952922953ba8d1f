//! What models are made from: as data, of which options, refusals, lists and the book say what stands here, and as numbers.

use contact_types::{
    AmplitudeSpectrum, AsperityStatistics, ContactModulus, FractalParameters, RoughnessSpectrum,
    SpectralMoments, Wave,
};
use multiscale_models::{Persson, SelfAffineSpectrum, SphereLevel};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// One number, or one list, that a model may be made from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
#[allow(missing_docs, reason = "INPUTS says of each what it is")]
pub enum Input {
    M0,
    M2,
    M4,
    AsperityDensity,
    AsperityRadius,
    AsperityHeightStd,
    MeanOffset,
    Hurst,
    Rolloff,
    Cutoff,
    Longest,
    Gamma,
    MaxAmplitudeRatio,
    RecordLength,
    Dimension,
    Roughness,
    Area,
    CriticalArea,
    Hardness,
    SphereRadius,
    SphereDensity,
    RmsHeight,
    MeanSlope,
    Ra,
}

/// Dimension of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum InputUnit {
    /// Pure number.
    Number,
    /// m.
    Length,
    /// m².
    Area,
    /// m⁻².
    PerArea,
    /// Pa.
    Pressure,
    /// A list of pure numbers.
    Numbers,
    /// A list in m.
    Lengths,
    /// A list in m⁻².
    PerAreas,
}

/// What is known of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct InputFact {
    /// Which.
    pub input: Input,
    /// The name of its option, `--asperity-density`; in Python `asperity_density`.
    pub name: &'static str,
    /// Its unit.
    pub unit: InputUnit,
    /// What it is, in a list.
    pub phrase: &'static str,
    /// What it is, in the help.
    pub help: &'static str,
}

/// Every input that can be typed.
pub const INPUTS: &[InputFact] = &{
    use Input::{
        Area, AsperityDensity, AsperityHeightStd, AsperityRadius, CriticalArea, Cutoff, Dimension,
        Gamma, Hardness, Hurst, Longest, M0, M2, M4, MaxAmplitudeRatio, MeanOffset, MeanSlope, Ra,
        RecordLength, RmsHeight, Rolloff, Roughness, SphereDensity, SphereRadius,
    };
    use InputUnit as Unit;
    [
        fact(M0, "m0", Unit::Area, "m0")
            .help("Mean square height (profile moment), such as 0.2um^2"),
        fact(M2, "m2", Unit::Number, "m2").help("Mean square slope of a profile, a pure number"),
        fact(M4, "m4", Unit::PerArea, "m4").help(
            "Mean square second derivative of a profile, such as 1e9m^-2; of a lay or a \
                 pattern the mean of both axes",
        ),
        fact(AsperityDensity, "asperity-density", Unit::PerArea, "density")
            .help("Asperities per area, such as 3e10m^-2"),
        fact(AsperityRadius, "asperity-radius", Unit::Length, "radius")
            .help("Radius of the asperities"),
        fact(AsperityHeightStd, "asperity-height-std", Unit::Length, "height deviation")
            .help("Standard deviation of the asperity heights"),
        fact(MeanOffset, "mean-offset", Unit::Length, "mean offset")
            .help("Mean asperity height above the mean plane of the surface [default: 0]"),
        fact(Hurst, "hurst", Unit::Number, "Hurst")
            .help("Hurst exponent of a self-affine spectrum"),
        fact(Rolloff, "rolloff", Unit::Length, "roll-off")
            .help("Longest wavelength of its power law"),
        fact(Cutoff, "cutoff", Unit::Length, "cut-off").help("Shortest wavelength"),
        fact(Longest, "longest", Unit::Length, "longest")
            .help("Longest wavelength, of a plateau above --rolloff [default: no plateau]"),
        fact(Gamma, "gamma", Unit::Number, "γ").help(
            "Weight of partial contact in Persson's mean gap: 1 (Persson 2007) or 0.45 \
                 (Yang & Persson 2008)",
        ),
        fact(MaxAmplitudeRatio, "max-amplitude-ratio", Unit::Number, "B_max")
            .help("Largest amplitude over wavelength, B_max"),
        fact(RecordLength, "record-length", Unit::Length, "record length").help(
            "Length of the profiles whose amplitudes are taken [default: longest \
                 wavelength]",
        ),
        fact(Dimension, "dimension", Unit::Number, "D").help(
            "Fractal dimension: of a profile, between 1 and 2 (majumdar-bhushan); of a \
                 surface, between 2 and 3 (yan-komvopoulos)",
        ),
        fact(Roughness, "roughness", Unit::Length, "G").help("Fractal roughness G"),
        fact(Area, "area", Unit::Area, "nominal area")
            .help("Nominal area; with --load the area that carries it"),
        fact(CriticalArea, "critical-area", Unit::Area, "critical area").help(
            "Fractal models: spots larger than this are elastic, smaller ones carry \
                 nothing",
        ),
        fact(Hardness, "hardness", Unit::Pressure, "hardness").help(
            "Hardness of the softer body, for elastic–plastic models [default: that of \
                 --material where the model needs one]",
        ),
        fact(SphereRadius, "sphere-radius", Unit::Lengths, "sphere radii")
            .help("Radii of the spheres of each level, coarse to fine, such as 1mm,10um"),
        fact(SphereDensity, "sphere-density", Unit::PerAreas, "sphere densities")
            .help("Spheres per area of each level, coarse to fine, such as 1mm^-2,1e4mm^-2"),
        fact(RmsHeight, "rms-height", Unit::Lengths, "rms height")
            .help("Rms height of the surface, or of each of two, such as 0.6um,0.4um"),
        fact(MeanSlope, "mean-slope", Unit::Numbers, "mean slope").help(
            "Mean absolute slope of its profiles (not the rms one), or of each of two, \
                 such as 0.1,0.08",
        ),
        fact(Ra, "ra", Unit::Lengths, "Ra").help(
            "Mean absolute height Ra in place of --rms-height: of Gaussian heights σ = \
                 √(π/2) Ra",
        ),
    ]
};

const fn fact(
    input: Input,
    name: &'static str,
    unit: InputUnit,
    phrase: &'static str,
) -> InputFact {
    InputFact { input, name, unit, phrase, help: "" }
}

impl InputFact {
    const fn help(self, help: &'static str) -> Self {
        Self { help, ..self }
    }
}

impl Input {
    /// What is known of it.
    pub(crate) fn fact(self) -> &'static InputFact {
        &INPUTS[self as usize] // a test holds that they stand in the order of the names
    }

    /// The name of its option, `asperity-density`.
    pub fn name(self) -> &'static str {
        self.fact().name
    }
}

/// Inputs that together make a model.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InputSet {
    /// All of these.
    pub required: Vec<Input>,
    /// And any of these.
    pub optional: Vec<Input>,
}

impl InputSet {
    /// Whether it holds `input`.
    pub fn takes(&self, input: Input) -> bool {
        self.required.contains(&input) || self.optional.contains(&input)
    }

    /// "m2, hardness \[m0, m4\]", with each input as `name` calls it and `between` them.
    pub fn shown(&self, name: impl Fn(Input) -> String, between: &str) -> String {
        let list = |all: &[Input]| all.iter().map(|i| name(*i)).collect::<Vec<_>>();
        let mut words = list(&self.required).join(between);
        let optional = list(&self.optional);
        let mut bracket = |inside: &str| words.extend([" [", inside, "]"]);
        if between == " " {
            for one in &optional {
                bracket(one);
            }
        } else if !optional.is_empty() {
            bracket(&optional.join(between));
        }
        words
    }
}

/// "m0, m2, m4; or …".
pub(crate) fn in_words(sets: &[InputSet]) -> String {
    let each = sets.iter().map(|set| set.shown(|i| i.fact().phrase.to_owned(), ", "));
    each.collect::<Vec<_>>().join("; or ")
}

/// What a map must be read for, beside the moments, before the model can be made from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum OfMap {
    /// Nothing, or the model is not made from a map.
    #[default]
    Moments,
    /// The radial spectrum.
    Spectrum,
    /// Amplitudes of the rows.
    Amplitudes,
    /// The power law of the radial spectrum.
    Fractal,
}

/// Everything a model may be made from. What a case does not have stays `None`.
#[derive(Debug, Clone, Serialize)]
pub struct Inputs {
    /// Contact modulus.
    pub modulus: ContactModulus,
    /// Hardness of the softer body (Pa), if the bodies yield.
    pub hardness: Option<f64>,
    /// Poisson's ratio of the softer body \[-\]; only summits that yield need it.
    pub poisson: f64,
    /// Name of the surface in its study.
    pub surface: Option<String>,
    /// Profile spectral moments.
    pub moments: Option<SpectralMoments>,
    /// m2 alone, where the other moments are not known \[-\].
    pub mean_square_slope: Option<f64>,
    /// Mean absolute profile slope of both surfaces together \[-\], if it was given or measured rather than derived from the moments.
    pub mean_slope: Option<f64>,
    /// Rms height of both surfaces together (m), if it was given likewise.
    pub rms_height: Option<f64>,
    /// Whether they are finite differences of a map or of traces, and not numbers typed in.
    pub is_measured: bool,
    /// Asperities, if they were given rather than derived from the moments.
    pub asperities: Option<AsperityStatistics>,
    /// Radial spectrum; only Persson's mean gap needs it.
    pub spectrum: Option<RoughnessSpectrum>,
    /// A continuous spectrum, in place of a radial one.
    pub self_affine: Option<SelfAffineSpectrum>,
    /// Weight of partial contact in Persson's mean gap; [`Persson::GAMMA`] if not given \[-\].
    pub gamma: Option<f64>,
    /// Amplitudes of the rows.
    pub amplitudes: Option<AmplitudeSpectrum>,
    /// Largest amplitude over wavelength, if it was given rather than taken from amplitudes \[-\].
    pub max_amplitude_ratio: Option<f64>,
    /// Dimension and roughness of a fractal fit.
    pub fractal: Option<FractalParameters>,
    /// Fitted dimension, also where it is no dimension of a profile \[-\].
    pub dimension: Option<f64>,
    /// Nominal area (m²).
    pub nominal_area: Option<f64>,
    /// Critical area of the elastic-plastic transition (m²).
    pub critical_area: Option<f64>,
    /// Spheres on spheres, coarse to fine.
    pub spheres: Vec<SphereLevel>,
}

impl Inputs {
    /// Nothing but the modulus.
    pub fn new(modulus: ContactModulus) -> Self {
        Self {
            modulus,
            hardness: None,
            poisson: 0.3,
            surface: None,
            moments: None,
            mean_square_slope: None,
            mean_slope: None,
            rms_height: None,
            is_measured: false,
            asperities: None,
            spectrum: None,
            self_affine: None,
            gamma: None,
            amplitudes: None,
            max_amplitude_ratio: None,
            fractal: None,
            dimension: None,
            nominal_area: None,
            critical_area: None,
            spheres: Vec::new(),
        }
    }

    /// Inputs that every model takes, to ask a model for what does not depend on them; the fractal dimension is
    /// that of a profile, or of a surface.
    pub(crate) fn examples() -> [Self; 2] {
        let wave = Wave { frequency: 1e4, amplitude: 1e-7 };
        let steel = ContactModulus::from_pascals(1e11).expect("a positive modulus");
        [1.3, 2.3].map(|dimension| Self {
            hardness: Some(2e9),
            moments: Some(SpectralMoments { m0: 1e-14, m2: 1e-3, m4: 1e9 }),
            amplitudes: AmplitudeSpectrum::new(vec![wave], 1e-3).ok(),
            fractal: Some(FractalParameters { dimension, roughness: 1e-10 }),
            nominal_area: Some(1e-6),
            spheres: vec![SphereLevel { radius: 1e-3, density: 1e6 }],
            ..Self::new(steel)
        })
    }

    /// The weight that Persson's mean gap has \[-\]; `None` if it cannot be made from these.
    pub fn gamma(&self) -> Option<f64> {
        let has_gap = self.spectrum.is_some() || self.self_affine.is_some();
        has_gap.then(|| self.weight())
    }

    /// The weight that is asked for, or the usual one.
    pub(crate) fn weight(&self) -> f64 {
        self.gamma.unwrap_or(Persson::GAMMA)
    }

    /// The moment m2 \[-\].
    pub fn m2(&self) -> Option<f64> {
        self.moments.map(|m| m.m2).or(self.mean_square_slope)
    }

    /// Rms gradient of the moments \[-\]; 0 without them.
    pub fn rms_gradient(&self) -> f64 {
        self.m2().map_or(0.0, |m2| (2.0 * m2).sqrt())
    }

    /// Rms height given, or that of the moments (m).
    pub(crate) fn rms_height(&self) -> Option<f64> {
        self.rms_height.or(self.moments.map(|m| m.m0.sqrt()))
    }

    /// Mean absolute profile slope given, or that of an isotropic Gaussian surface with the moments, h′rms/√π \[-\].
    pub(crate) fn mean_slope(&self) -> Option<f64> {
        self.mean_slope.or(self.moments.map(|m| m.rms_gradient() / PI.sqrt()))
    }

    /// Asperities given, or those of the moments.
    pub fn asperities(&self) -> Option<AsperityStatistics> {
        self.asperities.or_else(|| AsperityStatistics::from_moments(self.moments?).ok())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_input_is_in_its_place() {
        for (i, row) in INPUTS.iter().enumerate() {
            assert_eq!(row.input as usize, i, "{}", row.name);
            assert!(!INPUTS[..i].iter().any(|other| other.name == row.name), "{}", row.name);
        }
    }
}
