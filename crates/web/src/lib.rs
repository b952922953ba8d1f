#![doc = include_str!("../README.md")]

mod areas;
mod defects;
mod inspect;
mod message;
mod numbers;
mod pace;
mod page;
mod place;
mod plan;
mod request;
mod run;
mod start;
mod surface;
mod trouble;

pub use message::Messages;
pub use page::{page, page_of_program};
pub use place::Host;

use contact_front_end::Failure;
use request::Request;
use trouble::Trouble;

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
