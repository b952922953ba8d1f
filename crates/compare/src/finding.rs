//! What may change a conclusion, was tested and is fine, or keeps a theory from a surface: as numbers. `report` has the words.

use crate::EdgesName;
use crate::adhesion::Adhesion;
use crate::theory::BuildError;
use contact_accuracy::{EdgeShare, NoUncertainty, Reached};
use contact_types::{Caveat, Named};
use serde::{Deserialize, Serialize};
use surface_stats::Warning;
use surface_stats::clean::Record;
use surface_stats::pair::Independence;

/// How uneven the points of a file were before they were put at equal distances.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Unevenness {
    /// Shortest and longest distance of neighbouring points (m).
    pub steps: [f64; 2],
    /// Their distance now (m).
    pub spacing: f64,
}

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Weight {
    /// May change a conclusion.
    Check,
    /// Good to know.
    Note,
    /// Tested and fine.
    Passed,
}

impl Named for Weight {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Check, "check"), (Self::Note, "note"), (Self::Passed, "passed")];
}

/// One finding.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Finding {
    /// How much it matters.
    pub weight: Weight,
    /// The body of a pair that it was found on; `None` if it is of the whole.
    pub body: Option<String>,
    /// What was found.
    pub fact: Fact,
}

impl Finding {
    /// A fact of this weight.
    pub(crate) fn of(weight: Weight, fact: Fact) -> Self {
        Self { weight, body: None, fact }
    }

    /// A fact that may change a conclusion.
    pub(crate) fn check(fact: Fact) -> Self {
        Self::of(Weight::Check, fact)
    }

    /// A fact that is good to know.
    pub(crate) fn note(fact: Fact) -> Self {
        Self::of(Weight::Note, fact)
    }

    /// A fact that may change a conclusion if it `matters`, and is good to know if not.
    pub(crate) fn check_if(matters: bool, fact: Fact) -> Self {
        Self::of(if matters { Weight::Check } else { Weight::Note }, fact)
    }

    /// What the statistics warn of.
    pub(crate) fn warned(warning: Warning) -> Self {
        let is_note = matches!(
            warning,
            Warning::FlatTops { .. }
                | Warning::EdgeJump { .. }
                | Warning::FewWaves { .. }
                | Warning::NotSelfAffine { .. }
        );
        Self::check_if(!is_note, Fact::Warned(warning))
    }

    /// What it is about: `material` (what the solids bear), `surface` (the heights), `grid` (the point spacing, against
    /// what it has to resolve), `solution`, `edges` (what lies beyond them) or `plan` (the choice for an accuracy).
    pub fn subject(&self) -> &'static str {
        match &self.fact {
            Fact::Yield { .. }
            | Fact::Yielding { .. }
            | Fact::Unit { hardness: Some(_), .. }
            | Fact::Adhesion(_) => "material",
            Fact::NoUncertainty { why, .. } if is_unsolved(why) => "solution",
            Fact::PlanUnmet(_) => "plan",
            Fact::Interpolation { .. } | Fact::NoUncertainty { .. } | Fact::BelowPoint { .. } => {
                "grid"
            }
            Fact::EdgeJump { .. } => "edges",
            _ => "surface",
        }
    }
}

/// Whether an area has no uncertainty because its load was not solved to the tolerance.
pub(crate) fn is_unsolved(why: &NoUncertainty) -> bool {
    matches!(why, NoUncertainty::NotConverged { .. })
}

/// What was found, with its numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fact {
    /// Sizes that no rough surface has, or a hardness that solids of this modulus do not have: is the unit right? Each `None`
    /// where it is usual.
    Unit {
        /// Rms gradient \[-\].
        gradient: Option<f64>,
        /// Rms height (m).
        rms_height: Option<f64>,
        /// Radius of asperities (m).
        radius: Option<f64>,
        /// Hardness, and that of solids from low to high (Pa).
        hardness: Option<[f64; 3]>,
    },
    /// The elastic answer presses harder than solids of this modulus usually bear.
    Yield {
        /// The lightest load at which it is too high.
        at: Pressed,
        /// Contact modulus (Pa).
        modulus: f64,
        /// Hardness of solids that have it, `[low, high]` (Pa).
        hardness: [f64; 2],
        /// E* times the rms gradient (Pa): the elastic area holds for a hardness of at least this.
        full: Option<f64>,
    },
    /// What yields at the hardness given: part of the contact of the headline, or bodies in their volume.
    Yielding {
        /// H (Pa).
        hardness: f64,
        /// The headline, if part of its contact has yielded.
        #[serde(flatten)]
        headline: Option<Yielding>,
        /// The highest load (Pa), if it is so high that the bodies yield in their volume.
        highest: Option<f64>,
    },
    /// Whether the bodies stick, with a work of adhesion that was given.
    Adhesion(Box<Adhesion>),
    /// Slopes that small-slope elasticity does not cover.
    Steep {
        /// Rms gradient \[-\].
        gradient: f64,
        /// True if small-slope elasticity has ended, false if it strains.
        is_over: bool,
    },
    /// An accuracy that was asked for and is not met.
    PlanUnmet(Box<Reached>),
    /// The answer depends on what lies between the points.
    Interpolation {
        /// Largest indicator over the loads (-).
        indicator: f64,
        /// Area fraction on twice the points at that load, if it was solved \[-\].
        finer: Option<f64>,
        /// Loads whose indicator exceeds its limit.
        loads: usize,
        /// Of how many.
        of: usize,
    },
    /// Loads so light that the contact is smaller than a point of the map.
    BelowPoint {
        /// How many.
        loads: usize,
        /// Of how many.
        of: usize,
    },
    /// An area without an uncertainty.
    NoUncertainty {
        /// Why.
        why: NoUncertainty,
        /// At how many loads.
        loads: usize,
        /// Of how many.
        of: usize,
    },
    /// What traces leave open: the other directions, while the models are of isotropic surfaces, and by their length and
    /// number the moments.
    Sample {
        /// How many traces.
        traces: usize,
        /// Length of each (m).
        length: f64,
        /// Relative 95 % factors of m0, m2, m4: a moment times or divided by it; `None` where the
        /// traces hold too few waves to tell.
        factors: [Option<f64>; 3],
        /// Relative standard deviations from trace to trace, of two or more.
        between: Option<[f64; 3]>,
    },
    /// Traces without parameters of roughness, or with a filter of them that is not the standard's.
    Roughness {
        /// Why there are none, as the statistics refuse it.
        none_because: Option<String>,
        /// Ra, the λc that was used and the length of the traces (m), where Ra asks for a longer λc than the length allows.
        short_cutoff: Option<[f64; 3]>,
        /// The λs that was left out and the spacing of the points (m), which are too far apart for it.
        no_s_filter: Option<[f64; 2]>,
    },
    /// A warning of the statistics.
    Warned(Warning),
    /// Edges that do not match.
    EdgeJump {
        /// Their jump over the inner step \[-\].
        ratio: f64,
        /// What was put beyond them.
        edges: EdgesName,
        /// What they do to the area, if there is a solution.
        seam: Option<Seam>,
    },
    /// Single points far from their neighbours.
    Spikes {
        /// How many.
        count: usize,
        /// Points of the map.
        of: usize,
        /// Largest distance of one (m).
        largest: f64,
        /// Share of the load that they carry \[-\], if it is known.
        share: Option<f64>,
        /// How many cleaning took out before.
        taken: usize,
    },
    /// What was done to the heights before: points filled, steps of cleaning, points put at equal distances.
    Cleaned {
        /// The steps.
        steps: Vec<Record>,
        /// Part of the map that was filled \[-\], removed spikes among it; 0 if nothing was.
        filled: f64,
        /// By which rule.
        how: String,
        /// How uneven the points of traces were, if they were put at equal distances.
        uneven: Option<Unevenness>,
    },
    /// Two bodies that are not independent, or lie on each other not point on point or not with all of them.
    Pair {
        /// Their names.
        names: [String; 2],
        /// Their moments, if these do not add as those of independent surfaces do.
        moments: Option<Independence>,
        /// Their pixels `[dy, dx]` (m), if they differ.
        pixels: Option<[[f64; 2]; 2]>,
        /// Part of each that lies on the other \[-\], if not all does.
        shares: Option<[f64; 2]>,
    },
    /// What was tested and is fine.
    Passed(Passed),
}

/// What presses at one load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pressed {
    /// Nominal pressure (Pa).
    pub nominal: f64,
    /// Mean pressure where the bodies touch (Pa).
    pub mean: f64,
    /// Highest pressure (Pa), if it is known.
    pub highest: Option<f64>,
}

impl Pressed {
    /// A mean above the highest pressure of a point is that of contacts smaller than the points: none of them
    /// resolves the highest pressure, which is then not known.
    pub fn of(nominal: f64, mean: f64, highest: f64) -> Self {
        Self { nominal, mean, highest: (highest >= mean).then_some(highest) }
    }
}

/// What has yielded at the headline.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Yielding {
    /// `E* g / H` \[-\], if g is known: up to 1 the elastic area is right to 2 %.
    pub over_elastic: Option<f64>,
    /// Nominal pressure of the headline (Pa).
    pub load: f64,
    /// Part of the points in contact at H \[-\].
    pub share: f64,
    /// Part of the load that they carry \[-\].
    pub load_share: f64,
    /// Corrected area fraction \[-\].
    pub area: f64,
    /// The same of elastic bodies \[-\], if there is a solution.
    pub elastic_area: Option<f64>,
}

/// What the strip along the edges does to the area at the headline.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Seam {
    /// What the strip holds.
    pub share: EdgeShare,
    /// Its sides `[y, x]` (m).
    pub strip: [f64; 2],
}

/// What was tested and is fine; what was not, or is not, is absent.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Passed {
    /// Nayak's parameter, at least 1.5 \[-\].
    pub bandwidth: Option<f64>,
    /// Skewness and kurtosis near those of a normal distribution \[-\].
    pub heights: Option<[f64; 2]>,
    /// Larger over smaller mean square slope, at most 2 \[-\].
    pub anisotropy: Option<f64>,
    /// Part of the rms gradient that finite differences see \[-\].
    pub resolved: Option<f64>,
    /// Moments of two bodies that add.
    pub independence: Option<Independence>,
}

/// Whether a theory covers a surface. This judges the domain, not the error.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Verdict {
    /// Yes, caution or no.
    pub answer: Applies,
    /// Why not simply yes, with the measured numbers.
    pub reasons: Vec<Reason>,
    /// True if the surface itself is the reason, and not the height of some loads.
    pub at_every_load: bool,
}

/// Why a theory covers a surface only with caution, or not at all.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// What the surface is like: steep, with a lay, not Gaussian, or with rows that jump.
    Surface(Fact),
    /// The theory has no meaning for this surface, or something it is made of is absent.
    Refused {
        /// Why.
        error: BuildError,
        /// What a fractal fit gave, if that is what is missing \[-\].
        dimension: Option<f64>,
    },
    /// The input depends on the band that was measured: a dimension on the range that it was fitted over, B_max on how long the
    /// rows of the map are.
    Band {
        /// Dimension of the fit \[-\]; `None` of B_max.
        dimension: Option<f64>,
        /// Shortest wavelength of the fit, or that of B_max (m); `None` if no wave stands out.
        short: Option<f64>,
        /// Longest wavelength of the fit, or length of the rows (m).
        long: f64,
    },
    /// An assumption is strained, or contact is full.
    Strained {
        /// What the model says itself; `None` where summits no longer act alone.
        caveat: Option<Caveat>,
        /// The first mean pressure at which it is (Pa); of summits that at which the area exceeds 5 %.
        from: f64,
    },
    /// The bodies yield, and the theory is of elastic ones.
    Elastic {
        /// The first mean pressure at which its area is more than 2 % too small (Pa).
        from: f64,
        /// By how much at most, relative to the elastic area \[-\].
        most: f64,
        /// True if it is more than 2 % at every load that has both.
        everywhere: bool,
    },
    /// Some loads have no answer.
    NoAnswer {
        /// How many.
        loads: usize,
        /// Of how many.
        of: usize,
    },
}

impl Reason {
    /// True if it depends on the load, and not on the surface alone.
    pub(crate) fn is_by_load(&self) -> bool {
        match self {
            Self::Strained { .. } | Self::NoAnswer { .. } => true,
            Self::Elastic { everywhere, .. } => !everywhere,
            _ => false,
        }
    }
}

/// The answer of a [`Verdict`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Applies {
    /// Within the assumptions.
    Yes,
    /// It answers, but an assumption is strained.
    Caution,
    /// No meaning here.
    No,
}

impl Named for Applies {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Yes, "yes"), (Self::Caution, "caution"), (Self::No, "no")];
}
