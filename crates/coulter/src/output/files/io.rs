//! Reading and writing of files: whole, or not at all.

use super::error::{Named, OutputError};
use super::names::{BODIES, CHECKPOINTS, FIELDS, MESHES, PICTURES, PLOTS};
use crate::formats;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

/// What to do with results of an older version.
const AGAIN: &str = "read it with the version of Coulter that wrote it, or run its case.toml again into another folder (-o DIR)";
/// Folders inside a results folder.
const INNER: [&str; 6] = [BODIES, CHECKPOINTS, FIELDS, MESHES, PICTURES, PLOTS];

/// Writes a whole file atomically: first under another name, which is then renamed.
pub(crate) fn write_whole(path: &Path, content: &[u8]) -> Result<(), OutputError> {
    write_with(path, |file| file.write_all(content))
}

/// Writes a whole file as a stream, atomically like [`write_whole`].
pub(crate) fn write_with(
    path: &Path,
    write: impl FnOnce(&mut File) -> io::Result<()>,
) -> Result<(), OutputError> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".part");
    let draft = path.with_file_name(name);
    let mut file = File::create(&draft).named("create", &draft)?;
    let written = write(&mut file).named("write", path);
    drop(file);
    let done = written.and_then(|()| fs::rename(&draft, path).named("replace", path));
    if done.is_err() {
        // On a full disk half a file would only take up space.
        let _ = fs::remove_file(&draft);
    }
    done
}

/// Flushes a folder's entries to disk, where the system supports it (Windows does so by itself).
pub(crate) fn sync_folder(path: &Path) -> Result<(), OutputError> {
    if cfg!(unix) { fs::File::open(path).and_then(|f| f.sync_all()).named("write", path) } else { Ok(()) }
}

/// Reads a text file.
pub(crate) fn read_text(path: &Path) -> Result<String, OutputError> {
    fs::read_to_string(path).named("read", path)
}

/// Creates a folder and its parents. One inside a results folder must not be a symbolic link.
pub(crate) fn make_folder(path: &Path) -> Result<(), OutputError> {
    let is_inner = path.file_name().is_some_and(|name| INNER.iter().any(|inner| name == *inner));
    if is_inner && path.is_symlink() {
        return Err(OutputError::Link { path: path.to_path_buf() });
    }
    fs::create_dir_all(path).named("create the folder", path)
}

/// Writes a value as JSON, not-a-number as `null`.
pub(crate) fn write_json<T: serde::Serialize>(path: &Path, value: &T) -> Result<(), OutputError> {
    let mut text = serde_json::to_string_pretty(value).map_err(|e| OutputError::content(path, e))?;
    text.push('\n');
    write_whole(path, text.as_bytes())
}

/// Reads a value of a results folder from JSON; `key` says in which version of the format it is.
pub(crate) fn read_json<T: serde::de::DeserializeOwned>(path: &Path, key: &str) -> Result<T, OutputError> {
    let value: serde_json::Value =
        serde_json::from_str(&read_text(path)?).map_err(|e| OutputError::content(path, e))?;
    formats::check(value[key].as_u64(), formats::RESULTS, "results", AGAIN)
        .map_err(|problem| OutputError::Format { path: path.to_path_buf(), problem })?;
    serde_json::from_value(value).map_err(|e| OutputError::content(path, e))
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
