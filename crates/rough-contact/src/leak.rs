//! `--leak`: what flows through the gap.

use crate::args;
use crate::outcome::Failure;
use crate::quantity::{self, QuantityError};
use crate::text::{self, Columns};
use crate::units::Dimension;
use answers::leak::{channel, error, permeability};
use answers::{Answer, Leak};
use clap::Args;
use compare::typical_hardness;
use std::fmt::Write as _;

#[derive(Args, Clone, Debug, Default)]
pub(crate) struct LeakOptions {
    /// Permeability of the gap for a flow along x, y or both, whether a channel is open, and its narrowest place
    #[arg(long, value_name = "AXIS", value_parser = ["x", "y", "both"])]
    leak: Option<String>,
    /// Viscosity of the fluid, as 1mPa.s; with the next three the leak rate
    #[arg(long, value_name = "ETA", value_parser = viscosity, allow_hyphen_values = true)]
    viscosity: Option<f64>,
    /// Pressure of the fluid on one side less that on the other
    #[arg(long, value_name = "P", value_parser = args::pressure, allow_hyphen_values = true)]
    pressure_drop: Option<f64>,
    /// Length of the way through the seal
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    seal_length: Option<f64>,
    /// Width of the seal across the flow
    #[arg(long, value_name = "L", value_parser = args::length, allow_hyphen_values = true)]
    seal_width: Option<f64>,
}

fn viscosity(text: &str) -> Result<f64, QuantityError> {
    quantity::parse(text, Dimension::Viscosity)
}

impl LeakOptions {
    /// What is asked of the gap.
    pub(crate) fn asked(&self) -> Result<Option<Leak>, Failure> {
        let Self { leak, viscosity, pressure_drop, seal_length, seal_width } = self;
        Leak::asked(leak.as_deref(), [*viscosity, *pressure_drop, *seal_length, *seal_width])
    }
}

/// A permeability.
fn cubic(metres: f64) -> String {
    format!("{metres:.3e} m³")
}

/// The table below that of the loads, and what must be known of it.
pub(crate) fn lines(asked: Option<&Leak>, answer: &Answer, modulus: f64) -> String {
    let Some(asked) = asked else { return String::new() };
    let mut headings = vec!["mean pressure", "leak along", "permeability K", "±", "K/⟨g⟩³"];
    headings.extend(asked.seal.map(|_| "leak rate"));
    headings.extend([
        "channel",
        "lowest gap",
        "points across",
        "⟨g⟩³",
        "error",
        "Bruggeman",
        "error",
    ]);
    let mut columns = Columns::new(&headings);
    let mut seconds = [0.0; 3];
    for point in &answer.points {
        let (Some(leaks), Some(solution)) = (&point.leak, &point.solution) else { continue };
        seconds.iter_mut().zip(leaks.seconds).for_each(|(sum, s)| *sum += s);
        let plates = leaks.mean_gap.powi(3);
        for (axis, found) in &leaks.along {
            let load = text::pressure(solution.state.mean_pressure);
            let Ok(leak) = found else {
                columns.row([load, axis.name().to_owned(), "not solved".to_owned()]);
                continue;
            };
            let (k, ends) = (permeability(leak), leak.interval());
            let shown = |of: &dyn Fn(f64) -> String| match (k, ends) {
                (Some(k), _) if k > 0.0 => of(k),
                (Some(_), _) => "0".to_owned(),
                (None, Some([_, most])) => format!("at most {}", of(most)),
                (None, None) => "–".to_owned(),
            };
            let mut cells = vec![
                load,
                axis.name().to_owned(),
                shown(&cubic),
                k.map_or_else(|| "–".to_owned(), |k| text::relative(k, ends, cubic)),
                k.filter(|k| *k > 0.0).map_or_else(|| "–".to_owned(), |k| text::number(k / plates)),
            ];
            cells.extend(asked.seal.map(|seal| shown(&|k| format!("{:.3e} m³/s", seal.rate(k)))));
            cells.push(channel(leak).to_owned());
            let bottleneck = leak.flow.bottleneck;
            cells.push(bottleneck.map_or_else(|| "–".to_owned(), |b| text::length(b.height)));
            cells.push(bottleneck.map_or_else(|| "–".to_owned(), |b| b.width.to_string()));
            for closed in [plates, leaks.bruggeman] {
                cells.push(cubic(closed));
                cells.push(error(closed, found).map_or_else(|| "–".to_owned(), text::percent));
            }
            columns.row(cells);
        }
    }
    let mut out = columns.to_string();
    let [flow, mean, bruggeman] = seconds.map(text::seconds);
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "leak: Reynolds' equation on the gap, Q = K W Δp/(12 η L), {flow}; of the same gap ⟨g⟩³ in {mean}, Bruggeman in \
         {bruggeman}"
    );
    let channels = |name: &str| {
        let points = answer.points.iter().filter_map(|p| p.leak.as_ref());
        points
            .flat_map(|l| &l.along)
            .filter_map(|(_, l)| l.as_ref().ok())
            .any(|l| channel(l) == name)
    };
    if channels("sealed") {
        out += "sealed: sealed at this resolution; a channel finer than a point is not seen\n";
    }
    if channels("narrow") {
        out += "narrow: fewer than 4 points across the bottleneck: no rate, a bound; \
                measure on a finer grid\n";
    }
    if answer.hardness.is_none() && typical_hardness(modulus).is_some() {
        out += "leak of an elastic gap: metals are flattened where they touch, and without --hardness their leak is \
                meaningless\n";
    }
    out
}
