//! Forms as they are typed.

use super::form::Form;
use crate::polynomial::MAX_DEGREE;
use std::fmt;
use std::str::FromStr;

/// A text that names no form.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FormNameError {
    /// `polynomial:` without a degree that can be fitted.
    #[error("'{text}' has no degree from 0 to {MAX_DEGREE}; write for example polynomial:4")]
    Degree {
        /// What was typed.
        text: String,
    },
    /// None of the names.
    #[error(
        "'{text}' is no form; write plane, quadratic, polynomial:N with N from 0 to {MAX_DEGREE}, \
         sphere or cylinder"
    )]
    Unknown {
        /// What was typed.
        text: String,
    },
}

impl FromStr for Form {
    type Err = FormNameError;

    /// `plane`, `quadratic`, `polynomial:N`, `sphere` or `cylinder`.
    fn from_str(text: &str) -> Result<Self, FormNameError> {
        let text = text.trim();
        match text {
            "plane" => Ok(Self::Polynomial(1)),
            "quadratic" => Ok(Self::Polynomial(2)),
            "sphere" => Ok(Self::Sphere),
            "cylinder" => Ok(Self::Cylinder),
            _ => match text.strip_prefix("polynomial:").map(str::parse) {
                Some(Ok(degree)) if degree <= MAX_DEGREE => Ok(Self::Polynomial(degree)),
                Some(_) => Err(FormNameError::Degree { text: text.to_owned() }),
                None => Err(FormNameError::Unknown { text: text.to_owned() }),
            },
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Polynomial(1) => f.write_str("plane"),
            Self::Polynomial(2) => f.write_str("quadratic"),
            Self::Polynomial(degree) => write!(f, "polynomial:{degree}"),
            Self::Sphere => f.write_str("sphere"),
            Self::Cylinder => f.write_str("cylinder"),
        }
    }
}

impl TryFrom<String> for Form {
    type Error = FormNameError;

    fn try_from(text: String) -> Result<Self, FormNameError> {
        text.parse()
    }
}

impl From<Form> for String {
    fn from(form: Form) -> Self {
        form.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_read_back_as_they_are_written() {
        for text in ["plane", "quadratic", "polynomial:0", "polynomial:12", "sphere", "cylinder"] {
            assert_eq!(text.parse::<Form>().unwrap().to_string(), text);
        }
        assert_eq!("polynomial:1".parse::<Form>(), "plane".parse());
        for text in ["polynomial:13", "polynomial:", "polynomial:-1", "polynomial:2.5", "ball", ""]
        {
            assert!(text.parse::<Form>().is_err(), "{text}");
        }
    }
}
