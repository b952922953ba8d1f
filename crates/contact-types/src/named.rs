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

/// A direction in the plane of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Axis {
    /// Along a row, from the first column to the last.
    X,
    /// Along a column, from the first row to the last.
    Y,
}

impl Named for Axis {
    const NAMES: &'static [(Self, &'static str)] = &[(Self::X, "x"), (Self::Y, "y")];
}
