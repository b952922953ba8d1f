//! What the iteration remembers from step to step, and the ladder of fallbacks.

/// Iterations without halving the estimate before another kind of step is tried.
const STALL: usize = 8;
/// Range of the length of the preconditioned step.
const TAU: [f64; 2] = [0.3, 1.0];
/// By how much that length may change from one step to the next.
const CHANGE: [f64; 2] = [0.7, 1.4];

/// How the trial of a step is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StepKind {
    /// Along the preconditioned residual, swept.
    Chord,
    /// Along the residual gap, projected on the pressures that are positive and carry the load.
    Gradient,
    /// Conjugate gradients on the nodes in contact.
    FaceCg,
}

/// What is known of an iterate before it is looked at.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) enum Known {
    #[default]
    Nothing,
    /// The mean of `u - h` in contact.
    Level(f64),
    /// That mean; and the residual field holds the gap, but counted from another level.
    Gap { level: f64, counted_from: f64 },
}

/// What a step needs to know of the ones before.
pub(super) struct Memory {
    /// Length of the next preconditioned step and of the next gradient step.
    pub(super) tau: f64,
    pub(super) alpha: f64,
    /// Chord length of the last step.
    pub(super) length: f64,
    /// Whether no trial was taken yet.
    pub(super) is_first: bool,
    /// Whether the iterate before this one is kept, and `<d, K d>` of the step from it.
    pub(super) has_before: bool,
    pub(super) dkd: f64,
    /// What the step to the iterate found out about it.
    pub(super) known: Known,
    /// Estimate of the relative pressure error.
    pub(super) residual: f64,
    /// Smallest estimate that was a halving, and the iterations since.
    best: f64,
    since: usize,
    kind: StepKind,
    is_forced: bool,
}

impl Memory {
    /// Before the first step, which begins with a chord of full length, or from the contact of another
    /// load, whose nodes may have to be released. Tests force a kind.
    pub(super) fn new(is_cold: bool, forced: Option<StepKind>) -> Self {
        Self {
            tau: 1.0,
            alpha: 1.5,
            length: if is_cold { 1.0 } else { 0.0 },
            is_first: true,
            has_before: false,
            dkd: 0.0,
            known: Known::Nothing,
            residual: f64::INFINITY,
            best: f64::INFINITY,
            since: 0,
            kind: forced.unwrap_or(StepKind::Chord),
            is_forced: forced.is_some(),
        }
    }

    /// The next preconditioned step is to be `theta` times as long: so far along the last one the energy fell.
    pub(super) fn adapt_length(&mut self, theta: f64) {
        self.tau = (self.tau * theta.clamp(CHANGE[0], CHANGE[1])).clamp(TAU[0], TAU[1]);
    }

    /// The ladder of fallbacks: chords, then gradients, then conjugate gradients on the face; back
    /// to chords when the estimate has been halved.
    pub(super) fn next_kind(&mut self) -> StepKind {
        if self.residual <= 0.5 * self.best {
            self.best = self.residual;
            self.since = 0;
        } else {
            self.since += 1;
        }
        if self.is_forced {
            return self.kind;
        }
        let kind = match self.since {
            0 => StepKind::Chord,
            n if n < STALL => return self.kind,
            _ => {
                self.since = 0;
                self.has_before &= self.kind == StepKind::Chord; // conjugate directions start anew
                if self.kind == StepKind::Chord { StepKind::Gradient } else { StepKind::FaceCg }
            }
        };
        if kind != self.kind {
            // Conjugate gradients keep their direction in the place of the step before.
            self.has_before = self.has_before && kind == StepKind::Gradient;
        }
        self.kind = kind;
        if kind == StepKind::FaceCg {
            self.length = 1.0; // a node that is let go would keep its pressure: this step only moves F
        }
        kind
    }
}
