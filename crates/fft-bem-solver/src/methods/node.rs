//! On which side a node of the finest grid is.

use super::transfer::FilledPart;

/// State of a node during one step. A byte, so that passes over a field of them keep their speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum NodeState {
    /// Outside the contact set F, to carry nothing.
    Gap,
    /// In F.
    Contact,
    /// Outside F, though it carries load: its gap is open too wide for that.
    Released,
    /// Outside F, at the ceiling.
    Full,
    /// Outside F, though it does not carry the ceiling: it overlaps too much for that.
    Filled,
}

impl NodeState {
    /// In F or outside, whatever it carries.
    #[inline(always)]
    pub(crate) fn of(is_in_contact: bool) -> Self {
        if is_in_contact { Self::Contact } else { Self::Gap }
    }

    #[inline(always)]
    pub(crate) fn is_in(self) -> bool {
        self == Self::Contact
    }

    /// Whether it is to carry the ceiling.
    #[inline(always)]
    pub(crate) fn is_full(self) -> bool {
        matches!(self, Self::Full | Self::Filled)
    }

    #[inline(always)]
    pub(crate) fn or(self, other: Self, is_other: bool) -> Self {
        if is_other { other } else { self }
    }
}

impl FilledPart for NodeState {
    #[inline(always)]
    fn value(self) -> f32 {
        if self.is_in() { 1.0 } else { 0.0 }
    }
}
