//! What may change a conclusion, or was tested and is fine: as numbers. `report` has the words.

use crate::EdgesName;
use crate::adhesion::Adhesion;
use crate::profile::fact::ProfileFact;
use contact_accuracy::{EdgeShare, NoUncertainty, Reached};
use contact_types::Named;
use serde::Serialize;
use surface_stats::Warning;
use surface_stats::clean::Record;
use surface_stats::pair::Independence;

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

/// What a finding is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Topic {
    /// What the solids bear.
    Material,
    /// The heights.
    Surface,
    /// The point spacing, against what it has to resolve.
    Grid,
    /// The deterministic solution.
    Solution,
    /// What lies beyond the edges of the map.
    Edges,
    /// The choice made for an accuracy asked for.
    Plan,
}

impl Named for Topic {
    const NAMES: &'static [(Self, &'static str)] = &[
        (Self::Material, "material"),
        (Self::Surface, "surface"),
        (Self::Grid, "grid"),
        (Self::Solution, "solution"),
        (Self::Edges, "edges"),
        (Self::Plan, "plan"),
    ];
}

/// How the solution of a load ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// At its tolerance.
    Converged,
    /// Where rounding kept it from its tolerance.
    AtRounding,
    /// Before that, or not at all.
    Short,
    /// Not begun: no contact bears the load, which is said of itself.
    Refused,
}

/// One finding.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Finding {
    /// How much it matters.
    pub weight: Weight,
    /// What was found.
    pub fact: Fact,
}

impl Finding {
    /// A fact that is good to know.
    pub fn note(fact: Fact) -> Self {
        Self { weight: Weight::Note, fact }
    }

    /// What the statistics warn of.
    pub(crate) fn warned(warning: Warning) -> Self {
        let weight = match warning {
            Warning::Rounding { .. }
            | Warning::Flat
            | Warning::Tilted { .. }
            | Warning::RowsJump { .. }
            | Warning::Anisotropic { .. }
            | Warning::NotGaussian { .. }
            | Warning::NarrowBand { .. }
            | Warning::Unresolved { .. }
            | Warning::Stepped { .. }
            | Warning::Noisy { .. } => Weight::Check,
            _ => Weight::Note,
        };
        Self { weight, fact: Fact::Warned(warning) }
    }

    /// What it is about.
    pub fn subject(&self) -> Topic {
        match &self.fact {
            Fact::Yield(_)
            | Fact::Yielding(_)
            | Fact::OddHardness { .. }
            | Fact::BulkYield { .. }
            | Fact::Adhesion(_) => Topic::Material,
            Fact::NotConverged { .. } | Fact::AtRounding { .. } => Topic::Solution,
            Fact::PlanUnmet(_) => Topic::Plan,
            Fact::Interpolation { .. } | Fact::NoUncertainty { .. } | Fact::BelowPoint { .. } => {
                Topic::Grid
            }
            Fact::EdgeJump { .. } => Topic::Edges,
            Fact::Unit { .. }
            | Fact::Spikes { .. }
            | Fact::Steep(_)
            | Fact::Profile(_)
            | Fact::Warned(_)
            | Fact::Filled { .. }
            | Fact::Cleaned(_)
            | Fact::Pair { .. }
            | Fact::PixelsDiffer { .. }
            | Fact::CommonPart { .. }
            | Fact::OfBody { .. }
            | Fact::Passed(_) => Topic::Surface,
        }
    }
}

/// What was found, with its numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fact {
    /// Sizes that no rough surface has; each `None` where it is usual.
    Unit {
        /// Rms gradient \[-\].
        gradient: Option<f64>,
        /// Rms height (m).
        rms_height: Option<f64>,
        /// Radius of asperities (m).
        radius: Option<f64>,
    },
    /// The elastic answer presses harder than solids of this modulus usually bear.
    Yield(Yield),
    /// Part of the contact has yielded at the hardness given.
    Yielding(Yielding),
    /// A hardness that solids of this modulus do not have.
    OddHardness {
        /// H (Pa).
        hardness: f64,
        /// That of solids, `[low, high]` (Pa).
        usual: [f64; 2],
    },
    /// Loads so high that the bodies yield in their volume.
    BulkYield {
        /// The highest (Pa).
        highest: f64,
        /// H (Pa).
        hardness: f64,
    },
    /// Whether the bodies stick, with a work of adhesion that was given.
    Adhesion(Box<Adhesion>),
    /// Slopes that small-slope elasticity does not cover.
    Steep(Steep),
    /// Loads without a converged solution.
    NotConverged {
        /// How many.
        loads: usize,
        /// Of how many.
        of: usize,
    },
    /// Loads whose solution rounding kept from its tolerance.
    AtRounding {
        /// How many.
        loads: usize,
        /// Of how many.
        of: usize,
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
    /// Of profiles: what one direction and a finite length leave open.
    Profile(ProfileFact),
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
    /// Points that were filled.
    Filled {
        /// Their part of the map \[-\].
        share: f64,
        /// True if some of them were spikes.
        spikes: bool,
        /// By which rule.
        how: String,
    },
    /// Steps of cleaning.
    Cleaned(Vec<Record>),
    /// Two bodies whose moments do not add, as those of independent surfaces do.
    Pair {
        /// Their names.
        names: [String; 2],
        /// The moments.
        moments: Independence,
    },
    /// Two bodies measured at different distances of the points.
    PixelsDiffer {
        /// Their names.
        names: [String; 2],
        /// Their pixels `[dy, dx]` (m).
        pixels: [[f64; 2]; 2],
    },
    /// Two bodies of which only parts lie on each other.
    CommonPart {
        /// Their names.
        names: [String; 2],
        /// Part of each that lies on the other \[-\].
        shares: [f64; 2],
    },
    /// What was found on one body of a pair.
    OfBody {
        /// Its name.
        body: String,
        /// What was found.
        fact: Box<Fact>,
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

/// Pressure beside the hardness that the modulus suggests.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Yield {
    /// The lightest load at which it is too high.
    pub at: Pressed,
    /// Contact modulus (Pa).
    pub modulus: f64,
    /// Hardness of solids that have it, `[low, high]` (Pa).
    pub hardness: [f64; 2],
    /// E* times the rms gradient (Pa): the elastic area holds for a hardness of at least this.
    pub full: Option<f64>,
}

/// What has yielded at the headline.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Yielding {
    /// H (Pa).
    pub hardness: f64,
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

/// Steep slopes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Steep {
    /// Rms gradient \[-\].
    pub gradient: f64,
    /// True if small-slope elasticity has ended, false if it strains.
    pub is_over: bool,
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

impl Seam {
    /// Size of the relative error of the area to expect.
    pub(crate) fn worst(&self) -> f64 {
        self.share.direct_effect().abs()
    }
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
