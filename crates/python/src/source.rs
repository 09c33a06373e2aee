//! Where a case comes from: a file, or nested maps.

use crate::failure::{refused, wrong_case};
use coulter::case;
use coulter::run::Device;
use pyo3::PyResult;
use serde::Deserialize;
use serde_json::Value;
use std::path::PathBuf;

/// A case as it is given.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Source {
    /// The path of the case file.
    Path(PathBuf),
    /// Keys and values of a case, as the file would have them.
    Keys(Value),
}

/// The text of a case, and what to call it in messages.
#[derive(Debug)]
pub(crate) struct SourceText {
    pub(crate) text: String,
    pub(crate) name: String,
}

/// Name of a case that is no file. The files that it names lie beside it, hence in the current folder.
const UNNAMED: &str = "case.toml";

impl Source {
    /// Text of the case. Nested maps are written as a case file, so that whatever is said of it has a line.
    pub(crate) fn text(&self) -> PyResult<SourceText> {
        match self {
            Self::Path(path) => {
                let text = case::text(path).map_err(|error| wrong_case(&error))?;
                Ok(SourceText { text, name: path.display().to_string() })
            }
            Self::Keys(keys) => {
                let text = toml::to_string(keys).map_err(|why| {
                    refused(format!(
                        "the case cannot be written as a case file: {why}; give nested dicts of text, numbers, truth values and \
                         lists"
                    ))
                })?;
                Ok(SourceText { text, name: UNNAMED.to_owned() })
            }
        }
    }
}

/// Reads a request, which the Python part has written.
pub(crate) fn request<'a, T: Deserialize<'a>>(text: &'a str) -> PyResult<T> {
    serde_json::from_str(text).map_err(|why| refused(format!("the request cannot be read: {why}")))
}

/// What strains the soil, by its word on the command line.
pub(crate) fn device(word: &str) -> PyResult<Device> {
    word.parse().map_err(|why| refused(format!("device: {why}")))
}

/// A number of threads, meshes or workers. What is allowed of each is checked where it is used.
pub(crate) fn count<N: TryFrom<i64>>(name: &str, number: Option<i64>) -> PyResult<Option<N>> {
    let fits = |number| {
        N::try_from(number)
            .map_err(|_| refused(format!("{name} = {number}: there is no such number of {name}")))
    };
    number.map(fits).transpose()
}
