//! `coulter.check`.

use crate::failure::wrong_case;
use crate::source::{Source, SourceText, request};
use coulter::case;
use coulter_cli::{check_document, check_text};
use pyo3::prelude::*;
use serde::Deserialize;

#[derive(Debug, Deserialize)]
struct CheckCall {
    source: Source,
    set: Vec<String>,
}

/// A case as it is understood: in words, and as JSON.
///
/// # Errors
/// `Failure` where the case is wrong.
#[pyfunction]
pub(crate) fn check(py: Python<'_>, call: &str) -> PyResult<(String, String)> {
    let CheckCall { source, set } = request(call)?;
    let SourceText { text, name } = source.text()?;
    py.detach(|| {
        let case = case::parse(&text, &name, &set)?;
        Ok((check_text(&case), check_document(&case).to_string()))
    })
    .map_err(|error| wrong_case(&error))
}
