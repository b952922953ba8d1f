//! What the iteration remembers from step to step, and the ladder of fallbacks.

/// Iterations without halving the estimate before another kind of step is tried.
const STALL: usize = 8;

/// How the trial of a step is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Chord,
    Gradient,
    FaceCg,
}

/// What is known of an iterate before it is looked at.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Known {
    /// Mean of `u - h` in contact.
    pub(crate) level: Option<f64>,
    /// The level from which the gap is counted, if the residual field holds it.
    pub(crate) gap_from: Option<f64>,
}

/// What a step needs to know of the ones before.
pub(super) struct Memory {
    /// Length of the next preconditioned step and of the next gradient step.
    pub(super) tau: f64,
    pub(super) alpha: f64,
    /// Chord length of the last step.
    pub(super) a: f64,
    /// Whether `before` holds the iterate before this one, and `<d, K d>` of the step from it.
    pub(super) has_before: bool,
    pub(super) dkd: f64,
    /// What the step to the iterate found out about it.
    pub(super) known: Known,
    /// Smallest estimate that was a halving, and the iterations since.
    pub(super) best: f64,
    pub(super) since: usize,
    pub(super) kind: Kind,
}

impl Memory {
    /// The ladder of fallbacks: chords, then gradients, then conjugate gradients on the face; back
    /// to chords when the estimate has been halved.
    pub(super) fn watch_progress(
        &mut self,
        residual: f64,
        iteration: usize,
        is_forced: bool,
        events: &mut Vec<(usize, Kind)>,
    ) {
        if residual <= 0.5 * self.best {
            self.best = residual;
            self.since = 0;
        } else {
            self.since += 1;
        }
        if is_forced {
            return;
        }
        let kind = match self.since {
            0 => Kind::Chord,
            n if n < STALL => return,
            _ => {
                self.since = 0;
                self.has_before &= self.kind == Kind::Chord; // conjugate directions start anew
                if self.kind == Kind::Chord { Kind::Gradient } else { Kind::FaceCg }
            }
        };
        if kind != self.kind {
            // Conjugate gradients keep their direction in the place of the step before.
            self.has_before = self.has_before && kind == Kind::Gradient;
            if kind != Kind::Chord {
                events.push((iteration, kind));
            }
        }
        self.kind = kind;
        if kind == Kind::FaceCg {
            self.a = 1.0; // a node that is let go would keep its pressure: this step only moves F
        }
    }
}
