//! Choices by name.

/// A choice among several, each with a name as people type it and files keep it.
pub trait Named: Copy + PartialEq + 'static {
    /// Every choice with its name, in the order in which help texts list them.
    const NAMES: &'static [(Self, &'static str)];

    /// Its name.
    fn name(self) -> &'static str {
        let found = Self::NAMES.iter().find(|(choice, _)| *choice == self);
        found.map_or("", |(_, name)| name)
    }

    /// The choice of that name.
    fn of_name(name: &str) -> Option<Self> {
        Self::all().find(|choice| choice.name() == name)
    }

    /// Every choice.
    fn all() -> impl Iterator<Item = Self> {
        Self::NAMES.iter().map(|(choice, _)| *choice)
    }
}
