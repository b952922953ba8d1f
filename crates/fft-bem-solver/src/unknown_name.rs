//! A setting that was given by a name.

/// A name that is none of those that a setting has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{found}` is no {what}; the choices are {}", .known.join(", "))]
#[non_exhaustive]
pub struct UnknownName {
    /// What was asked for: `method`, `boundary`, `precision`.
    pub what: &'static str,
    /// What was found.
    pub found: String,
    /// The names there are.
    pub known: &'static [&'static str],
}
