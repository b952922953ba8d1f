//! What `solve` and `compare` are both asked: the bodies, their joint, and how the contact is solved.

use crate::args::{self, one, one_of};
use crate::bodies::BodyOptions;
use crate::conduction::ConductionOptions;
use crate::leak::LeakOptions;
use crate::loads::Forces;
use crate::outcome::Failure;
use crate::units::Dimension::{self, Length, Number};
use clap::Args;
use rough_contact::compare::{
    AccuracyRequest, EdgesName, Level, Method, Precision, Settings, WorkOfAdhesion,
};
use rough_contact::front_end::bodies::Bodies;

#[derive(Args, Clone, Debug)]
pub(crate) struct ContactOptions {
    #[command(flatten)]
    pub(crate) bodies: BodyOptions,
    /// Form to remove by least squares first
    #[arg(long, value_name = "FORM", value_parser = one_of::<Level>(), default_value = args::LEVEL)]
    pub(crate) level: Level,
    /// Highest pressure that the softer body bears, as 2GPa: metals yield there, and the area grows; a study has the
    /// elastic contact beside; `elastic` to leave out that of --material
    #[arg(long, value_name = "H", value_parser = args::hardness, allow_hyphen_values = true)]
    pub(crate) hardness: Option<f64>,
    #[command(flatten)]
    conduction: ConductionOptions,
    #[command(flatten)]
    leak: LeakOptions,
    #[command(flatten)]
    adhesion: AdhesionOptions,
    /// Beyond the edges of a map: the map again, or its mirror images (four times the points, memory and time), which
    /// take the jump out of a map that does not repeat
    #[arg(long, value_name = "EDGES", value_parser = one_of::<EdgesName>(), default_value = "periodic")]
    pub(crate) edges: EdgesName,
    /// Method of the solver
    #[arg(long, value_parser = one_of::<Method>(), default_value = "auto")]
    method: Method,
    /// Floating-point type of the iteration; results are always f64
    #[arg(long, value_parser = one_of::<Precision>(), default_value = "f64")]
    precision: Precision,
    /// Relative rms error of the pressure to reach
    #[arg(long, value_name = "T", value_parser = one(Number), allow_hyphen_values = true)]
    #[arg(default_value = "1e-4")]
    tolerance: f64,
    /// Uncertainty of the area to stay within, as 2%: grid, precision and tolerance are chosen for it
    #[arg(long, value_name = "A%", value_parser = AccuracyRequest::parse, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["tolerance", "precision"])]
    accuracy: Option<AccuracyRequest>,
    /// Every second point of the map at once, with its wider uncertainty
    #[arg(long, conflicts_with = "accuracy")]
    fast: bool,
}

impl ContactOptions {
    /// Settings of a study of these bodies, under loads that may be these forces.
    pub(crate) fn settings(
        &self,
        mut made_of: Bodies,
        forces: &Forces,
    ) -> Result<Settings, Failure> {
        let joint = self.conduction.of_part(&mut made_of, forces)?;
        Ok(Settings {
            modulus: made_of.modulus.pascals(),
            hardness: made_of.hardness,
            materials: made_of.materials,
            bodies: made_of.bodies,
            resistivities: joint.resistivities,
            conductivities: joint.conductivities,
            gas: joint.gas,
            load_area: joint.area,
            adhesion: self.adhesion.asked()?,
            leak: self.leak.asked()?,
            level: self.level,
            edges: self.edges,
            method: self.method,
            precision: self.precision,
            tolerance: self.tolerance,
            accuracy: self.accuracy.map(AccuracyRequest::relative),
            fast: self.fast,
            ..Settings::default()
        })
    }

    /// Whether the grid is chosen, and not that of the map.
    pub(crate) fn chooses_grid(&self) -> bool {
        self.accuracy.is_some() || self.fast
    }
}

#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct AdhesionOptions {
    /// Work of adhesion, as 50mJ/m^2: whether the bodies stick is said, by formulas; a contact that does is
    /// not modelled
    #[arg(long, value_name = "W", value_parser = args::one(Dimension::Adhesion), allow_hyphen_values = true)]
    work_of_adhesion: Option<f64>,
    /// Distance over which the surfaces attract [default: 0.3nm]
    #[arg(long, value_name = "L", value_parser = args::one(Length), allow_hyphen_values = true)]
    #[arg(requires = "work_of_adhesion")]
    attraction_range: Option<f64>,
}

impl AdhesionOptions {
    /// What was given; refused before any work if it is none.
    pub(crate) fn asked(self) -> Result<Option<WorkOfAdhesion>, Failure> {
        let Some(work) = self.work_of_adhesion else { return Ok(None) };
        let range = self.attraction_range.unwrap_or(WorkOfAdhesion::RANGE);
        let message = if work < 0.0 {
            format!(
                "--work-of-adhesion {work} J/m^2: it is the work to part the surfaces, 0 or more, for example 50mJ/m^2"
            )
        } else if range <= 0.0 {
            format!(
                "--attraction-range {range} m: it is a distance above 0 m, some tenths of a nanometre, for example 0.3nm"
            )
        } else {
            return Ok(Some(WorkOfAdhesion { work, range }));
        };
        Err(Failure::refused("adhesion", message))
    }
}
