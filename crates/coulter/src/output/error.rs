//! What can go wrong when results are written or read, and the few file habits shared by all writers.

use super::names::{CHECKPOINTS, FIELDS, PICTURES, PLOTS};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Why results could not be written or read. Every variant names the file or folder.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The operating system refused.
    #[error("cannot {action} {path}: {source}", path = path.display())]
    File {
        /// What was tried.
        action: &'static str,
        /// On which file or folder.
        path: PathBuf,
        /// What the operating system said.
        source: io::Error,
    },
    /// There is a result already and nobody said that it may go.
    #[error(
        "{path} already holds a result; --force replaces it, -o DIR writes somewhere else",
        path = path.display()
    )]
    Exists {
        /// The folder.
        path: PathBuf,
    },
    /// Another run is at work in the folder.
    #[error(
        "another run is at work in {path} ({holder}); wait for its end, or write somewhere else with -o DIR",
        path = path.display()
    )]
    Busy {
        /// The folder.
        path: PathBuf,
        /// What the lock says of the run.
        holder: String,
    },
    /// The folder holds a run that has not come to its end, and nobody said what is to become of it.
    #[error(
        "{path} holds a run that was stopped before its end; --resume goes on with it, --force starts anew, -o DIR writes \
         somewhere else",
        path = path.display()
    )]
    Unfinished {
        /// The folder.
        path: PathBuf,
    },
    /// The folder has files in it that did not come from a run; they are never touched, forced or not.
    #[error(
        "{path} holds files that are not a result of Coulter; choose an empty or a new folder with -o DIR",
        path = path.display()
    )]
    Foreign {
        /// The folder.
        path: PathBuf,
    },
    /// A folder inside a results folder leads elsewhere.
    #[error("{path} is a link to somewhere else; remove it, or choose another folder with -o DIR", path = path.display())]
    Link {
        /// The folder.
        path: PathBuf,
    },
    /// The folder holds no result to work on.
    #[error("{path} holds no result of Coulter (there is no run.json in it)", path = path.display())]
    NoResult {
        /// The folder.
        path: PathBuf,
    },
    /// A file does not hold what it should.
    #[error("{path}: {problem}", path = path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// What is wrong with it, and where.
        problem: String,
    },
}

/// Folders inside a results folder.
const INNER: [&str; 4] = [CHECKPOINTS, FIELDS, PICTURES, PLOTS];

impl OutputError {
    pub(super) fn content(path: &Path, problem: impl std::fmt::Display) -> Self {
        Self::Content { path: path.to_path_buf(), problem: problem.to_string() }
    }
}

/// Names the file in an input/output error.
pub(super) trait Named<T> {
    /// Turns the error into an [`OutputError`] that says what was tried on which file.
    fn named(self, action: &'static str, path: &Path) -> Result<T, OutputError>;
}

impl<T> Named<T> for io::Result<T> {
    fn named(self, action: &'static str, path: &Path) -> Result<T, OutputError> {
        self.map_err(|source| OutputError::File { action, path: path.to_path_buf(), source })
    }
}

/// Writes a whole file so that a reader, or a kill, never meets half of it: into a neighbour first, then renamed.
pub(super) fn write_whole(path: &Path, content: &[u8]) -> Result<(), OutputError> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".part");
    let neighbour = path.with_file_name(name);
    let mut file = fs::File::create(&neighbour).named("create", &neighbour)?;
    let written = file.write_all(content).named("write", path);
    drop(file);
    let done = written.and_then(|()| fs::rename(&neighbour, path).named("replace", path));
    if done.is_err() {
        // On a full disc half a file would only be in the way.
        let _ = fs::remove_file(&neighbour);
    }
    done
}

/// Brings the names in a folder to the disk, where the system can (not on Windows, which does so by itself).
pub(super) fn sync_folder(path: &Path) -> Result<(), OutputError> {
    if cfg!(unix) { fs::File::open(path).and_then(|f| f.sync_all()).named("write", path) } else { Ok(()) }
}

/// Reads a text file.
pub(super) fn read_text(path: &Path) -> Result<String, OutputError> {
    fs::read_to_string(path).named("read", path)
}

/// Makes a folder and those above it. One inside a results folder must not be a link to somewhere else.
pub(super) fn make_folder(path: &Path) -> Result<(), OutputError> {
    let is_inner = path.file_name().is_some_and(|name| INNER.iter().any(|inner| name == *inner));
    if is_inner && path.is_symlink() {
        return Err(OutputError::Link { path: path.to_path_buf() });
    }
    fs::create_dir_all(path).named("create the folder", path)
}

/// Writes a value as JSON, a not-a-number as `null`.
pub(super) fn write_json<T: serde::Serialize>(path: &Path, value: &T) -> Result<(), OutputError> {
    let mut text = serde_json::to_string_pretty(value).map_err(|e| OutputError::content(path, e))?;
    text.push('\n');
    write_whole(path, text.as_bytes())
}

/// Reads a value from JSON.
pub(super) fn read_json<T: serde::de::DeserializeOwned>(path: &Path) -> Result<T, OutputError> {
    serde_json::from_str(&read_text(path)?).map_err(|e| OutputError::content(path, e))
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use std::os::unix::fs::symlink;

    #[test]
    fn a_full_disc_leaves_what_was_there_and_no_half_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        fs::write(&path, "before").unwrap();
        symlink("/dev/full", folder.path().join("summary.json.part")).unwrap();
        let told = write_whole(&path, b"after").unwrap_err().to_string();
        assert!(told.contains("summary.json") && told.contains("No space left"), "{told}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "before");
        assert!(!folder.path().join("summary.json.part").is_symlink());
    }

    #[test]
    fn a_linked_folder_of_results_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let elsewhere = tempfile::tempdir().unwrap();
        for name in INNER {
            symlink(elsewhere.path(), folder.path().join(name)).unwrap();
            let told = make_folder(&folder.path().join(name)).unwrap_err().to_string();
            assert!(told.contains("is a link"), "{told}");
        }
        assert!(make_folder(&folder.path().join("other")).is_ok());
    }
}
