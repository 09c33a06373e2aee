//! The entries of a folder that others may have filled: results, studies. This is the one place that opens,
//! makes, renames and removes them.
//!
//! Nothing is followed out of the folder: an entry that is a link, a pipe or a device is refused, and so is
//! one in a sub-folder that is a link. The folder itself may be one, for its user has named it. What is
//! written never changes a file under another of its names (hard links).

mod kind;
#[cfg(unix)]
#[path = "unix.rs"]
mod system;
#[cfg(not(unix))]
#[path = "elsewhere.rs"]
mod system;

pub use kind::EntryKind;

use super::error::FileError;
use kind::{forbidden, refused};
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use system::Opened;

/// An entry of a folder: the folder, as its user names it, and the name of the entry there, such as
/// `fields/soil_0000.vtr`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inside {
    top: PathBuf,
    name: PathBuf,
}

impl Inside {
    /// The entry of this name in a folder. A name that leads out of the folder (`..`, an absolute path) is
    /// refused when the entry is used.
    #[must_use]
    pub fn of(top: &Path, name: impl AsRef<Path>) -> Self {
        Self { top: top.to_path_buf(), name: name.as_ref().to_path_buf() }
    }

    /// The entry at a path that the user has named: only its last part is looked at.
    #[must_use]
    pub fn at(path: &Path) -> Self {
        Self::of(path.parent().unwrap_or(Path::new("")), path.file_name().unwrap_or_default())
    }

    /// Path of the entry.
    #[must_use]
    pub fn path(&self) -> PathBuf {
        self.top.join(&self.name)
    }

    /// The entry of this name in the folder that this entry is.
    #[must_use]
    pub fn join(&self, name: impl AsRef<Path>) -> Self {
        Self { top: self.top.clone(), name: self.name.join(name) }
    }

    /// The entry of this name beside this one.
    #[must_use]
    pub fn beside(&self, name: impl AsRef<Path>) -> Self {
        Self { top: self.top.clone(), name: self.name.parent().unwrap_or(Path::new("")).join(name) }
    }

    /// The entry beside this one with an ending added to the name, such as `.part`.
    #[must_use]
    pub fn with_ending(&self, ending: &str) -> Self {
        let mut name = self.name.file_name().unwrap_or_default().to_os_string();
        name.push(ending);
        self.beside(name)
    }

    /// The last part of the name of the entry, without its extension.
    #[must_use]
    pub fn stem(&self) -> String {
        self.name.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Kind of the entry; `None` where there is none of this name.
    ///
    /// # Errors
    /// Where the entry, or a folder on the way to it, is a link, a pipe or a device.
    pub fn kind(&self) -> io::Result<Option<EntryKind>> {
        let found = self.parent().and_then(|(folder, name)| folder.kind(&name));
        match found {
            Ok(Some(kind)) => refused(kind).map(Some),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            other => other,
        }
    }

    /// Whether there is anything of this name, even what must not be used: opening it says why.
    #[must_use]
    pub fn exists(&self) -> bool {
        !matches!(self.kind(), Ok(None))
    }

    /// Whether the entry is a folder.
    #[must_use]
    pub fn is_folder(&self) -> bool {
        matches!(self.kind(), Ok(Some(EntryKind::Folder)))
    }

    /// Opens a file for reading.
    ///
    /// # Errors
    /// Where there is none, or the entry is not an ordinary file.
    pub fn open(&self) -> io::Result<File> {
        let (folder, name) = self.parent()?;
        expect_file(folder.kind(&name)?)?;
        ordinary(folder.open(&name)?).map(|(file, _)| file)
    }

    /// The content of a file of at most `most` bytes.
    ///
    /// # Errors
    /// As [`Inside::open`], and of a larger file.
    pub fn read(&self, most: u64) -> io::Result<Vec<u8>> {
        let file = self.open()?;
        let size = file.metadata()?.len();
        if size > most {
            return Err(io::Error::other(format!("it has {size} bytes, at most {most} are read")));
        }
        let mut content = Vec::new();
        content.try_reserve_exact(usize::try_from(size).unwrap_or(0))?;
        // It may grow meanwhile.
        file.take(most).read_to_end(&mut content)?;
        Ok(content)
    }

    /// Creates a file, or empties one. A file with several names (hard links) keeps its content under the
    /// others.
    ///
    /// # Errors
    /// Where the entry is anything but an ordinary file.
    pub fn create(&self) -> io::Result<File> {
        let (folder, name) = self.parent()?;
        let kind = folder.kind(&name)?;
        if kind.is_some() {
            expect_file(kind)?;
        }
        if let Some(EntryKind::File { names: 2.. }) = kind {
            folder.remove(&name)?;
        }
        let file = changeable(folder.create(&name)?)?;
        file.set_len(0)?;
        Ok(file)
    }

    /// Opens a file for reading and writing, which is created if there is none; it keeps what it holds.
    ///
    /// # Errors
    /// Where the entry is anything but an ordinary file, or has several names (hard links).
    pub fn open_or_create(&self) -> io::Result<File> {
        let (folder, name) = self.parent()?;
        let kind = folder.kind(&name)?;
        if kind.is_some() {
            expect_file(kind)?;
        }
        changeable(folder.create(&name)?)
    }

    /// Writes a whole file, or leaves what was there: under its name with an ending first, which is then
    /// renamed, so that neither a kill nor a full disk leaves half of one. Two processes that may write the
    /// same file need different endings.
    ///
    /// # Errors
    /// Where either entry cannot be created, written or renamed.
    pub fn write_whole(
        &self,
        ending: &str,
        write: impl FnOnce(&mut File) -> io::Result<()>,
    ) -> Result<(), FileError> {
        let named = |action, path| move |source| FileError { action, path, source };
        let draft = self.with_ending(ending);
        let mut file = draft.create().map_err(named("create", draft.path()))?;
        let written = write(&mut file).map_err(named("write", self.path()));
        drop(file);
        let done = written.and_then(|()| draft.rename(self).map_err(named("replace", self.path())));
        if done.is_err() {
            // On a full disk half a file would only take up space.
            let _ = draft.remove();
        }
        done
    }

    /// Moves the entry to another one, in place of a file that is there.
    ///
    /// # Errors
    /// Where it cannot be moved, or the other entry is anything but an ordinary file.
    pub fn rename(&self, to: &Self) -> io::Result<()> {
        let ((folder, name), (other, new)) = (self.parent()?, to.parent()?);
        let kind = other.kind(&new)?;
        if kind.is_some() {
            expect_file(kind)?;
        }
        folder.rename(&name, &other, &new)
    }

    /// Removes a file, if it is there. Of a link only the link goes.
    ///
    /// # Errors
    /// Where it cannot be removed, or is a folder.
    pub fn remove(&self) -> io::Result<()> {
        missing_is_fine(self.parent().and_then(|(folder, name)| match folder.kind(&name)? {
            Some(EntryKind::Folder) => expect_file(Some(EntryKind::Folder)),
            _ => folder.remove(&name),
        }))
    }

    /// Creates the folder, and those above it.
    ///
    /// # Errors
    /// Where an entry on the way is anything but a folder.
    pub fn make_folder(&self) -> io::Result<()> {
        std::fs::create_dir_all(named(&self.top))?;
        let mut folder = Opened::top(named(&self.top))?;
        for name in self.parts()? {
            if folder.kind(&name)?.is_none() {
                folder.make_folder(&name)?;
            }
            folder = step(&folder, &name)?;
        }
        Ok(())
    }

    /// Removes a folder that is empty.
    ///
    /// # Errors
    /// Where it is not.
    pub fn remove_folder(&self) -> io::Result<()> {
        let (folder, name) = self.parent()?;
        folder.remove_folder(&name)
    }

    /// The names of what a folder holds, in order; none of one that does not exist.
    ///
    /// # Errors
    /// Where it cannot be listed, or is no folder.
    pub fn names(&self) -> io::Result<Vec<OsString>> {
        match self.folder().and_then(|folder| folder.names()) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
            other => other,
        }
    }

    /// Flushes the entries of a folder to disk, where the system supports it.
    ///
    /// # Errors
    /// Where that fails.
    pub fn sync_folder(&self) -> io::Result<()> {
        self.folder()?.sync()
    }

    /// The way to the folder itself, for what works on a whole folder below this one.
    ///
    /// # Errors
    /// Where it, or a folder on the way to it, is there and is no folder.
    pub fn as_folder(&self) -> io::Result<PathBuf> {
        match self.folder() {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(self.path()),
        }
    }

    /// The parts of the name.
    fn parts(&self) -> io::Result<Vec<OsString>> {
        let parts = self.name.components().map(|part| match part {
            Component::Normal(part) => Ok(part.to_os_string()),
            _ => Err(io::Error::other(
                "its name leads out of the folder; take it from where it was made once more",
            )),
        });
        parts.collect()
    }

    /// The folder that holds it, and its name there.
    fn parent(&self) -> io::Result<(Opened, OsString)> {
        let mut parts = self.parts()?;
        let Some(name) = parts.pop() else { return Err(io::Error::other("it has no name")) };
        let mut folder = Opened::top(named(&self.top))?;
        for part in parts {
            folder = step(&folder, &part)?;
        }
        Ok((folder, name))
    }

    /// The folder that the entry is.
    fn folder(&self) -> io::Result<Opened> {
        let mut folder = Opened::top(named(&self.top))?;
        for part in self.parts()? {
            folder = step(&folder, &part)?;
        }
        Ok(folder)
    }
}

/// The current folder has an empty name in paths such as `case.toml`.
fn named(top: &Path) -> &Path {
    if top.as_os_str().is_empty() { Path::new(".") } else { top }
}

/// A folder in a folder.
fn step(folder: &Opened, name: &std::ffi::OsStr) -> io::Result<Opened> {
    let shown = name.to_string_lossy();
    match folder.kind(name)? {
        None => Err(no_such_file()),
        Some(EntryKind::Folder) => folder.folder_in(name),
        Some(other) => Err(forbidden(other, &format!("its folder {shown}"), "a folder")),
    }
}

/// What the system says of a file that is not there: 2 is ENOENT, and ERROR_FILE_NOT_FOUND.
fn no_such_file() -> io::Error {
    io::Error::from_raw_os_error(2)
}

fn expect_file(kind: Option<EntryKind>) -> io::Result<()> {
    match kind {
        None => Err(no_such_file()),
        Some(EntryKind::File { .. }) => Ok(()),
        Some(other) => Err(forbidden(other, "it", "an ordinary file")),
    }
}

/// An open file that is an ordinary one, and how many names it has: the entry may have been exchanged since
/// it was looked at.
fn ordinary(file: File) -> io::Result<(File, u64)> {
    match system::kind_of(&file)? {
        EntryKind::File { names } => Ok((file, names)),
        other => Err(forbidden(other, "it", "an ordinary file")),
    }
}

/// An open file that may be changed: no other name leads to it.
fn changeable(file: File) -> io::Result<File> {
    match ordinary(file)? {
        (file, 0..=1) => Ok(file),
        _ => Err(io::Error::other(
            "it has a second name elsewhere (a hard link), which would change too; replace it by a copy of itself",
        )),
    }
}

fn missing_is_fine(done: io::Result<()>) -> io::Result<()> {
    match done {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        other => other,
    }
}

#[cfg(all(test, unix))]
mod tests;
