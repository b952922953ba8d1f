//! The question every model answers, and the shape of its answer.

use crate::ModelError;
use crate::error::number;
use std::borrow::Cow;

/// Where a theory comes from. Texts are borrowed from the program or owned, so that a model read
/// at run time can be cited like a built-in one.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Citation {
    /// Authors, for example "Bush, Gibson & Thomas".
    pub authors: Cow<'static, str>,
    /// Year of publication.
    pub year: u16,
    /// Title of the paper.
    pub title: Cow<'static, str>,
    /// Journal, volume and page.
    pub journal: Cow<'static, str>,
    /// DOI without resolver; empty if the source has none.
    pub doi: Cow<'static, str>,
}

impl Citation {
    /// A paper; an empty `doi` if it has none.
    pub const fn new(
        authors: &'static str,
        year: u16,
        title: &'static str,
        journal: &'static str,
        doi: &'static str,
    ) -> Self {
        Self {
            authors: Cow::Borrowed(authors),
            year,
            title: Cow::Borrowed(title),
            journal: Cow::Borrowed(journal),
            doi: Cow::Borrowed(doi),
        }
    }
}

/// An answer was given, but something about it must be known.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(tag = "kind", rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum Caveat {
    /// The formula reached its ceiling and the value was clipped to it.
    Saturated {
        /// Which quantity was clipped.
        quantity: Cow<'static, str>,
    },
    /// The value is what the formula says, but an assumption of the theory is strained.
    BeyondModel {
        /// The quantity that shows it.
        quantity: Cow<'static, str>,
        /// Its value.
        #[cfg_attr(feature = "serde", serde(serialize_with = "crate::any_number::serialize"))]
        value: f64,
        /// Where the assumption is usually taken to end.
        #[cfg_attr(feature = "serde", serde(serialize_with = "crate::any_number::serialize"))]
        limit: f64,
        /// What is strained.
        reason: Cow<'static, str>,
    },
    /// The value is too small for a double; the logarithmic interface still answers.
    Underflow {
        /// Which quantity underflowed.
        quantity: Cow<'static, str>,
    },
}

impl std::fmt::Display for Caveat {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Saturated { quantity } => write!(f, "{quantity} reached its upper limit"),
            Self::BeyondModel { quantity, value, limit, reason } => {
                let short = format!("{value:.3e}").parse().unwrap_or(*value);
                write!(f, "{quantity} = {}, limit {}: {reason}", number(short), number(*limit))
            }
            Self::Underflow { quantity } => {
                write!(f, "{quantity} is smaller than the smallest double")
            }
        }
    }
}

/// One point of a contact curve. The default is that of bodies that do not touch: no load, no area, and no separation that
/// is finite.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ContactState {
    /// Nominal pressure F / A_n \[Pa\].
    pub mean_pressure: f64,
    /// Real area fraction A_r / A_n \[-\].
    pub area_fraction: f64,
    /// Distance of the rigid flat from the mean plane of the undeformed heights \[m\]; `None` if
    /// the theory has no such quantity.
    pub separation: Option<f64>,
    /// Mean gap after deformation \[m\]; `None` if the theory is silent.
    pub mean_gap: Option<f64>,
    /// What must be known about this answer.
    pub caveat: Option<Caveat>,
}

/// Area fraction at which contacts are usually taken to be isolated no longer (a choice, not a
/// theorem).
const MOST_ISOLATED_AREA: f64 = 0.1;

impl ContactState {
    /// The answer of a theory whose summits do not feel each other, at a separation (m), with a caveat
    /// where so much touches that they would, and where a number is below the normal doubles.
    pub fn of_isolated_summits(mean_pressure: f64, area_fraction: f64, separation: f64) -> Self {
        let caveat = if mean_pressure < f64::MIN_POSITIVE {
            Some(Caveat::Underflow { quantity: "mean pressure".into() })
        } else if area_fraction < f64::MIN_POSITIVE {
            Some(Caveat::Underflow { quantity: "area fraction".into() })
        } else if area_fraction > MOST_ISOLATED_AREA {
            Some(Caveat::BeyondModel {
                quantity: "area fraction".into(),
                value: area_fraction,
                limit: MOST_ISOLATED_AREA,
                reason: "contacts are no longer isolated".into(),
            })
        } else {
            None
        };
        let separation = Some(separation);
        Self { mean_pressure, area_fraction, separation, mean_gap: None, caveat }
    }

    /// Mean pressure on the real area, F / A_r \[Pa\]; `None` where nothing touches.
    pub fn real_pressure(&self) -> Option<f64> {
        let pressure = self.mean_pressure / self.area_fraction;
        (self.area_fraction > 0.0 && pressure.is_finite()).then_some(pressure)
    }
}

/// A closed-form or semi-analytic model of rough contact.
pub trait ContactModel: Send + Sync {
    /// The paper to cite.
    fn citation(&self) -> Citation;

    /// The contact at nominal pressure `mean_pressure` (Pa).
    ///
    /// # Errors
    /// [`ModelError`] if the pressure is negative or not finite, or the theory has no meaning
    /// there.
    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError>;

    /// Area fractions between which the real area lies for 95 of 100 surfaces where the model answers
    /// `area_fraction`; `None` for a model that does not know its own error.
    fn area_interval(&self, area_fraction: f64) -> Option<[f64; 2]> {
        let _ = area_fraction;
        None
    }

    /// Contact conductance per nominal area at a nominal pressure (Pa), over the harmonic mean conductivity of the bodies
    /// (1/m): by the formula, and by the expression that it is a fit of. `None` of a theory of the contact alone.
    ///
    /// # Errors
    /// As [`at_pressure`](Self::at_pressure).
    fn conductance(&self, mean_pressure: f64) -> Result<Option<[f64; 2]>, ModelError> {
        let _ = mean_pressure;
        Ok(None)
    }

    /// The formula on a line, of a model short enough for a pocket calculator; `None` of others.
    fn formula(&self) -> Option<String> {
        None
    }
}

/// A model whose natural variable is the separation of the mean planes.
pub trait SeparationModel: ContactModel {
    /// The contact at `separation` (m): rigid flat to mean plane of the undeformed heights.
    ///
    /// # Errors
    /// [`ModelError`] if the separation is not finite or the theory has no meaning there.
    fn at_separation(&self, separation: f64) -> Result<ContactState, ModelError>;
}
