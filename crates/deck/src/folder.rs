//! The files of a deck: itself, and what lies in or below its folder.

use std::path::{Component, Path, PathBuf};

/// Largest file that is read [bytes].
const MOST: u64 = 256 << 20;

/// The folder of a deck.
pub(super) struct Folder(PathBuf);

/// The text of a deck, and its folder.
pub(super) fn open(path: &Path) -> Result<(String, Folder), String> {
    let whole = path.canonicalize().map_err(|error| format!("{}: {error}", path.display()))?;
    let text = text(&whole)?;
    let folder = whole.parent().map(Path::to_path_buf).unwrap_or_default();
    Ok((text, Folder(folder)))
}

impl Folder {
    /// The text of a file that the deck names.
    pub(super) fn read(&self, name: &str) -> Result<String, String> {
        let relative = Path::new(name);
        if !relative.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
            return Err("only files in the folder of the deck or below it are read".to_owned());
        }
        let path = self.0.join(relative).canonicalize().map_err(|error| error.to_string())?;
        if !path.starts_with(&self.0) {
            return Err("it is a link out of the folder of the deck".to_owned());
        }
        text(&path)
    }
}

/// The text of an ordinary file; bytes that are not UTF-8 become �.
fn text(path: &Path) -> Result<String, String> {
    let about = std::fs::metadata(path).map_err(|error| error.to_string())?;
    if !about.is_file() {
        return Err("not an ordinary file".to_owned());
    }
    if about.len() > MOST {
        return Err(format!("{} bytes, at most {MOST} are read", about.len()));
    }
    let bytes = std::fs::read(path).map_err(|error| error.to_string())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
