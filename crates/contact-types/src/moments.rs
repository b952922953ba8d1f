//! A rough surface reduced to a few numbers.

/// Profile spectral moments of the equivalent rough surface (Nayak 1971, doi:10.1115/1.3451608).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralMoments {
    /// Mean square height [m²].
    pub m0: f64,
    /// Mean square slope of a profile, `<|grad h|^2> / 2` [-].
    pub m2: f64,
    /// Mean square second derivative of a profile, `3 <(laplace h)^2> / 8` [m⁻²].
    pub m4: f64,
}

impl SpectralMoments {
    /// Rms height σ = √m0 [m].
    pub fn rms_height(&self) -> f64 {
        self.m0.sqrt()
    }

    /// Rms gradient of the surface h'_rms = √(2 m2) [-].
    pub fn rms_gradient(&self) -> f64 {
        (2.0 * self.m2).sqrt()
    }

    /// Nayak's bandwidth parameter α = m0 m4 / m2² [-]; at least 3/2 for an isotropic Gaussian
    /// surface.
    pub fn bandwidth(&self) -> f64 {
        (self.m0 / self.m2) * (self.m4 / self.m2)
    }
}

/// Asperities (summits) as Greenwood and Williamson see them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AsperityStatistics {
    /// Asperities per nominal area η [m⁻²].
    pub density: f64,
    /// Radius of every summit R [m].
    pub radius: f64,
    /// Standard deviation of summit heights σ_s [m].
    pub height_std: f64,
    /// Mean summit height above the mean plane of the surface y_s [m].
    pub mean_offset: f64,
}

/// Parameters of a fractal profile (Majumdar & Bhushan 1991, doi:10.1115/1.2920588).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FractalParameters {
    /// Dimension of a profile D, between 1 and 2 [-].
    pub dimension: f64,
    /// Fractal roughness G [m].
    pub roughness: f64,
}
