//! What can go wrong when results are written or read, and file functions shared by all writers.

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
    /// There is a result already, which must not be overwritten without being asked.
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
    /// A folder inside a results folder is a symbolic link.
    #[error("{path} is a link to another folder; remove it, or choose another folder with -o DIR", path = path.display())]
    Link {
        /// The folder.
        path: PathBuf,
    },
    /// The folder holds no result.
    #[error("{path} holds no result of Coulter (it contains no run.json)", path = path.display())]
    NoResult {
        /// The folder.
        path: PathBuf,
    },
    /// A file does not have the expected content.
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

/// Writes a whole file atomically: first under another name, which is then renamed.
pub(super) fn write_whole(path: &Path, content: &[u8]) -> Result<(), OutputError> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".part");
    let draft = path.with_file_name(name);
    let mut file = fs::File::create(&draft).named("create", &draft)?;
    let written = file.write_all(content).named("write", path);
    drop(file);
    let done = written.and_then(|()| fs::rename(&draft, path).named("replace", path));
    if done.is_err() {
        // On a full disk half a file would only take up space.
        let _ = fs::remove_file(&draft);
    }
    done
}

/// Flushes a folder's entries to disk, where the system supports it (Windows does so by itself).
pub(super) fn sync_folder(path: &Path) -> Result<(), OutputError> {
    if cfg!(unix) { fs::File::open(path).and_then(|f| f.sync_all()).named("write", path) } else { Ok(()) }
}

/// Reads a text file.
pub(super) fn read_text(path: &Path) -> Result<String, OutputError> {
    fs::read_to_string(path).named("read", path)
}

/// Creates a folder and its parents. One inside a results folder must not be a symbolic link.
pub(super) fn make_folder(path: &Path) -> Result<(), OutputError> {
    let is_inner = path.file_name().is_some_and(|name| INNER.iter().any(|inner| name == *inner));
    if is_inner && path.is_symlink() {
        return Err(OutputError::Link { path: path.to_path_buf() });
    }
    fs::create_dir_all(path).named("create the folder", path)
}

/// Writes a value as JSON, not-a-number as `null`.
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
    fn a_full_disk_leaves_the_old_file_and_no_half_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        fs::write(&path, "before").unwrap();
        symlink("/dev/full", folder.path().join("summary.json.part")).unwrap();
        let message = write_whole(&path, b"after").unwrap_err().to_string();
        assert!(message.contains("summary.json") && message.contains("No space left"), "{message}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "before");
        assert!(!folder.path().join("summary.json.part").is_symlink());
    }

    #[test]
    fn a_linked_folder_of_results_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let elsewhere = tempfile::tempdir().unwrap();
        for name in INNER {
            symlink(elsewhere.path(), folder.path().join(name)).unwrap();
            let message = make_folder(&folder.path().join(name)).unwrap_err().to_string();
            assert!(message.contains("is a link"), "{message}");
        }
        assert!(make_folder(&folder.path().join("other")).is_ok());
    }
}
