//! What can go wrong when results are written or read.

use std::io;
use std::path::{Path, PathBuf};

/// Why a file or folder could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("cannot {action} {}: {source}", .path.display())]
pub struct FileError {
    /// What was tried, such as "write".
    pub action: &'static str,
    /// The file or folder.
    pub path: PathBuf,
    /// What the operating system said.
    pub source: io::Error,
}

/// Why results could not be written or read. Every variant names the file or folder.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The operating system refused.
    #[error(transparent)]
    File(#[from] FileError),
    /// The folder holds a result already, which must not be overwritten without being asked.
    #[error(
        "{path} already holds a result; --force replaces it, -o DIR writes to another folder",
        path = path.display()
    )]
    Exists {
        /// The folder.
        path: PathBuf,
    },
    /// Another run is using the folder.
    #[error(
        "another run is using {path} ({holder}); wait for its end, or write to another folder with -o DIR",
        path = path.display()
    )]
    Busy {
        /// The folder.
        path: PathBuf,
        /// The owner of the lock.
        holder: String,
    },
    /// The folder holds a run that has not reached its end.
    #[error(
        "{path} holds a run that was stopped before its end; --resume continues it, --force starts again, -o DIR writes \
         to another folder",
        path = path.display()
    )]
    Unfinished {
        /// The folder.
        path: PathBuf,
    },
    /// The folder holds files that are not from a run; they are never touched, not even with `--force`.
    #[error(
        "{path} holds files that are not a result of Coulter; choose an empty or a new folder with -o DIR",
        path = path.display()
    )]
    Foreign {
        /// The folder.
        path: PathBuf,
    },
    /// The folder holds no result.
    #[error("{path} holds no result of Coulter (it contains no run.json)", path = path.display())]
    NoResult {
        /// The folder.
        path: PathBuf,
    },
    /// A file is of another version of the format of results.
    #[error("{path}: {problem}", path = path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// What is wrong with the file, and what to do.
        problem: String,
    },
    /// A file does not have the expected content.
    #[error("{path}: {problem}", path = path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// What is wrong with the file, and where.
        problem: String,
    },
}

impl OutputError {
    /// A file with contents that cannot be used, or made.
    #[must_use]
    pub fn content(path: &Path, problem: impl std::fmt::Display) -> Self {
        Self::Content { path: path.to_path_buf(), problem: problem.to_string() }
    }
}

/// Names the file in an input/output error.
pub trait Named<T> {
    /// Turns the error into an [`OutputError`] that says what was tried on which file.
    fn named(self, action: &'static str, path: &Path) -> Result<T, OutputError>;
}

impl<T> Named<T> for io::Result<T> {
    fn named(self, action: &'static str, path: &Path) -> Result<T, OutputError> {
        self.map_err(|source| FileError { action, path: path.to_path_buf(), source }.into())
    }
}
