//! What must be known before the numbers are put into a contact model.

/// An assumption of the models that this surface strains, or an input that is not the surface's.
///
/// The words are those of who shows it; this project's stand in the crate `contact-report`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Warning {
    /// The map is flat: it has no roughness.
    Flat,
    /// What is left after levelling is the rounding of the heights given.
    Rounding {
        /// Rms height (m).
        rms_height: f64,
        /// Spacing of doubles at the heights given (m).
        spacing: f64,
    },
    /// A plane explains a good part of the height variance.
    Tilted {
        /// Its share (-).
        explained: f64,
    },
    /// Rows stand at heights of their own, as a scanning probe leaves them.
    RowsJump {
        /// Rms jump from row to row (m).
        jump: f64,
        /// Part of the mean square difference of neighbouring rows that it makes (-).
        share: f64,
    },
    /// Mean square slopes differ between directions; isotropic models do not hold.
    Anisotropic {
        /// Largest over smallest mean square slope (-); infinite for parallel ridges.
        ratio: f64,
    },
    /// The heights are not normally distributed; statistical models do not hold.
    NotGaussian {
        /// Ssk (-).
        skewness: f64,
        /// Sku (-).
        kurtosis: f64,
    },
    /// Bandwidth below 3/2, which no isotropic Gaussian surface has.
    NarrowBand {
        /// αN = m0 m4 / m2² (-).
        bandwidth: f64,
    },
    /// Waves close to two pixels: finite differences do not see their slopes.
    Unresolved {
        /// Rms gradient by finite differences over the one by the spectrum (-).
        ratio: f64,
    },
    /// Heights come in steps that show in the slopes and curvatures.
    Stepped {
        /// Height step (m).
        step: f64,
        /// Estimated share of the mean square slope that the steps make (-).
        m2_share: f64,
        /// Estimated share of the mean square curvature that the steps make (-).
        m4_share: f64,
    },
    /// The spectrum ends in noise that shows in the slopes and curvatures.
    Noisy {
        /// Rms of white noise at the level of the floor (m).
        rms: f64,
        /// Share of the mean square slope that this noise makes (-).
        m2_share: f64,
        /// Share of the mean square curvature that this noise makes (-).
        m4_share: f64,
        /// Shortest wavelength that stands out of the noise (m); `None` if nothing does.
        reliable: Option<f64>,
    },
    /// Many flat tops, which are not counted as summits.
    FlatTops {
        /// Flat tops.
        plateaus: usize,
        /// Summits.
        summits: usize,
    },
    /// The map does not repeat: heights jump between opposite edges.
    EdgeJump {
        /// Rms jump across the edges over the rms difference of neighbours inside (-).
        ratio: f64,
    },
    /// No roll-off inside the map: its longest waves are not sampled, and rms height grows with
    /// map size.
    NoRolloff,
    /// Few of the longest waves fit in the map.
    FewWaves {
        /// Roll-off wavelengths along the shorter side (-).
        count: f64,
    },
    /// The fitted Hurst exponent is not between 0 and 1: not a self-affine surface.
    NotSelfAffine {
        /// H (-).
        hurst: f64,
    },
}

impl Warning {
    /// A short name for scripts: `anisotropic`, `not-gaussian`, ...
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Rounding { .. } => "rounding",
            Self::Tilted { .. } => "tilted",
            Self::RowsJump { .. } => "rows-jump",
            Self::Anisotropic { .. } => "anisotropic",
            Self::NotGaussian { .. } => "not-gaussian",
            Self::NarrowBand { .. } => "narrow-band",
            Self::Unresolved { .. } => "unresolved",
            Self::Stepped { .. } => "stepped",
            Self::Noisy { .. } => "noisy",
            Self::FlatTops { .. } => "flat-tops",
            Self::EdgeJump { .. } => "edge-jump",
            Self::NoRolloff => "no-rolloff",
            Self::FewWaves { .. } => "few-waves",
            Self::NotSelfAffine { .. } => "not-self-affine",
        }
    }
}
