//! What a study says while it works, and why there may be none.

use crate::pressure_maps::PressureMaps;
use contact_accuracy::BadRequest;
use contact_types::{ModelError, SurfaceError};
use fft_bem_solver::{Iteration, SolverError};
use std::ops::ControlFlow;
use surface_stats::StatsError;

/// Who is told what a study does, and may stop it.
pub type Listener<'a> = dyn FnMut(Progress<'_>) -> ControlFlow<()> + Send + 'a;

/// What a study reports while it works.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Progress<'a> {
    /// A surface begins: its place among `count`, and how many loads it will be asked at.
    Surface {
        /// Name.
        name: &'a str,
        /// From 0.
        index: usize,
        /// Surfaces in all.
        count: usize,
        /// Loads.
        loads: usize,
    },
    /// An iteration of the solver is done; breaking off here ends the study within this load.
    Iterated {
        /// Index of the load, from 0, by rising pressure.
        index: usize,
        /// What the solver says of it.
        now: Iteration<'a>,
    },
    /// A load is solved.
    Solved {
        /// From 0, by rising pressure.
        index: usize,
        /// Nominal pressure (Pa).
        mean_pressure: f64,
        /// Area fraction, if there is an answer.
        area_fraction: Option<f64>,
        /// Pressures of the loads so far, this one last, if all have an answer.
        maps: Option<&'a PressureMaps>,
    },
    /// The models are being asked.
    Models,
}

/// A listener that is told of the iterations at one load, and whether it has asked to stop.
pub(crate) struct LoadListener<'a, 'b> {
    pub(crate) listener: &'a mut Listener<'b>,
    /// Of the load, by rising pressure.
    pub(crate) index: usize,
    pub(crate) is_stopped: bool,
}

impl LoadListener<'_, '_> {
    /// Tells of an iteration; what was stopped stays stopped.
    pub(crate) fn iteration(&mut self, now: &Iteration<'_>) -> ControlFlow<()> {
        let wish = (self.listener)(Progress::Iterated { index: self.index, now: *now });
        self.is_stopped |= wish.is_break();
        if self.is_stopped { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// Why there is no study, no surface for it, or no place for a theory in it.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the messages say what the fields are")]
pub enum StudyError {
    /// No surface was given.
    #[error("no surface is given; a study needs at least one ([[surface]] in a run file)")]
    NoSurface,
    /// A run file that is not TOML, or a key of which is missing, unknown or of the wrong type.
    #[error("this is no run file of this program: {0}")]
    Syntax(#[from] toml::de::Error),
    /// A surface of a run file that was handed over by a program.
    #[error(
        "the surface '{0}' was handed over by a program, not read from a file: its heights are \
         not in the run file, so only that program can repeat the run"
    )]
    Given(String),
    /// A filter of the cleaning whose cut-off the points cannot show.
    #[error(
        "a filter with a cut-off of {cutoff:e} m sees nothing between points {pixel:e} m apart; \
         give at least two points, {:e} m, or leave it out", 2.0 * pixel
    )]
    CutoffTooShort { cutoff: f64, pixel: f64 },
    /// Filters of the cleaning that leave nothing between them.
    #[error(
        "an S-filter at {s_filter:e} m and an L-filter at {l_filter:e} m leave no wave; the \
         S-filter takes short waves off, so give it the shorter cut-off"
    )]
    NothingLeft { s_filter: f64, l_filter: f64 },
    /// The modulus is no modulus.
    #[error(transparent)]
    Material(#[from] SurfaceError),
    /// A pressure that is no load.
    #[error("nominal pressure {0:e} Pa cannot be applied: it must be finite and greater than 0")]
    BadPressure(f64),
    /// The headline is not among the loads.
    #[error(
        "the headline pressure {0:e} Pa is not among the pressures of the study; add it to them"
    )]
    HeadlineNotComputed(f64),
    /// A name that is no model of the study.
    #[error("the study has no model '{name}'; it has {known}")]
    UnknownModel { name: String, known: String },
    /// The list of models is empty; these there are.
    #[error("the list of models is empty; name at least one of {0}")]
    NoModel(String),
    /// Both or neither of the two ways to scale a recipe are given.
    #[error(
        "recipe {name:?}: give exactly one of rms_height (m) and rms_gradient, found {found} of them"
    )]
    Scale { name: String, found: usize },
    /// A value of a recipe is out of its range.
    #[error("recipe {name:?}: {source}")]
    Impossible { name: String, source: StatsError },
    /// Statistics refuse the surface, or the two of a pair.
    #[error("{surface}: {source}")]
    Statistics { surface: String, source: StatsError },
    /// The solver refuses the settings.
    #[error("{surface}: {source}")]
    Solver { surface: String, source: Box<SolverError> },
    /// The accuracy asked for is none.
    #[error(transparent)]
    Accuracy(#[from] BadRequest),
    /// A hardness that no pressure is held to.
    #[error(
        "hardness {0:e} Pa: a hardness is a finite pressure above 0; leave it out for elastic bodies"
    )]
    BadHardness(f64),
    /// A weight of partial contact that Persson's theory has not.
    #[error(
        "gamma {0}: the weight of partial contact in Persson's mean gap is from 0.01 to 1; published are 1, 0.45 and 0.42"
    )]
    BadGamma(f64),
    /// A resistivity, a conductivity or a gas that is none.
    #[error(transparent)]
    Conduction(#[from] ModelError),
    /// A conductance of profiles.
    #[error(
        "what a contact conducts is found on maps: of profiles no contact is solved; leave resistivities and \
         conductivities out"
    )]
    NoConductance,
    /// A hardness with profiles, whose contact is not solved.
    #[error(
        "a hardness is for maps: of profiles no contact is solved, in which anything could yield; leave it out, of table materials by `elastic`"
    )]
    YieldingProfiles,
    /// A work of adhesion with profiles.
    #[error(
        "whether bodies stick is said of maps, whose slopes and curvatures are known in all directions; of a profile \
         leave the work of adhesion out"
    )]
    NoAdhesion,
    /// Another theory has its name.
    #[error("there is a model '{0}' already; give the new one another name")]
    NameTaken(String),
    /// Another theory has its label, so that figures could not tell them apart.
    #[error("the model '{other}' has the label '{label}' already; give the new one another label")]
    LabelTaken { label: String, other: String },
    /// The name cannot be typed as an option or be a column of a table.
    #[error(
        "'{0}' cannot be the name of a model: use lower-case letters, digits and hyphens, for \
         example 'my-model'"
    )]
    BadName(String),
    /// A curve without points.
    #[error("a curve needs at least one point")]
    EmptyCurve,
    /// A point that no curve has.
    #[error("point {index} of the curve: {quantity} {value:e} {requirement}")]
    BadPoint { index: usize, quantity: &'static str, value: f64, requirement: &'static str },
    /// The observer asked to stop.
    #[error("stopped")]
    Stopped,
}
