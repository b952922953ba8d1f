//! `--leak`: what flows through the gap.

use crate::args;
use crate::outcome::Failure;
use crate::text::{self, Columns};
use crate::units::Dimension::{Length, Pressure, Viscosity};
use clap::Args;
use rough_contact::compare::LeakRequest;
use rough_contact::contact_accuracy::Leaks;
use rough_contact::contact_types::Named;
use rough_contact::{front_end, report};
use std::fmt::Write as _;

#[derive(Args, Clone, Debug, Default)]
pub(crate) struct LeakOptions {
    /// Permeability of the gap for a flow along x, y or both, whether a channel is open, and its narrowest place
    #[arg(long, value_name = "AXIS", value_parser = ["x", "y", "both"])]
    leak: Option<String>,
    /// Viscosity of the fluid, as 1mPa.s; with the next three the leak rate
    #[arg(long, value_name = "ETA", value_parser = args::one(Viscosity), allow_hyphen_values = true)]
    viscosity: Option<f64>,
    /// Pressure of the fluid on one side less that on the other
    #[arg(long, value_name = "P", value_parser = args::one(Pressure), allow_hyphen_values = true)]
    pressure_drop: Option<f64>,
    /// Length of the way through the seal
    #[arg(long, value_name = "L", value_parser = args::one(Length), allow_hyphen_values = true)]
    seal_length: Option<f64>,
    /// Width of the seal across the flow
    #[arg(long, value_name = "L", value_parser = args::one(Length), allow_hyphen_values = true)]
    seal_width: Option<f64>,
}

impl LeakOptions {
    pub(crate) fn asked(&self) -> Result<Option<LeakRequest>, Failure> {
        let Self { leak, viscosity, pressure_drop, seal_length, seal_width } = self;
        front_end::leak_request(
            leak.as_deref(),
            [*viscosity, *pressure_drop, *seal_length, *seal_width],
        )
    }
}

fn cubic(metres: f64) -> String {
    if metres.abs() > 0.0 { format!("{metres:.3e} m³") } else { "0".to_owned() }
}

/// A table with a row for each load and axis, and what must be known of it.
pub(crate) fn lines<'a>(
    asked: Option<&LeakRequest>,
    points: impl Iterator<Item = (f64, &'a Leaks)>,
    modulus: f64,
    yields: bool,
) -> String {
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
    let mut all = Vec::new();
    for (pressure, leaks) in points {
        all.push(leaks);
        seconds.iter_mut().zip(leaks.seconds).for_each(|(sum, s)| *sum += s);
        for (axis, found) in &leaks.along {
            let load = text::pressure(pressure);
            let Ok(leak) = found else {
                columns.row([load, axis.name().to_owned(), "not solved".to_owned()]);
                continue;
            };
            let (k, ends) = (leak.permeability(), leak.interval());
            let shown = |of: &dyn Fn(f64) -> String| match (k, ends) {
                (Some(k), _) if k > 0.0 => of(k),
                (Some(_), _) => "0".to_owned(),
                (None, Some([_, most])) => format!("at most {}", of(most)),
                (None, None) => "–".to_owned(),
            };
            let factor = k.filter(|k| *k > 0.0).map(|k| k / leaks.mean_gap.powi(3));
            let mut cells = vec![
                load,
                axis.name().to_owned(),
                shown(&cubic),
                text::or_dash(k, |k| text::relative(k, ends, cubic)),
                text::or_dash(factor, text::number),
            ];
            cells.extend(asked.seal.map(|seal| shown(&|k| format!("{:.3e} m³/s", seal.rate(k)))));
            cells.push(leak.channel().to_owned());
            let bottleneck = leak.flow.bottleneck;
            cells.push(text::or_dash(bottleneck, |b| text::length(b.height)));
            cells.push(text::or_dash(bottleneck, |b| b.width.to_string()));
            for (_, closed, _) in leaks.closed_forms() {
                cells.push(cubic(closed));
                cells.push(text::or_dash(leak.error_of(closed), text::percent));
            }
            columns.row(cells);
        }
    }
    let mut out = columns.to_string();
    let [flow, mean, bruggeman] = seconds.map(text::seconds);
    let _ = writeln!(
        out,
        "leak: Reynolds' equation on the gap, Q = K W Δp/(12 η L), {flow}; of the same gap ⟨g⟩³ in {mean}, Bruggeman in \
         {bruggeman}"
    );
    for note in report::leak_notes(&all, modulus, yields) {
        let _ = writeln!(out, "{note}");
    }
    out
}
