//! Files with numbers that a case names: read as a whole, none larger than its use warrants.

use std::path::Path;

/// What is wrong with a file, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileProblem {
    /// What is wrong with the file, and in which line.
    pub message: String,
    /// What to do about the file.
    pub cure: String,
}

/// Refuses a file.
pub(super) fn problem<T>(message: impl Into<String>, cure: impl Into<String>) -> Result<T, FileProblem> {
    Err(FileProblem { message: message.into(), cure: cure.into() })
}

const PATH: &str = "check the path, which is relative to the folder of the case file";

/// The content of an ordinary file of at most so many bytes; `smaller` says how to make it smaller.
pub(super) fn bytes(path: &Path, most: u64, smaller: &str) -> Result<Vec<u8>, FileProblem> {
    let about = std::fs::metadata(path).or_else(|error| problem(format!("cannot be read: {error}"), PATH))?;
    if !about.is_file() {
        return problem("not an ordinary file", PATH);
    }
    if about.len() > most {
        return problem(format!("{} bytes, at most {most} are read", about.len()), smaller);
    }
    std::fs::read(path).or_else(|error| problem(format!("cannot be read: {error}"), PATH))
}
