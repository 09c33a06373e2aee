//! The lock of a results folder: one run at a time can use it.
//!
//! The lock is the operating system's lock on a file, which ends with the process that holds it: a killed run
//! leaves the file behind, but not the lock. The file names its owner, for information.

use crate::files::{Inside, Named, OutputError, make_folder};
use std::fs::{File, TryLockError};
use std::io::{Read, Write};
use std::path::Path;

/// Name of the file.
pub(super) const LOCK: &str = "run.lock";

/// A lock that is held; dropping it releases it and removes its file.
#[derive(Debug)]
pub struct Lock {
    entry: Inside,
    // Open as long as the lock is held.
    file: File,
}

impl Lock {
    /// Takes the lock of a results folder, which is created if it does not exist.
    ///
    /// # Errors
    /// [`OutputError::Busy`] when another run holds it, or the file cannot be written.
    pub fn take(dir: &Path) -> Result<Self, OutputError> {
        make_folder(&Inside::of(dir, ""))?;
        let entry = Inside::of(dir, LOCK);
        let path = entry.path();
        loop {
            let mut file = entry.open_or_create().named("open", &path)?;
            match file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    let mut holder = String::new();
                    // The name of the owner is optional.
                    let _ = file.read_to_string(&mut holder);
                    return Err(OutputError::Busy {
                        path: dir.to_path_buf(),
                        holder: holder.trim().to_owned(),
                    });
                }
                // A file system without locks (some network ones): run without one.
                Err(TryLockError::Error(error)) if error.kind() == std::io::ErrorKind::Unsupported => {}
                Err(TryLockError::Error(error)) => return Err(error).named("lock", &path),
            }
            // The previous holder may have removed the file between our opening and locking it.
            if is_at(&file, &entry) {
                file.set_len(0).named("write", &path)?;
                file.write_all(holder().as_bytes()).named("write", &path)?;
                return Ok(Self { entry, file });
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // A file that remains is not a lock; nothing depends on its removal.
        let _ = self.entry.remove();
        let _ = self.file.unlock();
    }
}

/// Process and time, for the message about the lock.
fn holder() -> String {
    let since = super::log::stamp(std::time::SystemTime::now());
    format!("process {}, since {since}\n", std::process::id())
}

/// Whether a path still refers to this open file.
#[cfg(unix)]
fn is_at(file: &File, entry: &Inside) -> bool {
    use std::os::unix::fs::MetadataExt;
    let number = |file: &File| file.metadata().ok().map(|about| (about.dev(), about.ino()));
    entry.open().is_ok_and(|there| number(&there) == number(file))
}

/// An open file cannot be removed here (untested).
#[cfg(not(unix))]
fn is_at(_: &File, entry: &Inside) -> bool {
    entry.exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_at_a_time_and_a_leftover_file_is_no_lock() {
        let dir = tempfile::tempdir().unwrap();
        std::fs::write(dir.path().join(LOCK), "process 1, since long ago\n").unwrap();
        let lock = Lock::take(dir.path()).unwrap();
        let refusal = Lock::take(dir.path()).unwrap_err().to_string();
        assert!(refusal.contains(&format!("process {}", std::process::id())), "{refusal}");
        drop(lock);
        assert!(!dir.path().join(LOCK).exists());
        drop(Lock::take(dir.path()).unwrap());
    }
}
