//! Cleaning of the heights of a file, asked for step by step.

use crate::args;
use crate::outcome::Failure;
use crate::quantity;
use crate::units::Dimension::{self, Length};
use clap::Args;
use rough_contact::compare::Cleaning;
use rough_contact::surface_stats::clean::Form;

/// Done in this order on the valid points, before missing points are filled.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct CleaningOptions {
    /// Put rows in line that stand at heights of their own, by the median of their differences
    #[arg(long)]
    align_rows: bool,
    /// Make spikes missing points: those more than so many robust standard deviations from their
    /// neighbours; 8 is usual
    #[arg(long, value_name = "THRESHOLD", value_parser = threshold, allow_hyphen_values = true)]
    outliers: Option<f64>,
    /// Take a form off by least squares: plane, quadratic, polynomial:N, sphere or cylinder
    #[arg(long, value_name = "FORM", value_parser = str::parse::<Form>)]
    form: Option<Form>,
    /// Take waves shorter than this off (Gaussian, ISO 16610-61)
    #[arg(long, value_name = "CUTOFF", value_parser = args::one(Length), allow_hyphen_values = true)]
    s_filter: Option<f64>,
    /// Take waves longer than this off (Gaussian, ISO 16610-61)
    #[arg(long, value_name = "CUTOFF", value_parser = args::one(Length), allow_hyphen_values = true)]
    l_filter: Option<f64>,
}

fn threshold(text: &str) -> Result<f64, String> {
    match quantity::parse(text, Dimension::Number) {
        Ok(value) if value > 0.0 => Ok(value),
        Ok(value) => Err(format!("the threshold {value} must be greater than 0; 8 is usual")),
        Err(error) => Err(error.to_string()),
    }
}

impl CleaningOptions {
    pub(crate) fn asked(self) -> Cleaning {
        let Self { align_rows, outliers, form, s_filter, l_filter } = self;
        Cleaning { align_rows, outliers, form, s_filter, l_filter }
    }

    /// Refuses cleaning where there is no file to be cleaned.
    pub(crate) fn refuse_without_file(self) -> Result<(), Failure> {
        if self.asked() == Cleaning::default() {
            return Ok(());
        }
        let message = "--align-rows, --outliers, --form, --s-filter and --l-filter clean a surface FILE, and \
                       none is given; name a FILE or leave them out";
        Err(Failure::refused("usage", message))
    }
}
