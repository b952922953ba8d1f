//! What a file leaves open, which `surface-io` says, as options of this command.

use crate::outcome::{Failure, unfit};
use rough_contact::front_end::Incomplete;
use rough_contact::surface_io::{Ambiguity, FillError, Layout, Need, ReadError};
use std::path::Path;

/// The refusal of a file, with the options that would let it be read.
pub(crate) fn unread(path: &Path, error: &ReadError) -> Failure {
    let way_out = match error {
        ReadError::UnknownFormat { .. } => "`rough-contact info --list` lists them".to_owned(),
        ReadError::PixelContradicts { .. } => "give --pixel DX,DY in that ratio".to_owned(),
        ReadError::BadLayout { .. } => "leave out --layout, or give the other one".to_owned(),
        ReadError::Limit { .. } => return Failure::in_file(path, error), // no option raises it
        _ => options(&error.needs()),
    };
    Failure::in_file(path, error).adding(&way_out)
}

/// The refusal of a measurement, with the options that would let it be answered.
pub(crate) fn unmade(path: &Path, error: &Incomplete) -> Failure {
    match error {
        Incomplete::Line(_) => {
            let row = "and no profile, which is one row (`rough-contact info` still reads it)";
            unfit(path, "profile", format!("{error}, {row}"))
        }
        Incomplete::Spikes(spikes) => {
            let ending = if *spikes == 1 { "" } else { "s" };
            let why = format!(
                "--outliers made {spikes} spike{ending} missing points, and --fill refuse keeps none; add --fill \
                 harmonic or --fill nearest, or raise the threshold"
            );
            unfit(path, "missing", why)
        }
        Incomplete::Cleaning(e) => Failure::in_file(path, e),
        Incomplete::Clean(e) => Failure::in_file(path, e),
        Incomplete::Short(e) => Failure::in_file(path, e).adding("measure a longer trace"),
        Incomplete::Fill(e @ FillError::NotConverged { .. }) => {
            Failure::in_file(path, e).adding("use --fill nearest")
        }
        Incomplete::Fill(e) => Failure::in_file(path, e).adding(&options(&e.needs())),
    }
}

/// How a text was read that could mean something else, and the option that settles it.
pub(crate) fn reading(ambiguity: Ambiguity) -> String {
    format!("{}; {}", ambiguity.what, options(ambiguity.needs))
}

fn options(needs: &[Need]) -> String {
    let is_scale =
        |need: &&Need| matches!(need, Need::PixelSize | Need::LateralUnit | Need::HeightUnit);
    let scales: Vec<&str> = needs.iter().filter(is_scale).map(|need| option(*need)).collect();
    if scales.is_empty() {
        return needs.iter().map(|need| option(*need)).collect::<Vec<_>>().join("; ");
    }
    format!("add {}", scales.join(" and "))
}

fn option(need: Need) -> &'static str {
    match need {
        Need::PixelSize => "--pixel DX[,DY]",
        Need::LateralUnit => "--lateral-unit U",
        Need::HeightUnit => "--height-unit U",
        Need::Channel => "choose one with --channel NAME",
        Need::Layout(Layout::Matrix) => "if they are heights, give --layout matrix",
        Need::Layout(Layout::List) => "if they are coordinates, give --layout list",
        Need::Layout(Layout::Traces) => "if they are traces of a stylus, give --layout traces",
        Need::DecimalMark => "give --decimal point or --decimal comma",
        Need::MissingMark => "if it marks missing points, give --missing MARK",
        Need::OtherHeightUnit => {
            "if they are heights in another unit, give --override-height-unit U"
        }
        Need::Fill => {
            "fill them with --fill harmonic or --fill nearest, or cut out the largest complete \
             part with --crop complete"
        }
        _ => "",
    }
}
