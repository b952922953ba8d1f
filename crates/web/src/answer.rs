//! One question of the page, answered.

use crate::message::Messages;
use crate::place::Host;
use crate::request::Request;
use crate::trouble::Trouble;
use crate::{areas, inspect, plan, run, start};
use contact_front_end::Failure;

/// Answers one question about the bytes of a file: `start`, `inspect`, `meaning`, `areas`, `plan` or `run`. The request is JSON.
/// What is refused is a message as well. When `out` cannot be written any more, a run stops.
pub fn answer(question: &str, request: &str, file: &[u8], place: Host, out: &mut Messages<'_>) {
    let answered = serde_json::from_str::<Request>(request)
        .map_err(|e| Trouble::Refused(Failure::refused("internal", e.to_string())))
        .map(|request| Request { place, ..request })
        .and_then(|request| match question {
            "start" => start::answer(place).map(Some),
            "inspect" => inspect::answer(&request, file).map(Some),
            "meaning" => inspect::meaning(&request).map(Some),
            "areas" => areas::answer(&request, file, out),
            "plan" => plan::answer(&request).map(Some),
            "run" => run::answer(&request, file, out).map(Some),
            other => {
                Err(Failure::refused("internal", format!("there is no question {other:?}")).into())
            }
        });
    match answered {
        Ok(done) => done.into_iter().for_each(|done| out.tell("done", done)),
        Err(trouble) => trouble.tell(place, out),
    }
}
