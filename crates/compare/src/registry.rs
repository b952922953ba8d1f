//! The open list of models: the built-in ones and those a program adds.

use crate::progress::StudyError;
use crate::theories;
use crate::theory::{Card, Theory};
use std::sync::{Arc, LazyLock};

/// Every theory that a study may ask, in the order of tables and figures.
#[derive(Clone)]
pub struct Registry {
    theories: Vec<Arc<dyn Theory>>,
}

impl std::fmt::Debug for Registry {
    /// The names.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter().map(|theory| &theory.card().name)).finish()
    }
}

static BUILT_IN: LazyLock<Registry> = LazyLock::new(|| Registry { theories: theories::all() });

/// The built-in theories, for the life of the program.
pub fn built_in() -> &'static Registry {
    &BUILT_IN
}

/// The built-in theory of a name.
pub fn find(name: &str) -> Option<&'static dyn Theory> {
    BUILT_IN.find(name)
}

impl Registry {
    /// The same with one more, after the others.
    ///
    /// # Errors
    /// [`StudyError::BadName`], [`StudyError::NameTaken`] and [`StudyError::LabelTaken`].
    pub fn with(&self, theory: impl Theory + 'static) -> Result<Self, StudyError> {
        let (name, label) = (theory.card().name.to_string(), theory.card().label.to_string());
        let may_be = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if name.is_empty() || !name.chars().all(may_be) {
            return Err(StudyError::BadName(name));
        }
        if self.find(&name).is_some() {
            return Err(StudyError::NameTaken(name));
        }
        if let Some(other) = self.iter().find(|t| t.card().label == label) {
            let other = other.card().name.to_string();
            return Err(StudyError::LabelTaken { label, other });
        }
        let mut theories = self.theories.clone();
        theories.push(Arc::new(theory));
        Ok(Self { theories })
    }

    /// The theory of a name.
    pub(crate) fn find(&self, name: &str) -> Option<&dyn Theory> {
        self.iter().find(|theory| theory.card().name == name)
    }

    /// All of them, in order.
    pub fn iter(&self) -> impl Iterator<Item = &dyn Theory> {
        self.theories.iter().map(AsRef::as_ref)
    }

    /// Those that a study may ask, in order: what a height map gives, and a hardness.
    pub fn of_studies(&self) -> impl Iterator<Item = &dyn Theory> {
        let is_of_area = |card: &Card| card.from_map || (card.yields && !card.is_rigid);
        self.iter().filter(move |theory| is_of_area(theory.card()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::needs::Inputs;
    use crate::tabulated::{CurvePoint, Tabulated};
    use crate::theory::BuildError;
    use contact_types::{Citation, ContactModulus};

    #[test]
    fn every_built_in_theory_is_complete() {
        let registry = built_in();
        let bare = Inputs::new(ContactModulus::from_pascals(1e11).unwrap());
        for (i, theory) in registry.iter().enumerate() {
            let card = theory.card();
            let model = Inputs::examples().iter().find_map(|i| theory.build(i).ok()).unwrap();
            assert!(card.citation == model.citation(), "{card:?}");
            let state = model.at_pressure(1e6).unwrap();
            assert!(state.area_fraction > 0.0 && state.area_fraction < 1.0, "{card:?}");
            let before = || registry.iter().take(i).map(Theory::card);
            assert!(before().all(|c| c.name != card.name && c.label != card.label));
            assert_eq!(registry.find(&card.name).unwrap().card(), card);
            // It can be asked from numbers alone, and says what it lacks.
            assert!(!card.inputs.is_empty() && !card.needs.is_empty(), "{card:?}");
            let made = theory.build(&bare);
            assert!(matches!(made, Err(BuildError::Missing { .. })), "{card:?}");
        }
        assert!(registry.find("nothing").is_none());
    }

    #[test]
    fn names_and_labels_are_unique() {
        let card = |name: &'static str, title: &'static str| {
            let citation = Citation::new("me", 2026, "title", "journal", "");
            let point = CurvePoint { mean_pressure: 1.0, area_fraction: 0.5, mean_gap: None };
            Tabulated::new(Card::new(name, title, citation), vec![point]).unwrap()
        };
        let own = built_in().with(card("mine", "Mine")).unwrap();
        assert_eq!(own.iter().last().unwrap().card().label, "Mine");
        let taken = own.with(card("gw", "Other"));
        assert!(matches!(taken, Err(StudyError::NameTaken { .. })));
        let taken = own.with(card("mine-2", "Persson"));
        assert!(matches!(taken, Err(StudyError::LabelTaken { .. })));
        for bad in ["", "My model", "a,b"] {
            let refused = own.with(card(bad, "Other"));
            assert!(matches!(refused, Err(StudyError::BadName { .. })), "{bad}");
        }
    }
}
