//! `solve --accuracy` and `--fast`: the rung that was reached.

use crate::outcome::Reply;
use rough_contact::compare::Reached;
pub(crate) use rough_contact::front_end::unmet;
use rough_contact::report::plan_explanation;

/// Puts the rung into the reply: its line, and the exit status if the accuracy is not met.
pub(crate) fn state(reached: &Reached, reply: &mut Reply) {
    reply.text.push_str(&plan_explanation(reached));
    reply.text.push('\n');
    if let Some(failure) = unmet("", reached) {
        reply.trouble = Some(match reply.trouble.take() {
            None => failure,
            Some(earlier) => earlier.and(failure),
        });
    }
}
