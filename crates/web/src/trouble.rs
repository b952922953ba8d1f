//! Why there is no answer, in the words of the page: what happened, its effect, what to do, the line for a bug report.

use crate::message::Messages;
use crate::place::Host;
use contact_compare::StudyError;
use contact_front_end::{Failure, Incomplete};
use serde_json::json;
use surface_io::{FillError, ReadError};

/// Why there is no answer.
#[derive(Debug)]
pub(crate) enum Trouble {
    /// The file gives no measurement.
    Unread(ReadError),
    /// The measurement gives no complete map.
    Incomplete(Incomplete),
    /// It is one line of points.
    Profile { points: usize },
    /// The study did not end.
    Study(StudyError),
    /// Anything else that was refused.
    Refused(Failure),
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Self {
        Self::Refused(failure)
    }
}

const AGAIN: &str = "Copy the file again, or export it again from the instrument.";

impl Trouble {
    fn failure(&self) -> Failure {
        match self {
            Self::Unread(e) => Failure::refused(e.kind(), e.to_string()),
            Self::Incomplete(e) => e.failure(),
            Self::Profile { points } => {
                Failure::refused("profile", format!("a single line of {points} points"))
            }
            Self::Study(e) => Failure::from(e),
            Self::Refused(failure) => failure.clone(),
        }
    }

    /// Tells what happened, its effect (the failure itself where there are no words for that), what to do.
    pub(crate) fn tell(&self, place: Host, out: &mut Messages<'_>) {
        let limits = place.limits_said();
        let limits = format!(
            "It was refused before anything of that size was taken: here {limits} at most."
        );
        let [heading, text, ways @ ..] = match self {
            Self::Unread(ReadError::Empty) => ["This file is empty.", "It has 0 bytes.", AGAIN, ""],
            Self::Unread(ReadError::UnknownFormat { .. }) => [
                "This file is not a height map it can read.",
                "Its content is none of the formats known here; the name does not matter.",
                "In the instrument’s software, export the heights as SUR, X3P or text.",
                "Some instruments save several files: choose the one with the heights.",
            ],
            Self::Unread(ReadError::Limit { .. }) => [
                place.asks_for_more(),
                &limits,
                place.way_out(),
                "If the file is much smaller than that, it contradicts itself: export it again.",
            ],
            Self::Unread(ReadError::Malformed { .. }) => [
                "The file contradicts itself; nothing was computed.",
                "It may be cut short, or made to harm programs that believe it. Nothing of it was run or kept.",
                AGAIN,
                "",
            ],
            Self::Unread(ReadError::NotANumber { .. }) => [
                "One cell of this text is no number.",
                "",
                "If a point is missing there, leave the cell empty or write NaN.",
                AGAIN,
            ],
            Self::Unread(ReadError::Ambiguous { .. }) => [
                "This text can be read in two ways.",
                "",
                "Export the heights in one form only, with a decimal point.",
                "The command rough-contact has an option for each reading.",
            ],
            Self::Unread(_) => ["This file gives no surface.", "", AGAIN, ""],
            Self::Profile { .. } => [
                "This is a profile, not a surface.",
                "Where two surfaces touch cannot be told from a line.",
                "Measure an area, or choose its file.",
                "The command rough-contact says what a profile does tell.",
            ],
            Self::Incomplete(Incomplete::Fill(FillError::NothingValid { .. })) => {
                ["Not one point of this map was measured.", "", "Choose another file.", ""]
            }
            Self::Incomplete(_) => {
                ["The map cannot be made complete.", "", "Change the remedies.", ""]
            }
            Self::Study(_) => [
                "There is no answer for this surface.",
                "",
                "Look at the data-quality warnings.",
                "Change the bodies or the loads.",
            ],
            Self::Refused(failure) if failure.kind == "internal" => {
                ["The page asked wrongly; that is a bug.", "", "", ""]
            }
            Self::Refused(_) => ["That cannot be computed.", "", "Change what was given.", ""],
        };
        let failure = self.failure();
        let message = capital(&failure.message);
        let text = if text.is_empty() { message.as_str() } else { text };
        let ways: Vec<&str> = ways.into_iter().filter(|way| !way.is_empty()).collect();
        let detail = format!("{}: {}", failure.kind, failure.message);
        let failure = failure.json();
        let said = json!({ "heading": heading, "text": text, "ways": ways, "detail": detail, "failure": failure });
        out.tell("error", said);
    }
}

fn capital(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}
