//! `solve --accuracy`: grid, precision and tolerance chosen for a request.

use crate::outcome::Reply;
pub(crate) use answers::unmet;
use compare::plan::Outcome;
use report::plan_explanation;

/// Puts the plan into the reply: its line, and the exit status if it is not met, with
/// the way out if loads without a bar are `refinable`.
pub(crate) fn state(outcome: &Outcome, refinable: bool, reply: &mut Reply) {
    let line = plan_explanation(outcome);
    reply.text.push_str(&line);
    reply.text.push('\n');
    let refine =
        "; --refine instead of --accuracy gives the interval that a twice finer grid leaves";
    let way_out = if refinable { refine } else { "" };
    if let Some(failure) = unmet("", outcome, way_out) {
        reply.trouble = Some(match reply.trouble.take() {
            None => failure,
            Some(earlier) => earlier.and(failure),
        });
    }
}
