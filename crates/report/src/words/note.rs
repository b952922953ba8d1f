//! One entry of "Read before use".

/// How much a note matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Weight {
    /// May change a conclusion.
    Check,
    /// Good to know.
    Note,
    /// Tested and fine.
    Passed,
}

/// One entry: a claim with its number, then its effect and what to do. Both are HTML.
#[derive(Debug, Clone)]
pub(crate) struct Note {
    /// How much it matters.
    pub weight: Weight,
    /// Bold part.
    pub claim: String,
    /// The rest.
    pub text: String,
}

/// An entry.
pub(crate) fn note(weight: Weight, claim: impl Into<String>, text: impl Into<String>) -> Note {
    Note { weight, claim: claim.into(), text: text.into() }
}
