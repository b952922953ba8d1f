//! `curves.csv` of profiles: one row per surface and load.

use contact_compare::ProfileComparison;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Writes one row per surface and load. SI units; a missing number is an empty cell. Columns of a
/// model are its area fraction with the ends of its interval, and its real pressure.
///
/// # Errors
/// Whatever the writer reports.
pub fn write(studies: &[ProfileComparison], out: &mut impl Write) -> io::Result<()> {
    let mut header = String::from("surface,mean_pressure [Pa]");
    for model in studies.first().iter().flat_map(|s| &s.models) {
        let name = model.card.name.replace('-', "_");
        // A String takes everything.
        let _ = write!(
            header,
            ",area_fraction_{name} [-],area_fraction_low_{name} [-],area_fraction_high_{name} [-],\
             real_pressure_{name} [Pa]"
        );
    }
    writeln!(out, "{header}")?;
    for study in studies {
        let name = crate::csv::quoted(&study.name);
        for (i, p) in study.pressures.iter().enumerate() {
            let mut row = format!("{name},{p:e}");
            for model in &study.models {
                let state = model.outcome.as_ref().ok().and_then(|c| c.points[i].as_ref().ok());
                let interval = model.intervals[i];
                for value in [
                    state.map(|s| s.area_fraction),
                    interval.map(|b| b[0]),
                    interval.map(|b| b[1]),
                    state.and_then(contact_types::ContactState::real_pressure),
                ] {
                    let cell = value.map_or(String::new(), |v| format!("{v:e}"));
                    let _ = write!(row, ",{cell}");
                }
            }
            writeln!(out, "{row}")?;
        }
    }
    Ok(())
}
