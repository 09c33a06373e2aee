//! The lock of a results folder: one run at a time works in it.
//!
//! It is the operating system's lock on a file, which goes with the process that holds it: what a killed run leaves behind
//! is a file that nobody holds, and that is no lock. The file says who made it, for people.

use super::error::{Named, OutputError, make_folder};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// Name of the file.
pub(super) const LOCK: &str = "run.lock";

/// A lock that is held; dropped, it is given up and its file removed.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    // Held open for as long as the lock is.
    file: File,
}

impl Lock {
    /// Takes the lock of a results folder, which is made if it is not there.
    ///
    /// # Errors
    /// [`OutputError::Busy`] when another run holds it, or the file cannot be written.
    pub fn take(dir: &Path) -> Result<Self, OutputError> {
        make_folder(dir)?;
        let path = dir.join(LOCK);
        loop {
            let mut options = OpenOptions::new();
            let mut file = options
                .read(true)
                .write(true)
                .create(true)
                .truncate(false)
                .open(&path)
                .named("open", &path)?;
            match file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    let mut holder = String::new();
                    // Who it is matters less than that it is.
                    let _ = file.read_to_string(&mut holder);
                    return Err(OutputError::Busy {
                        path: dir.to_path_buf(),
                        holder: holder.trim().to_owned(),
                    });
                }
                // A file system without locks (some network ones): better unlocked than not at all.
                Err(TryLockError::Error(error)) if error.kind() == std::io::ErrorKind::Unsupported => {}
                Err(TryLockError::Error(error)) => return Err(error).named("lock", &path),
            }
            // The holder before may have removed the file between our opening and locking it.
            if is_at(&file, &path) {
                file.set_len(0).named("write", &path)?;
                file.write_all(holder().as_bytes()).named("write", &path)?;
                return Ok(Self { path, file });
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // A file that stays is no lock; nothing depends on its removal.
        let _ = fs::remove_file(&self.path);
        let _ = self.file.unlock();
    }
}

/// Process and time, for whoever meets the lock.
fn holder() -> String {
    let since = super::log::stamp(std::time::SystemTime::now());
    format!("process {}, since {since}\n", std::process::id())
}

/// Whether a path still leads to this open file.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |a: &fs::Metadata, b: &fs::Metadata| a.dev() == b.dev() && a.ino() == b.ino();
    file.metadata().ok().zip(fs::metadata(path).ok()).is_some_and(|(a, b)| same(&a, &b))
}

/// An open file cannot be removed here (untested).
#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.is_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_at_a_time_and_what_is_left_behind_is_no_lock() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join(LOCK), "process 1, since long ago\n").unwrap();
        let lock = Lock::take(dir.path()).unwrap();
        let refusal = Lock::take(dir.path()).unwrap_err().to_string();
        assert!(refusal.contains(&format!("process {}", std::process::id())), "{refusal}");
        drop(lock);
        assert!(!dir.path().join(LOCK).exists());
        drop(Lock::take(dir.path()).unwrap());
    }
}
