//! Reading and writing of files: whole, or not at all.

use super::error::{Named, OutputError};
use super::inside::Inside;
use crate::formats;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

/// What to do with results of an older version.
const AGAIN: &str = "read it with the version of Coulter that wrote it, or run its case.toml again into another folder (-o DIR)";
/// Largest text of a results folder that is read [bytes]; histories have some hundred bytes a sample.
const MOST_BYTES: u64 = 4 << 30;

/// Writes a whole file atomically: first under another name, which is then renamed.
pub fn write_whole(to: &Inside, content: &[u8]) -> Result<(), OutputError> {
    write_with(to, |file| file.write_all(content))
}

/// Writes a whole file as a stream, atomically like [`write_whole`].
pub fn write_with(to: &Inside, write: impl FnOnce(&mut File) -> io::Result<()>) -> Result<(), OutputError> {
    Ok(to.write_whole(".part", write)?)
}

/// Writes a copy of a file that the user has named.
pub fn write_copy(to: &Inside, from: &Path) -> Result<(), OutputError> {
    let mut source = File::open(from).named("read", from)?;
    write_with(to, |file| io::copy(&mut source, file).map(drop))
}

/// Reads a text file.
pub fn read_text(from: &Inside) -> Result<String, OutputError> {
    let bytes = from.read(MOST_BYTES).named("read", &from.path())?;
    String::from_utf8(bytes).map_err(|_| OutputError::content(&from.path(), "it is not UTF-8 text"))
}

/// Creates a folder and those above it.
pub fn make_folder(at: &Inside) -> Result<(), OutputError> {
    at.make_folder().named("create the folder", &at.path())
}

/// Writes a value as JSON, not-a-number as `null`.
pub fn write_json<T: serde::Serialize>(to: &Inside, value: &T) -> Result<(), OutputError> {
    let mut text = serde_json::to_string_pretty(value).map_err(|e| OutputError::content(&to.path(), e))?;
    text.push('\n');
    write_whole(to, text.as_bytes())
}

/// Reads a value of a results folder from JSON; `key` says in which version of the format it is.
pub fn read_json<T: serde::de::DeserializeOwned>(from: &Inside, key: &str) -> Result<T, OutputError> {
    let broken = |error: serde_json::Error| OutputError::content(&from.path(), error);
    let value: serde_json::Value = serde_json::from_str(&read_text(from)?).map_err(broken)?;
    formats::check(value[key].as_u64(), formats::RESULTS, "results", AGAIN)
        .map_err(|problem| OutputError::Format { path: from.path(), problem })?;
    serde_json::from_value(value).map_err(broken)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_disk_leaves_the_old_file_and_no_half_file() {
        let folder = tempfile::tempdir().unwrap();
        let summary = Inside::of(folder.path(), "summary.json");
        write_whole(&summary, b"before").unwrap();
        let full = |_: &mut File| Err(io::ErrorKind::StorageFull.into());
        let message = write_with(&summary, full).unwrap_err().to_string();
        assert!(message.contains("summary.json") && message.contains("no storage space"), "{message}");
        assert_eq!(read_text(&summary).unwrap(), "before");
        assert!(!summary.with_ending(".part").exists());
    }
}
