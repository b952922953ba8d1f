//! What must be known before the numbers are put into a contact model.

use std::fmt;

/// An assumption of the models that this surface strains, or an input that is not the surface's.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
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

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Flat => write!(f, "the map is flat: it has no roughness to model"),
            Self::Rounding { rms_height, spacing } => write!(
                f,
                "the rms height of {rms_height:.1e} m is the rounding of the heights given, which \
                 are stored to {spacing:.1e} m: the map is flat"
            ),
            Self::Tilted { explained } => write!(
                f,
                "a plane explains {:.0} % of the height variance: level the map (plane) unless the \
                 tilt belongs to the contact",
                100.0 * explained
            ),
            Self::RowsJump { jump, share } => write!(
                f,
                "rows jump by {jump:.1e} m rms, {:.0} % of the mean square difference between rows: \
                 put them in line before anything is made of slopes across them",
                100.0 * share
            ),
            Self::Anisotropic { ratio } if ratio > 1e6 => write!(
                f,
                "one direction has no slope: the closed forms assume an isotropic surface, this one \
                 is a set of parallel ridges"
            ),
            Self::Anisotropic { ratio } => write!(
                f,
                "mean square slopes differ by a factor of {ratio:.1} between directions (limit 2): \
                 the closed forms assume an isotropic surface"
            ),
            Self::NotGaussian { skewness, kurtosis } => write!(
                f,
                "skewness {skewness:.2} and kurtosis {kurtosis:.2} are not those of Gaussian heights \
                 (0 \u{b1} 0.2 and 3 \u{b1} 0.3): the statistical models assume them"
            ),
            Self::NarrowBand { bandwidth } => write!(
                f,
                "bandwidth m0 m4 / m2\u{b2} = {bandwidth:.2} is below 1.5, the least of any isotropic \
                 Gaussian surface: summit models do not apply"
            ),
            Self::Unresolved { ratio } => write!(
                f,
                "finite differences see {:.0} % of the rms gradient of the spectrum: the shortest \
                 waves are close to two pixels, and m2, m4 and everything made of them depend on \
                 the pixel size",
                100.0 * ratio
            ),
            Self::Stepped { step, m2_share, m4_share } => write!(
                f,
                "height steps of {:.3} nm make about {:.0} % of m2 and {:.0} % of m4: asperity \
                 density, radius and every model made of them describe the instrument; remove \
                 wavelengths below some pixels or measure with finer steps",
                1e9 * step,
                100.0 * m2_share,
                100.0 * m4_share
            ),
            Self::Noisy { rms, m2_share, m4_share, reliable } => {
                write!(
                    f,
                    "white noise of {:.2} nm rms makes about {:.0} % of m2 and {:.0} % of m4: ",
                    1e9 * rms,
                    100.0 * m2_share,
                    100.0 * m4_share
                )?;
                match reliable {
                    Some(wavelength) => write!(
                        f,
                        "waves shorter than {:.3} \u{b5}m cannot be told from it; filter them out \
                         before using a model",
                        1e6 * wavelength
                    ),
                    None => write!(f, "the spectrum is flat, nothing stands out of it"),
                }
            }
            Self::FlatTops { plateaus, summits } => write!(
                f,
                "{plateaus} flat tops beside {summits} summits: height steps hide summits, and the \
                 count depends on the step"
            ),
            Self::EdgeJump { ratio } => write!(
                f,
                "heights jump between opposite edges {ratio:.0} times as much as between \
                 neighbours: the map does not repeat, and its spectral moments contain the jump"
            ),
            Self::NoRolloff => write!(
                f,
                "no roll-off within the map: its longest waves are not sampled, and rms height and \
                 everything made of it grow with the size of the map"
            ),
            Self::FewWaves { count } => write!(
                f,
                "only {count:.1} of the longest waves fit along the shorter side: another map of \
                 the same surface will give other numbers"
            ),
            Self::NotSelfAffine { hurst } => write!(
                f,
                "the spectrum fits a Hurst exponent of {hurst:.2}, not one between 0 and 1: fractal \
                 parameters have no meaning over this range of wavelengths"
            ),
        }
    }
}
