//! Reading and writing of files, whole or not at all: the only file of this crate that touches any.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Why a file could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("cannot {action} {}: {source}", .path.display())]
pub struct FileError {
    /// What was tried.
    pub action: &'static str,
    /// On which file or folder.
    pub path: PathBuf,
    /// What the operating system said.
    pub source: io::Error,
}

/// Names the file in an error of the system.
fn named<T>(result: io::Result<T>, action: &'static str, path: &Path) -> Result<T, FileError> {
    result.map_err(|source| FileError { action, path: path.to_path_buf(), source })
}

/// The content of an ordinary file; one of more than `most` bytes, a folder or a pipe is refused.
///
/// # Errors
/// [`FileError`] where it cannot be read.
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let refuse = |why: String| named(Err(io::Error::other(why)), "read", path);
    let about = named(std::fs::metadata(path), "read", path)?;
    if !about.is_file() {
        return refuse("it is not an ordinary file".to_owned());
    }
    if about.len() > most {
        return refuse(format!("it has {} bytes, at most {most} are read", about.len()));
    }
    named(std::fs::read(path), "read", path)
}

/// Writes a whole file: under a name of its own first, which is then renamed, so that neither a kill nor another process that writes
/// the same file leaves half of one.
///
/// # Errors
/// [`FileError`] where it cannot be written.
pub fn write(path: &Path, content: &[u8]) -> Result<(), FileError> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.part", std::process::id()));
    let draft = path.with_file_name(name);
    let written = std::fs::File::create(&draft).and_then(|mut file| file.write_all(content));
    let done = written.and_then(|()| std::fs::rename(&draft, path));
    if done.is_err() {
        // On a full disk half a file would only take up space.
        let _ = std::fs::remove_file(&draft);
    }
    named(done, "write", path)
}

/// Creates a folder and its parents.
///
/// # Errors
/// [`FileError`] where that is not possible.
pub fn make_folder(path: &Path) -> Result<(), FileError> {
    named(std::fs::create_dir_all(path), "create the folder", path)
}

/// Whether a folder holds anything.
///
/// # Errors
/// [`FileError`] where it is a file, or cannot be read.
pub fn is_used(folder: &Path) -> Result<bool, FileError> {
    if !folder.exists() {
        return Ok(false);
    }
    named(std::fs::read_dir(folder), "read", folder).map(|mut entries| entries.next().is_some())
}

/// The names of the files in a folder, in no order.
///
/// # Errors
/// [`FileError`] where it cannot be read.
pub fn names(folder: &Path) -> Result<Vec<String>, FileError> {
    let entries = named(std::fs::read_dir(folder), "read", folder)?;
    Ok(entries.filter_map(|entry| Some(entry.ok()?.file_name().to_string_lossy().into_owned())).collect())
}

/// Removes a file, if it is there.
pub fn forget(path: &Path) {
    let _ = std::fs::remove_file(path);
}
