//! What is refused, as an exception that the Python layer sorts.

use contact_front_end::Failure;
use pyo3::exceptions::PyException;
use pyo3::{PyErr, create_exception};

create_exception!(
    rough_contact,
    Refused,
    PyException,
    "Why there is no answer: kind, message, exit status of the command. Sorted by the Python layer."
);

/// The exception of a failure.
pub(crate) fn raise(failure: &Failure) -> PyErr {
    Refused::new_err((failure.kind.clone(), failure.message.clone(), failure.status))
}

/// The exception of a request that the Python layer made wrong: a bug there.
pub(crate) fn bug(error: &dyn std::fmt::Display) -> PyErr {
    Refused::new_err(("internal".to_owned(), error.to_string(), 3))
}
