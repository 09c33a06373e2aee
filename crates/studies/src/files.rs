//! Reading and writing of files, whole or not at all: the only file of this crate that touches any.

use coulter::output::{FileError, Inside};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Names the file in an error of the system.
fn named<T>(result: io::Result<T>, action: &'static str, path: &Path) -> Result<T, FileError> {
    result.map_err(|source| FileError { action, path: path.to_path_buf(), source })
}

/// The content of an ordinary file that the user has named; one of more than `most` bytes, a folder or a pipe
/// is refused.
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

/// The content of an entry of a folder.
///
/// # Errors
/// [`FileError`] where it cannot be read, has more than `most` bytes or is not an ordinary file.
pub fn read_inside(from: &Inside, most: u64) -> Result<Vec<u8>, FileError> {
    named(from.read(most), "read", &from.path())
}

/// Writes a whole file, so that neither a kill nor another process that writes the same file leaves half of
/// one.
///
/// # Errors
/// [`FileError`] where it cannot be written.
pub fn write(to: &Inside, content: &[u8]) -> Result<(), FileError> {
    write_with(to, |file| file.write_all(content))
}

/// Writes a whole file as a stream, like [`write`].
///
/// # Errors
/// [`FileError`] where it cannot be written.
pub fn write_with(
    to: &Inside,
    write: impl FnOnce(&mut BufWriter<&mut File>) -> io::Result<()>,
) -> Result<(), FileError> {
    let done = to.write_whole(&format!(".{}.part", std::process::id()), |file| {
        let mut file = BufWriter::new(file);
        write(&mut file).and_then(|()| file.flush())
    });
    named(done.map_err(|error| error.source), "write", &to.path())
}

/// Creates a folder and its parents.
///
/// # Errors
/// [`FileError`] where that is not possible.
pub fn make_folder(at: &Inside) -> Result<(), FileError> {
    named(at.make_folder(), "create the folder", &at.path())
}

/// The way to a folder inside another one.
///
/// # Errors
/// [`FileError`] where it is there and is a link or no folder.
pub fn folder(at: &Inside) -> Result<PathBuf, FileError> {
    named(at.as_folder(), "use the folder", &at.path())
}

/// Whether a folder holds anything.
///
/// # Errors
/// [`FileError`] where it is a file, or cannot be read.
pub fn is_used(folder: &Path) -> Result<bool, FileError> {
    named(Inside::of(folder, "").names(), "read", folder).map(|names| !names.is_empty())
}

/// The names of the files in a folder, in order.
///
/// # Errors
/// [`FileError`] where it cannot be read.
pub fn names(folder: &Inside) -> Result<Vec<String>, FileError> {
    let names = named(folder.names(), "read", &folder.path())?;
    Ok(names.iter().map(|name| name.to_string_lossy().into_owned()).collect())
}

/// Removes a file, if it is there.
pub fn forget(file: &Inside) {
    let _ = file.remove();
}
