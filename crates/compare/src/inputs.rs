//! Everything a model may be made from.

use contact_types::{
    AmplitudeSpectrum, AsperityStatistics, ContactModulus, FractalParameters, RoughnessSpectrum,
    SpectralMoments, Wave,
};
use multiscale_models::{Persson, SelfAffineSpectrum, SphereLevel};
use serde::Serialize;
use std::f64::consts::PI;

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
    /// Mean absolute profile slope of both surfaces together \[-\], if it was given rather than derived from the moments.
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
        [1.3, 2.3].map(Self::example)
    }

    fn example(dimension: f64) -> Self {
        let wave = Wave { frequency: 1e4, amplitude: 1e-7 };
        let steel = ContactModulus::from_pascals(1e11).expect("a positive modulus");
        Self {
            hardness: Some(2e9),
            moments: Some(SpectralMoments { m0: 1e-14, m2: 1e-3, m4: 1e9 }),
            amplitudes: AmplitudeSpectrum::new(vec![wave], 1e-3).ok(),
            fractal: Some(FractalParameters { dimension, roughness: 1e-10 }),
            nominal_area: Some(1e-6),
            spheres: vec![SphereLevel { radius: 1e-3, density: 1e6 }],
            ..Self::new(steel)
        }
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
