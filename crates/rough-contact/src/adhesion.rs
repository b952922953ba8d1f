//! `--work-of-adhesion`: whether the bodies stick.

use crate::args;
use crate::outcome::Failure;
use crate::units::Dimension::{self, Length};
use clap::Args;
use rough_contact::compare::WorkOfAdhesion;

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
        if work < 0.0 {
            let message = format!(
                "--work-of-adhesion {work} J/m^2: it is the work to part the surfaces, 0 or more, for example 50mJ/m^2"
            );
            return Err(Failure::refused("adhesion", message));
        }
        if range <= 0.0 {
            let message = format!(
                "--attraction-range {range} m: it is a distance above 0 m, some tenths of a nanometre, for example 0.3nm"
            );
            return Err(Failure::refused("adhesion", message));
        }
        Ok(Some(WorkOfAdhesion { work, range }))
    }
}
