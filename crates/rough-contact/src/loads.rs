//! Loads as they were asked for: forces made pressures, and which are refused.

use crate::args::{self, List};
use crate::outcome::Failure;
use crate::text;
use crate::units::Dimension::{Area, Force, Length, Pressure};
use clap::{ArgGroup, Args};
use rough_contact::fft_bem_solver::Load;
pub(crate) use rough_contact::front_end::loads::{Spread, positive, rising, shown};

#[derive(Args, Clone, Debug)]
pub(crate) struct Forces {
    /// Loads as forces on the whole nominal area, such as 10N, instead of --pressure
    #[arg(long, value_name = "LIST", value_parser = args::list(Force), allow_hyphen_values = true)]
    #[arg(conflicts_with = "pressure")]
    pub(crate) load: Option<List>,
    /// Nominal area that --load presses on and whose resistance is asked for, such as 2mm2 [default: that of the map]
    #[arg(long, value_name = "A", value_parser = args::one(Area), allow_hyphen_values = true)]
    pub(crate) area: Option<f64>,
}

/// Loads to solve for, as one of three kinds.
#[derive(Args, Clone, Debug)]
#[command(group(ArgGroup::new("loads").required(true).args(["pressure", "load", "gap"])))]
pub(crate) struct Loads {
    /// Mean pressures to solve for
    #[arg(long, value_name = "LIST", value_parser = args::list(Pressure), allow_hyphen_values = true)]
    pressure: Option<List>,
    #[command(flatten)]
    pub(crate) forces: Forces,
    /// Mean gaps to solve for, instead of --pressure
    #[arg(long, value_name = "LIST", value_parser = args::list(Length), allow_hyphen_values = true)]
    pub(crate) gap: Option<List>,
}

impl Loads {
    /// How many loads there are; zero and negative ones are refused before any work.
    pub(crate) fn count(&self) -> Result<usize, Failure> {
        let all = |list: &Option<List>| list.clone().map_or_else(Vec::new, |List(all)| all);
        let (pressures, gaps) = (all(&self.pressure), all(&self.gap));
        positive("mean pressure", &pressures, "Pa", "at which something touches")?;
        positive("mean gap", &gaps, "m", "or use --pressure for a closed gap")?;
        Ok(self.forces.given()?.map_or(pressures.len() + gaps.len(), <[f64]>::len))
    }

    pub(crate) fn each(&self, spread: Option<&Spread>) -> Vec<Load> {
        let gaps = self.gap.iter().flat_map(|List(gaps)| gaps.iter().map(|&g| Load::MeanGap(g)));
        let given = self.pressure.as_ref().map(|List(pressures)| pressures);
        let pressures = spread.map(|s| &s.pressures).or(given);
        let pressures = pressures.into_iter().flatten().map(|&p| Load::MeanPressure(p));
        pressures.chain(gaps).collect()
    }
}

impl Forces {
    /// The forces given (N), refused unless each presses.
    pub(crate) fn given(&self) -> Result<Option<&[f64]>, Failure> {
        let Some(List(forces)) = &self.load else { return Ok(None) };
        positive("load", forces, "N", "at which something touches")?;
        positive("nominal area", self.area.as_slice(), "m^2", "that carries the load")?;
        Ok(Some(forces))
    }

    /// Over the area given, or the one area that all maps have.
    pub(crate) fn spread(
        &self,
        maps: impl IntoIterator<Item = f64>,
    ) -> Result<Option<Spread>, Failure> {
        self.given()?.map(|forces| spread(forces, self.area, maps)).transpose()
    }
}

/// Forces over the area given, or the one area that all maps have.
pub(crate) fn spread(
    forces: &[f64],
    given: Option<f64>,
    maps: impl IntoIterator<Item = f64>,
) -> Result<Spread, Failure> {
    let mut maps = maps.into_iter();
    let refused = |message: String| Err(Failure::refused("usage", message));
    let area = match (given, maps.next()) {
        (Some(area), _) => area,
        (None, None) => {
            let message = "--load presses on an area, and no map says how large it is; give --area, such as \
                           --area 2mm2, or --pressure";
            return refused(message.to_owned());
        }
        (None, Some(area)) => match maps.find(|other| (other / area - 1.0).abs() > 1e-9) {
            // Areas that differ by rounding are one.
            None => area,
            Some(other) => {
                let [area, other] = [area, other].map(text::area);
                return refused(format!(
                    "the maps have areas of {area} and {other}, so that --load is another pressure on each; give \
                     --area, the nominal area that carries the load, or --pressure"
                ));
            }
        },
    };
    Spread::of(forces, given, area, "check the units of --load and --area")
}

/// What carries the load.
pub(crate) fn carried(spread: &Spread) -> String {
    let of = if spread.is_of_map { "the area of the map" } else { "as --area says" };
    format!("load: over {}, {of}\n", text::area(spread.area))
}
