//! Failures as one Python exception, which the Python part turns into those that its users see.

use coulter::case::CaseError;
use coulter_cli::{Failure, problems_text};
use pyo3::PyErr;
use serde_json::json;

mod exception {
    // What the macro writes cannot be documented.
    #![allow(missing_docs)]
    pyo3::create_exception!(coulter._native, NativeFailure, pyo3::exceptions::PyException);
}
pub(crate) use exception::NativeFailure;

/// The exception for a failure: its kind (`case`, `request`, `physics`, `stopped`, `internal`), its text, and
/// as JSON the problems of a case.
pub(crate) fn raised(failure: &Failure) -> PyErr {
    match failure {
        Failure::Case(error) => wrong_case(error),
        Failure::Request(message) => of_kind("request", message.clone()),
        Failure::Physics(message) => of_kind("physics", message.clone()),
        Failure::Stopped { message, .. } => of_kind("stopped", message.clone()),
        Failure::Elsewhere(_) => of_kind("internal", failure.to_string()),
    }
}

/// The exception for a request that is wrong; says what to do instead.
pub(crate) fn refused(message: impl Into<String>) -> PyErr {
    of_kind("request", message.into())
}

/// The exception for a fault of this program.
pub(crate) fn internal() -> PyErr {
    of_kind("internal", "an internal error: please report it with the case".to_owned())
}

fn of_kind(kind: &'static str, message: String) -> PyErr {
    NativeFailure::new_err((kind, message, "[]".to_owned()))
}

/// The exception for a case that is wrong, with the text that the command prints.
pub(crate) fn wrong_case(error: &CaseError) -> PyErr {
    let problems: Vec<_> = error
        .problems
        .iter()
        .map(|p| json!({ "path": p.path, "message": p.message, "cure": p.cure, "line": p.line, "column": p.column }))
        .collect();
    NativeFailure::new_err(("case", problems_text(error), json!(problems).to_string()))
}
