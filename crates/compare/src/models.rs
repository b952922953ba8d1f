//! The only list of all models. Adding a model is one row here.

use asperity_models::{BushGibsonThomas, GreenwoodElliptical};
use contact_types::{
    AmplitudeSpectrum, AsperityStatistics, Citation, ContactModel, ContactModulus,
    FractalParameters, ModelError, RoughnessSpectrum, SeparationModel, SpectralMoments, Wave,
};
use gw_closed_form::{GreenwoodWilliamson, asperities_from_moments};
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, Persson, SelfAffineSpectrum, SphereLevel, Stacked,
};

/// Everything a model may be made from. What a case does not have stays `None`.
#[derive(Debug, Clone)]
pub struct Inputs {
    /// Contact modulus.
    pub modulus: ContactModulus,
    /// Profile spectral moments.
    pub moments: Option<SpectralMoments>,
    /// Where they come from.
    pub source: MomentSource,
    /// Asperities, if they were given rather than derived from the moments.
    pub asperities: Option<AsperityStatistics>,
    /// Radial spectrum; only Persson's mean gap needs it.
    pub spectrum: Option<RoughnessSpectrum>,
    /// A continuous spectrum, in place of a radial one.
    pub self_affine: Option<SelfAffineSpectrum>,
    /// Weight of partial contact in Persson's mean gap; 1 if not given \[-\].
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

/// Where moments come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MomentSource {
    /// Finite differences of a map.
    FiniteDifferences,
    /// Numbers typed in.
    Given,
}

impl MomentSource {
    /// Short name for files.
    pub fn name(self) -> &'static str {
        match self {
            Self::FiniteDifferences => "finite-differences",
            Self::Given => "given",
        }
    }
}

impl Inputs {
    /// Nothing but the modulus.
    pub fn new(modulus: ContactModulus) -> Self {
        Self {
            modulus,
            moments: None,
            source: MomentSource::Given,
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

    /// Inputs that every model takes, to ask a model for what does not depend on them.
    fn example() -> Self {
        let wave = Wave { frequency: 1e4, amplitude: 1e-7 };
        let steel = ContactModulus::from_pascals(1e11).expect("a positive modulus");
        Self {
            moments: Some(SpectralMoments { m0: 1e-14, m2: 1e-3, m4: 1e9 }),
            amplitudes: AmplitudeSpectrum::new(vec![wave], 1e-3).ok(),
            fractal: Some(FractalParameters { dimension: 1.3, roughness: 1e-10 }),
            nominal_area: Some(1e-6),
            spheres: vec![SphereLevel { radius: 1e-3, density: 1e6 }],
            ..Self::new(steel)
        }
    }

    /// Rms gradient of the moments \[-\]; 0 without them.
    pub fn rms_gradient(&self) -> f64 {
        self.moments.map_or(0.0, |m| m.rms_gradient())
    }

    /// Asperities given, or those of the moments.
    pub fn asperities(&self) -> Option<AsperityStatistics> {
        self.asperities.or_else(|| asperities_from_moments(self.moments?).ok())
    }
}

/// Why a model could not be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BuildError {
    /// An input it needs is absent.
    #[error("{model} needs {needs}")]
    Missing {
        /// The model.
        model: &'static str,
        /// What is absent.
        needs: &'static str,
    },
    /// The theory refuses it.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// How a model is made: one whose theory has a separation of the undeformed planes, or one that
/// knows the pressure only.
enum Build {
    Separation(fn(&Inputs) -> Result<Box<dyn SeparationModel>, BuildError>),
    Pressure(fn(&Inputs) -> Result<Box<dyn ContactModel>, BuildError>),
}

/// One row of the list.
pub struct ModelEntry {
    /// Name for commands and files.
    pub name: &'static str,
    /// Short label in figures.
    pub label: &'static str,
    /// Name in full.
    pub title: &'static str,
    /// What it needs, in words.
    pub inputs: &'static str,
    /// Where the theory holds.
    pub domain: &'static str,
    /// True if a height map gives all it needs.
    pub in_study: bool,
    /// What its theory assumes, for the verdict on a surface.
    pub assumes: Assumes,
    build: Build,
}

impl std::fmt::Debug for ModelEntry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ModelEntry").field("name", &self.name).finish_non_exhaustive()
    }
}

/// What a theory assumes of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Assumes {
    /// Isotropic Gaussian surface, summits that do not feel each other: light contact only.
    Summits,
    /// Isotropic Gaussian surface, any load.
    Gaussian,
    /// One dominant amplitude over wavelength, from rows of a given length.
    Amplitudes,
    /// A fractal profile over the fit range.
    Fractal,
}

impl ModelEntry {
    /// Makes the model.
    ///
    /// # Errors
    /// [`BuildError::Missing`] if an input is absent, [`BuildError::Model`] if the theory has no
    /// meaning for it.
    pub fn build(&self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        match self.build {
            Build::Separation(build) => Ok(build(inputs)?),
            Build::Pressure(build) => build(inputs),
        }
    }

    /// True if the theory answers at a separation.
    pub fn has_separation(&self) -> bool {
        matches!(self.build, Build::Separation(_))
    }

    /// Makes the model for questions at a separation; `None` if its theory has none.
    pub fn build_separation(
        &self,
        inputs: &Inputs,
    ) -> Option<Result<Box<dyn SeparationModel>, BuildError>> {
        match self.build {
            Build::Separation(build) => Some(build(inputs)),
            Build::Pressure(_) => None,
        }
    }

    /// The paper.
    #[allow(clippy::missing_panics_doc, reason = "a test builds every row from these inputs")]
    pub fn citation(&self) -> Citation {
        self.build(&Inputs::example()).expect("every model takes the example").citation()
    }
}

/// The row of a name.
pub fn find(name: &str) -> Option<&'static ModelEntry> {
    MODELS.iter().find(|m| m.name == name)
}

fn missing<T>(value: Option<T>, model: &'static str, needs: &'static str) -> Result<T, BuildError> {
    value.ok_or(BuildError::Missing { model, needs })
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

fn with_gamma(model: Persson, inputs: &Inputs) -> Result<Persson, ModelError> {
    match inputs.gamma {
        Some(gamma) => model.with_gamma(gamma),
        None => Ok(model),
    }
}

/// Every model.
pub static MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "gw",
        label: "GW",
        title: "Greenwood–Williamson, exact",
        inputs: "m0, m2, m4, or density, radius, height deviation and mean offset of asperities",
        domain: "isotropic Gaussian surface, contact below about 10 % of it",
        in_study: true,
        assumes: Assumes::Summits,
        build: Build::Separation(|inputs| {
            if let Some(asperities) = inputs.asperities {
                return Ok(Box::new(GreenwoodWilliamson::new(asperities, inputs.modulus)?));
            }
            let moments = moments(inputs, "Greenwood-Williamson")?;
            Ok(Box::new(GreenwoodWilliamson::from_moments(moments, inputs.modulus)?))
        }),
    },
    ModelEntry {
        name: "bgt",
        label: "BGT",
        title: "Bush–Gibson–Thomas",
        inputs: "m0, m2, m4",
        domain: "isotropic Gaussian surface with bandwidth of at least 1.5, light contact",
        in_study: true,
        assumes: Assumes::Summits,
        build: Build::Separation(|inputs| {
            let moments = moments(inputs, "Bush-Gibson-Thomas")?;
            Ok(Box::new(BushGibsonThomas::new(moments, inputs.modulus)?))
        }),
    },
    ModelEntry {
        name: "greenwood-elliptical",
        label: "Elliptical",
        title: "Greenwood simplified elliptical",
        inputs: "m0, m2, m4",
        domain: "isotropic Gaussian surface with bandwidth of at least 1.5, light contact",
        in_study: true,
        assumes: Assumes::Summits,
        build: Build::Separation(|inputs| {
            let moments = moments(inputs, "Greenwood simplified elliptical")?;
            Ok(Box::new(GreenwoodElliptical::new(moments, inputs.modulus)?))
        }),
    },
    ModelEntry {
        name: "persson",
        label: "Persson",
        title: "Persson",
        inputs: "m2; a spectrum for the mean gap",
        domain: "isotropic Gaussian surface, any load; reads low at light load",
        in_study: true,
        assumes: Assumes::Gaussian,
        build: Build::Pressure(|inputs| {
            if let Some(spectrum) = &inputs.spectrum {
                let model = Persson::from_spectrum(spectrum, inputs.modulus)?;
                return Ok(Box::new(with_gamma(model, inputs)?));
            }
            if let Some(spectrum) = inputs.self_affine {
                let model = Persson::from_self_affine(spectrum, inputs.modulus)?;
                return Ok(Box::new(with_gamma(model, inputs)?));
            }
            let moments = missing(inputs.moments, "Persson", "a spectrum or the moment m2")?;
            Ok(Box::new(Persson::from_moments(moments, inputs.modulus)?))
        }),
    },
    ModelEntry {
        name: "stacked",
        label: "Stacked",
        title: "Stacked multiscale",
        inputs: "amplitudes of the rows (B_max)",
        domain: "depends on the record length and on the direction of the rows",
        in_study: true,
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(|inputs| {
            if let Some(ratio) = inputs.max_amplitude_ratio {
                return Ok(Box::new(Stacked::new(ratio, inputs.modulus)?));
            }
            let amplitudes = amplitudes(inputs, "Stacked multiscale")?;
            Ok(Box::new(Stacked::from_amplitudes(amplitudes, inputs.modulus)?))
        }),
    },
    ModelEntry {
        name: "multiscale",
        label: "Multiscale",
        title: "Jackson–Streator multiscale",
        inputs: "amplitudes of the rows, at every frequency",
        domain: "depends on the record length and on the direction of the rows",
        in_study: true,
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(|inputs| {
            let amplitudes = amplitudes(inputs, "Jackson-Streator multiscale")?;
            Ok(Box::new(JacksonStreator::new(amplitudes.clone(), inputs.modulus)?))
        }),
    },
    ModelEntry {
        name: "archard",
        label: "Archard",
        title: "Archard, spheres on spheres",
        inputs: "radius and density of the spheres of each level",
        domain: "many spheres per contact of the level above, and far apart",
        in_study: false,
        assumes: Assumes::Amplitudes,
        build: Build::Pressure(|inputs| {
            let spheres = Some(&inputs.spheres).filter(|spheres| !spheres.is_empty());
            let spheres = missing(spheres, "Archard", "the radius and density of its spheres")?;
            Ok(Box::new(Archard::new(spheres, inputs.modulus)?))
        }),
    },
    ModelEntry {
        name: "majumdar-bhushan",
        label: "MB",
        title: "Majumdar–Bhushan, elastic part",
        inputs: "dimension D, roughness G, nominal area; a critical area for D of 1.5 and more",
        domain: "1 < D < 1.5 without a critical area",
        in_study: true,
        assumes: Assumes::Fractal,
        build: Build::Pressure(|inputs| {
            const MODEL: &str = "Majumdar-Bhushan";
            let fractal = missing(
                inputs.fractal,
                MODEL,
                "a fractal fit with 1 < D < 2 over at least an octave",
            )?;
            let area = missing(inputs.nominal_area, MODEL, "the nominal area")?;
            let model = MajumdarBhushan::new(fractal, area, inputs.modulus)?;
            Ok(match inputs.critical_area {
                Some(critical) => Box::new(model.with_critical_area(critical)?),
                None => Box::new(model),
            })
        }),
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Every row makes its model, which answers and cites its paper; names are unique.
    #[test]
    fn every_row_is_complete() {
        for (i, entry) in MODELS.iter().enumerate() {
            let model = entry.build(&Inputs::example()).unwrap();
            assert!(entry.citation().year > 1950, "{}", entry.name);
            let state = model.at_pressure(1e6).unwrap();
            assert!(state.area_fraction > 0.0 && state.area_fraction < 1.0, "{}", entry.name);
            assert!(MODELS[..i].iter().all(|m| m.name != entry.name && m.label != entry.label));
            assert!(std::ptr::eq(find(entry.name).unwrap(), entry));
        }
        assert!(find("nothing").is_none());
    }

    #[test]
    fn a_missing_input_is_named() {
        let bare = Inputs::new(ContactModulus::from_pascals(1e11).unwrap());
        for entry in MODELS {
            assert!(
                matches!(entry.build(&bare), Err(BuildError::Missing { .. })),
                "{}",
                entry.name
            );
        }
    }
}
