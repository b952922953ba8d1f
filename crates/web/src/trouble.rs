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

    /// One sentence, its effect, what to do.
    fn words(&self, place: Host) -> (&'static str, String, Vec<&'static str>) {
        let words = |heading, text: &str, ways| (heading, text.to_owned(), ways);
        match self {
            Self::Unread(ReadError::Empty) => {
                words("This file is empty.", "It has 0 bytes.", vec![AGAIN])
            }
            Self::Unread(ReadError::UnknownFormat { .. }) => words(
                "This file is not a height map it can read.",
                "Its content is none of the formats known here; the name does not matter.",
                vec![
                    "In the instrument’s software, export the heights as SUR, X3P or text.",
                    "Some instruments save several files: choose the one with the heights.",
                ],
            ),
            Self::Unread(ReadError::Limit { .. }) => words(
                place.asks_for_more(),
                &format!(
                    "It was refused before anything of that size was taken: here {} at most.",
                    place.limits_said()
                ),
                vec![
                    place.way_out(),
                    "If the file is much smaller than that, it contradicts itself: export it again.",
                ],
            ),
            Self::Unread(ReadError::Malformed { .. }) => words(
                "The file contradicts itself; nothing was computed.",
                "It may be cut short, or made to harm programs that believe it. Nothing of it was run or kept.",
                vec![AGAIN],
            ),
            Self::Unread(ReadError::NotANumber { .. }) => words(
                "One cell of this text is no number.",
                "",
                vec!["If a point is missing there, leave the cell empty or write NaN.", AGAIN],
            ),
            Self::Unread(ReadError::Ambiguous { .. }) => words(
                "This text can be read in two ways.",
                "",
                vec![
                    "Export the heights in one form only, with a decimal point.",
                    "The command rough-contact has an option for each reading.",
                ],
            ),
            Self::Unread(_) => words("This file gives no surface.", "", vec![AGAIN]),
            Self::Profile { .. } => words(
                "This is a profile, not a surface.",
                "Where two surfaces touch cannot be told from a line.",
                vec![
                    "Measure an area, or choose its file.",
                    "The command rough-contact says what a profile does tell.",
                ],
            ),
            Self::Incomplete(Incomplete::Fill(FillError::NothingValid { .. })) => {
                words("Not one point of this map was measured.", "", vec!["Choose another file."])
            }
            Self::Incomplete(_) => {
                words("The map cannot be made complete.", "", vec!["Change the remedies."])
            }
            Self::Study(_) => words(
                "There is no answer for this surface.",
                "",
                vec!["Look at the data-quality warnings.", "Change the bodies or the loads."],
            ),
            Self::Refused(failure) if failure.kind == "internal" => {
                words("The page asked wrongly; that is a bug.", "", vec![])
            }
            Self::Refused(_) => {
                words("That cannot be computed.", "", vec!["Change what was given."])
            }
        }
    }

    pub(crate) fn tell(&self, place: Host, out: &mut Messages<'_>) {
        let (failure, (heading, text, ways)) = (self.failure(), self.words(place));
        let text = if text.is_empty() { capital(&failure.message) } else { text };
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
