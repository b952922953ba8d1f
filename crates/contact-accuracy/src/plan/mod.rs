//! `--accuracy`: the cheapest grid, precision and tolerance whose error budget meets a request.
//!
//! Nothing is guessed about the surface. What a coarser grid would lose is read off the spectrum
//! of the map; the coarsest grid that may do is solved, lightest load first; the contact line found
//! there says what the bar would be on every other grid, so that at most a quarter of the final
//! work is spent on a grid that is given up. Choices depend on the heights, the loads and the
//! request only, never on a clock: seconds are reported, not used.

mod bar;
mod candidates;
mod outcome;
mod request;
mod run;

pub use bar::{Line, budget};
pub use candidates::{Candidate, Candidates, MOST_POINTS};
pub use outcome::{Finest, Miss, Next, NoBar, Outcome, Unmet};
pub use request::{BadRequest, Request};
pub use run::{PlanError, Sink, Task, run};
