//! Loads as they were asked for: forces made pressures, which are refused, in which order they are
//! solved, how they are called.

use crate::args::{self, List};
use crate::outcome::Failure;
use crate::text;
use crate::units::Dimension::{Area, Force, Length, Pressure};
use clap::Args;
use rough_contact::fft_bem_solver::Load;
pub(crate) use rough_contact::front_end::loads::{Spread, positive, rising, shown};

/// Loads as forces.
#[derive(Args, Clone, Debug)]
pub(crate) struct Forces {
    /// Loads as forces on the whole nominal area, such as 10N, instead of --pressure
    #[arg(long, value_name = "LIST", value_parser = args::list(Force), allow_hyphen_values = true)]
    #[arg(conflicts_with = "pressure")]
    load: Option<List>,
    /// Nominal area that --load presses on and whose resistance is asked for, such as 2mm2 [default: that of the map]
    #[arg(long, value_name = "A", value_parser = args::one(Area), allow_hyphen_values = true)]
    area: Option<f64>,
}

/// Loads to solve for, as one of three kinds.
#[derive(Args, Clone, Debug)]
pub(crate) struct Loads {
    /// Mean pressures to solve for
    #[arg(long, value_name = "LIST", value_parser = args::list(Pressure), allow_hyphen_values = true)]
    #[arg(required_unless_present_any = ["gap", "load"], conflicts_with = "gap")]
    pressure: Option<List>,
    #[command(flatten)]
    pub(crate) forces: Forces,
    /// Mean gaps to solve for, instead of --pressure
    #[arg(long, value_name = "LIST", value_parser = args::list(Length), allow_hyphen_values = true)]
    #[arg(conflicts_with = "load")]
    gap: Option<List>,
}

impl Loads {
    /// True if the gap is prescribed, and the load is an answer.
    pub(crate) fn is_by_gap(&self) -> bool {
        self.gap.is_some()
    }

    /// How many loads there are; zero and negative ones are refused before any work.
    pub(crate) fn count(&self) -> Result<usize, Failure> {
        if let Some(forces) = self.forces.given()? {
            return Ok(forces.len());
        }
        if let Some(List(pressures)) = &self.pressure {
            for &p in pressures {
                positive("mean pressure", p, "Pa", "at which something touches")?;
            }
            return Ok(pressures.len());
        }
        let List(gaps) = self.gap.as_ref().expect("clap requires one of the three");
        for &g in gaps {
            positive("mean gap", g, "m", "or use --pressure for a closed gap")?;
        }
        Ok(gaps.len())
    }

    /// The loads in the order given.
    pub(crate) fn each(&self, spread: Option<&Spread>) -> Vec<Load> {
        let gaps = self.gap.iter().flat_map(|List(gaps)| gaps.iter().map(|&g| Load::MeanGap(g)));
        let given = self.pressure.as_ref().map(|List(pressures)| pressures);
        let pressures = spread.map(|s| &s.pressures).or(given);
        let pressures = pressures.into_iter().flatten().map(|&p| Load::MeanPressure(p));
        pressures.chain(gaps).collect()
    }
}

impl Forces {
    /// The nominal area given (m²).
    pub(crate) fn area(&self) -> Option<f64> {
        self.area
    }

    /// Refuses an area that nothing asks for; `conducts` asks for one.
    pub(crate) fn refuse_idle_area(&self, conducts: bool) -> Result<(), Failure> {
        if self.area.is_none() || self.load.is_some() || conducts {
            return Ok(());
        }
        let message = "--area is the area that --load presses on, or the part whose resistance is asked for, and neither \
                       --load nor --resistivity or --conductivity is given; give one, or leave --area out";
        Err(Failure::refused("usage", message))
    }

    /// The forces given (N), refused unless each presses.
    pub(crate) fn given(&self) -> Result<Option<&[f64]>, Failure> {
        let Some(List(forces)) = &self.load else { return Ok(None) };
        refuse_idle(forces, self.area)?;
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

fn refuse_idle(forces: &[f64], area: Option<f64>) -> Result<(), Failure> {
    for &force in forces {
        positive("load", force, "N", "at which something touches")?;
    }
    area.map_or(Ok(()), |area| positive("nominal area", area, "m^2", "that carries the load"))
}

/// Forces over the area given, or the one area that all maps have.
pub(crate) fn spread(
    forces: &[f64],
    given: Option<f64>,
    maps: impl IntoIterator<Item = f64>,
) -> Result<Spread, Failure> {
    refuse_idle(forces, given)?;
    let mut maps = maps.into_iter();
    let refused = |message: String| Err(Failure::refused("usage", message));
    let area = match (given, maps.next()) {
        (Some(area), _) => area,
        (None, None) => {
            return refused(
                "--load presses on an area, and no map says how large it is; give --area, such as \
                 --area 2mm2, or --pressure"
                    .to_owned(),
            );
        }
        (None, Some(area)) => match maps.find(|other| (other / area - 1.0).abs() > 1e-9) {
            // Areas that differ by rounding are one.
            None => area,
            Some(other) => {
                return refused(format!(
                    "the maps have areas of {} and {}, so that --load is another pressure on each; give \
                     --area, the nominal area that carries the load, or --pressure",
                    text::area(area),
                    text::area(other)
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
