//! `rough-contact validate`: the solver against exact solutions, on this machine.

use crate::args::{self, CommonOptions};
use crate::outcome::{Failure, Reply};
use crate::progress::ProgressDisplay;
use crate::text::{self, Columns};
use clap::Args;
use rough_contact::compare::Method;
use rough_contact::fft_bem_solver::validation::{self, Options, ValidationError, ValidationRow};
use serde_json::json;

#[derive(Args)]
pub(crate) struct Validate {
    /// Method to validate
    #[arg(long, value_parser = args::one_of::<Method>(), default_value = "auto")]
    method: Method,
    /// Points per side of the finest map; profiles have 16 times as many
    #[arg(long, value_name = "N", default_value_t = 256)]
    finest: usize,
}

impl Validate {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        let options = Options { method: self.method, finest: self.finest };
        let mut progress = ProgressDisplay::new(common.quiet, 0);
        let mut last = String::new();
        let rows = validation::run(&options, |row| {
            let now = format!("{}, {} × {}", row.case, row.shape[0], row.shape[1]);
            if now != last {
                progress.working_on(&now);
                last = now;
            }
        })
        .map_err(|error| match &error {
            ValidationError::TooCoarse(_) => Failure::from(&error),
            _ => Failure { status: 1, ..Failure::from(&error) },
        })?;
        drop(progress);
        Ok(Reply::new(table(&rows), json!({ "rows": rows })))
    }
}

/// The finest grid of each case and quantity, with the order observed down to it.
fn table(rows: &[ValidationRow]) -> String {
    let mut columns =
        Columns::new(&["", "grid", "computed", "exact", "error", "order", "expected"]);
    let mut last_case = "";
    for (i, row) in rows.iter().enumerate() {
        let is_finer = |other: &&ValidationRow| {
            other.case == row.case && other.quantity == row.quantity && other.shape != row.shape
        };
        if rows[i + 1..].iter().find(is_finer).is_some() {
            continue;
        }
        if row.case != last_case {
            columns.heading(&format!("{} ({})", row.case, row.source));
            last_case = row.case;
        }
        let order = |o: Option<f64>| text::or_dash(o, |o| format!("{o:.2}"));
        columns.row([
            format!("  {}", row.quantity),
            format!("{} × {}", row.shape[0], row.shape[1]),
            format!("{:.6e}", row.computed),
            format!("{:.6e}", row.exact),
            format!("{:+.1e}", row.error).replace('-', "−"),
            order(row.observed_order),
            order(row.expected_order),
        ]);
    }
    columns.to_string()
}
