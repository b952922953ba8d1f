//! What must be known before the numbers are put into a contact model.

use crate::numbers::{METRES, counted, percent, quantity, significant};
use std::fmt;

/// An assumption of the models that this surface strains, or an input that is not the surface's.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Warning {
    /// There is no roughness: the map is flat, or what is left after levelling is the rounding of the heights given.
    Flat {
        /// Rms height (m); 0 if it is flat.
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
    /// Noise of the instrument shows in the slopes and curvatures: the heights come in steps, or the spectrum ends in a floor.
    Noisy {
        /// Height step that explains it (m), if one does.
        step: Option<f64>,
        /// Rms of that rounding, or of white noise at the level of the floor (m).
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
    /// Few of the longest waves fit in the map; without a roll-off inside the map or the traces they are not sampled, and
    /// rms height grows with the length measured.
    FewWaves {
        /// Roll-off wavelengths along the shorter side (-); `None` without one.
        count: Option<f64>,
    },
    /// The fitted Hurst exponent is not between 0 and 1: not a self-affine surface.
    NotSelfAffine {
        /// H (-).
        hurst: f64,
    },
}

impl Warning {
    /// That there is no roughness above four spacings (m) of doubles at the heights given.
    pub fn flat(rms_height: f64, spacing: f64) -> Option<Self> {
        let is_flat = rms_height <= 0.0 || rms_height < 4.0 * spacing;
        is_flat.then_some(Self::Flat { rms_height, spacing })
    }

    /// Of the height distribution and of Nayak's bandwidth (1971), which is 3/2 at least.
    pub(crate) fn of_distribution(
        skewness: Option<f64>,
        kurtosis: Option<f64>,
        bandwidth: Option<f64>,
    ) -> [Option<Self>; 2] {
        let is_far = |&(s, k): &(f64, f64)| s.abs() > 0.2 || (k - 3.0).abs() > 0.3;
        let shape = skewness.zip(kurtosis).filter(is_far);
        let not_gaussian =
            shape.map(|(skewness, kurtosis)| Self::NotGaussian { skewness, kurtosis });
        let narrow = bandwidth.filter(|b| *b < 1.5).map(|bandwidth| Self::NarrowBand { bandwidth });
        [not_gaussian, narrow]
    }

    /// Of the rms gradient by finite differences over the one by the spectrum (-).
    pub(crate) fn of_resolution(ratio: f64) -> Option<Self> {
        (ratio < 0.94).then_some(Self::Unresolved { ratio })
    }

    /// Of the fitted Hurst exponent (-).
    pub(crate) fn of_hurst(hurst: Option<f64>) -> Option<Self> {
        let outside = hurst.filter(|h| !(0.0..=1.0).contains(h));
        outside.map(|hurst| Self::NotSelfAffine { hurst })
    }

    /// A short name for scripts: `anisotropic`, `not-gaussian`, ...
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Flat { rms_height, .. } if *rms_height > 0.0 => "rounding",
            Self::Flat { .. } => "flat",
            Self::Tilted { .. } => "tilted",
            Self::RowsJump { .. } => "rows-jump",
            Self::Anisotropic { .. } => "anisotropic",
            Self::NotGaussian { .. } => "not-gaussian",
            Self::NarrowBand { .. } => "narrow-band",
            Self::Unresolved { .. } => "unresolved",
            Self::Noisy { step: Some(_), .. } => "stepped",
            Self::Noisy { .. } => "noisy",
            Self::FlatTops { .. } => "flat-tops",
            Self::EdgeJump { .. } => "edge-jump",
            Self::FewWaves { count: None } => "no-rolloff",
            Self::FewWaves { .. } => "few-waves",
            Self::NotSelfAffine { .. } => "not-self-affine",
        }
    }

    /// What was found, with its number; its effect, and what to do.
    pub fn message(&self) -> [String; 2] {
        let ratio = |x: f64| significant(x, 2);
        match *self {
            Self::Flat { rms_height, spacing } if rms_height > 0.0 => worded(
                format!("The rms height of {} is rounding.", quantity(rms_height, METRES, 2)),
                format!(
                    "The heights are stored to {}; what is left after levelling is no roughness.",
                    quantity(spacing, METRES, 1)
                ),
            ),
            Self::Flat { .. } => worded(
                "The map is flat.",
                "There is no roughness: any load closes the contact, and the models have no input.",
            ),
            Self::Tilted { explained } => worded(
                format!("A plane explains {} of the height variance.", percent(explained)),
                "A tilt left in moves the gap by 3 to 14\u{202F}% and the summit models by −7 to \
                 −11\u{202F}%. Level the map, unless the tilt belongs to the contact.",
            ),
            Self::RowsJump { jump, share } => worded(
                format!("Rows of the map jump: by {} rms.", quantity(jump, METRES, 2)),
                format!(
                    "That makes {} of the mean square difference between rows: slopes across them are \
                     those of the scan, not of the surface. Align the rows.",
                    percent(share)
                ),
            ),
            Self::EdgeJump { ratio: r } => worded(
                format!("Edges do not match: they jump {} times the inner step.", ratio(r)),
                "Repeated as it is, the map has a step there: spectral moments contain it, and a solution \
                 presses on it.",
            ),
            Self::Anisotropic { ratio: r } if r > 1e6 => worded(
                "The surface has a lay: one direction has no slope.",
                "The closed forms assume an isotropic surface; none of them is safe.",
            ),
            Self::Anisotropic { ratio: r } => worded(
                format!("The surface has a lay: slope anisotropy {}.", significant(r, 3)),
                "The closed forms assume an isotropic surface; beyond 2 none of them is safe.",
            ),
            Self::NotGaussian { skewness, kurtosis } => worded(
                format!(
                    "Heights are not normal: skewness {}, kurtosis {}.",
                    ratio(skewness),
                    ratio(kurtosis)
                ),
                "The closed forms assume 0 and 3; beyond ±0.2 and ±0.3 none of them is safe.",
            ),
            Self::NarrowBand { bandwidth } => worded(
                format!("Bandwidth α = {} is below 1.5.", significant(bandwidth, 4)),
                "No isotropic Gaussian surface has that; the summit models do not apply.",
            ),
            Self::Unresolved { ratio: r } => worded(
                format!("Finite differences recover {} of the spectral rms gradient.", percent(r)),
                "The shortest waves are near two points, so m₂, m₄ and every area depend on the point spacing. Measure finer, or \
                 remove short wavelengths and quote the cut-off.",
            ),
            Self::Noisy { step: Some(step), m2_share, m4_share, .. } => worded(
                format!(
                    "Height steps of {} make {} of m₂ and {} of m₄.",
                    quantity(step, METRES, 2),
                    percent(m2_share),
                    percent(m4_share)
                ),
                "Models made of them describe the instrument. Measure with finer steps, or remove \
                 short wavelengths.",
            ),
            Self::Noisy { step: None, rms, m2_share, m4_share, reliable } => worded(
                format!(
                    "{} of m₄ and {} of m₂ are noise of {} rms.",
                    percent(m4_share),
                    percent(m2_share),
                    quantity(rms, METRES, 2)
                ),
                format!(
                    "Every model made of them describes the instrument, and so does the area at light \
                     load.{}",
                    reliable.map_or(String::new(), |l| format!(
                        " Waves longer than {} stand out of the noise: remove shorter ones and quote \
                         the cut-off.",
                        quantity(l, METRES, 2)
                    ))
                ),
            ),
            Self::FlatTops { plateaus, summits } => worded(
                format!("{} beside {}.", counted(plateaus, "flat top"), counted(summits, "summit")),
                "Height steps hide summits; the count depends on the step.",
            ),
            Self::FewWaves { count: None } => worded(
                "No roll-off within what was measured.",
                "The longest waves are not sampled: rms height and everything made of it grow with \
                 the measured length. m₂ and m₄ hardly do.",
            ),
            Self::FewWaves { count: Some(count) } => worded(
                format!("The map is only {} roll-off wavelengths wide.", ratio(count)),
                "Another map of the same surface will give other numbers: only an uncertainty with \
                 sampling variability covers that.",
            ),
            Self::NotSelfAffine { hurst } => worded(
                format!("The spectrum fits H = {}.", outside_unit(hurst)),
                "A self-affine surface has more than 0 and less than 1: over this range this is none, \
                 and fractal parameters have no meaning.",
            ),
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message().join(" "))
    }
}

fn worded(claim: impl Into<String>, text: impl Into<String>) -> [String; 2] {
    [claim.into(), text.into()]
}

/// A number that is not between 0 and 1, with as many digits as it takes to see that.
fn outside_unit(value: f64) -> String {
    let digits = (2..12).find(|&d: &i32| {
        let shown: f64 = format!("{value:.*e}", (d - 1) as usize).parse().unwrap_or(value);
        !(0.0..=1.0).contains(&shown)
    });
    significant(value, digits.unwrap_or(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_beyond_one_is_not_shown_as_one() {
        assert_eq!(outside_unit(1.003), "1.003");
        assert_eq!(outside_unit(1.27), "1.3");
        assert_eq!(outside_unit(-0.2), "\u{2212}0.20");
    }

    #[test]
    fn a_ratio_without_end_is_not_printed() {
        for ratio in [3.0, 1e7, f64::INFINITY] {
            let words = Warning::Anisotropic { ratio }.to_string();
            assert!(words.contains("lay") && !words.contains("inf"), "{ratio}");
        }
    }
}
