//! Checkpoints: everything that changes, so that a run can resume as if it had never stopped.
//!
//! A file holds a magic word with the version of its contents, a compressed record of the state, the history and the case
//! that they belong to, and at its end the hash of the compressed record. It is written next to the last one, synced to
//! disk and then moved over it; the last becomes the one before. A kill at any time leaves one whole.

use super::error::{Named, OutputError, make_folder, sync_folder};
use super::folder::CHECKPOINTS;
use crate::history::History;
use serde::{Deserialize, Serialize};
use solver::precision::Precision;
use solver::state::{ContactImpulse, State};
use std::fs::{self, File};
use std::io::{self, BufWriter, IntoInnerError, Write};
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// What every checkpoint begins with.
const MAGIC: &[u8; 7] = b"COULTER";
/// Version of what follows; a checkpoint of another version cannot be resumed.
const VERSION: u8 = b'7';
const LAST: &str = "last.checkpoint";
const PREVIOUS: &str = "previous.checkpoint";
const FAILED: &str = "failed.checkpoint";
/// Level 1 is as fast as the disc.
const LEVEL: i32 = 1;

/// What a checkpoint holds.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Checkpoint<R = f64> {
    /// Name of the precision of its fields. It stands first, so that it can be read whatever it is.
    pub precision: String,
    /// The resolved case, as text; a run must not resume with another.
    pub case: String,
    /// The state of the solver.
    pub state: State<R>,
    /// The history so far.
    pub history: History,
    /// Time and impulses at the last sample.
    pub sampled: (f64, Vec<ContactImpulse>),
}

/// The same, borrowed from a run that continues.
#[derive(Clone, Debug, Serialize)]
pub struct CheckpointView<'a, R> {
    /// Name of the precision of its fields.
    pub precision: &'static str,
    /// The resolved case, as text.
    pub case: String,
    /// The state of the solver.
    pub state: &'a State<R>,
    /// The history so far.
    pub history: &'a History,
    /// Time and impulses at the last sample.
    pub sampled: &'a (f64, Vec<ContactImpulse>),
}

/// Path of the last checkpoint of a results folder.
#[must_use]
pub fn path(dir: &Path) -> PathBuf {
    dir.join(CHECKPOINTS).join(LAST)
}

/// Whether a results folder has a checkpoint to resume from.
#[must_use]
pub fn exists(dir: &Path) -> bool {
    [LAST, PREVIOUS].iter().any(|name| dir.join(CHECKPOINTS).join(name).is_file())
}

/// Removes the last checkpoint: a damaged one must not replace the one before.
///
/// # Errors
/// When it is there and cannot be removed.
pub fn forget_last(dir: &Path) -> Result<(), OutputError> {
    let path = path(dir);
    if path.is_file() { fs::remove_file(&path).named("remove", &path) } else { Ok(()) }
}

/// Removes the checkpoint before the last: a run that has come to its end needs no other to fall back on.
///
/// # Errors
/// When it is there and cannot be removed.
pub fn forget_previous(dir: &Path) -> Result<(), OutputError> {
    let path = dir.join(CHECKPOINTS).join(PREVIOUS);
    if path.is_file() { fs::remove_file(&path).named("remove", &path) } else { Ok(()) }
}

impl<R: Precision> CheckpointView<'_, R> {
    /// The same, owned.
    #[must_use]
    pub fn kept(&self) -> Checkpoint<R> {
        Checkpoint {
            precision: self.precision.to_owned(),
            case: self.case.clone(),
            state: self.state.clone(),
            history: self.history.clone(),
            sampled: self.sampled.clone(),
        }
    }

    /// Writes the last checkpoint of a results folder and keeps the one before; returns its path.
    ///
    /// # Errors
    /// When the file cannot be written; the checkpoints that are there stay.
    pub fn write(&self, dir: &Path) -> Result<PathBuf, OutputError> {
        let (path, previous) = (path(dir), dir.join(CHECKPOINTS).join(PREVIOUS));
        self.write_to(dir, &path, || {
            if path.is_file() { fs::rename(&path, &previous).named("replace", &previous) } else { Ok(()) }
        })?;
        Ok(path)
    }

    /// Writes the state of a run that broke down, next to the last good checkpoints; returns its path.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_failed(&self, dir: &Path) -> Result<PathBuf, OutputError> {
        let path = dir.join(CHECKPOINTS).join(FAILED);
        self.write_to(dir, &path, || Ok(()))?;
        Ok(path)
    }

    /// Writes the file next to `path`, makes room and moves it there.
    fn write_to(
        &self,
        dir: &Path,
        path: &Path,
        make_room: impl FnOnce() -> Result<(), OutputError>,
    ) -> Result<(), OutputError> {
        let folder = dir.join(CHECKPOINTS);
        make_folder(&folder)?;
        let part = path.with_extension("checkpoint.part");
        let written = self.write_part(&part).and_then(|()| make_room());
        if let Err(error) = written {
            // What could not be written whole is of no use; that it cannot be removed either is no news.
            let _ = fs::remove_file(&part);
            return Err(error);
        }
        fs::rename(&part, path).named("replace", path)?;
        sync_folder(&folder)
    }

    fn write_part(&self, part: &Path) -> Result<(), OutputError> {
        let file = File::create(part).named("create", part)?;
        let mut out = BufWriter::with_capacity(1 << 20, file);
        out.write_all(MAGIC).and_then(|()| out.write_all(&[VERSION])).named("write", part)?;
        let mut hashed = Hashed { out, hash: Xxh3::new(), failure: None };
        self.pack(&mut hashed, part)?;
        let Hashed { mut out, hash, .. } = hashed;
        out.write_all(&hash.digest().to_le_bytes()).named("write", part)?;
        let file = out.into_inner().map_err(IntoInnerError::into_error).named("write", part)?;
        file.sync_all().named("write", part)
    }

    /// Packs the record; a full disc is called by its name.
    fn pack(&self, hashed: &mut Hashed<impl Write>, part: &Path) -> Result<(), OutputError> {
        let encoder = zstd::Encoder::new(&mut *hashed, LEVEL).named("write", part)?;
        // Numbers come one by one.
        let buffer = BufWriter::with_capacity(1 << 16, encoder);
        let packed = match postcard::to_io(self, buffer) {
            Ok(buffer) => {
                let encoder = buffer.into_inner().map_err(IntoInnerError::into_error);
                encoder.and_then(|encoder| encoder.finish().map(drop)).named("write", part)
            }
            Err(error) => Err(OutputError::content(part, error)),
        };
        // What the operating system said has more to tell.
        packed.or_else(|error| {
            hashed.failure.take().map_or(Err(error), |failure| Err(failure).named("write", part))
        })
    }
}

/// Passes on what is written and keeps its hash.
struct Hashed<W> {
    out: W,
    hash: Xxh3,
    /// What the operating system said; those who write through this may forget it.
    failure: Option<io::Error>,
}

impl<W: Write> Write for Hashed<W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let count = self.out.write(bytes).inspect_err(|error| self.failure = Some(same(error)))?;
        self.hash.update(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.out.flush().inspect_err(|error| self.failure = Some(same(error)))
    }
}

/// The error once more.
fn same(error: &io::Error) -> io::Error {
    error.raw_os_error().map_or_else(|| error.kind().into(), io::Error::from_raw_os_error)
}

impl<R: Precision> Checkpoint<R> {
    /// Reads the last checkpoint of a results folder or, where that is not whole, the one before; with what is wrong with the
    /// last one in that case.
    ///
    /// # Errors
    /// When there is none, or none is whole, or it was written by another version or in another precision.
    pub fn read(dir: &Path) -> Result<(Self, Option<OutputError>), OutputError> {
        let last = match Self::read_file(&path(dir)) {
            Ok(checkpoint) => return Ok((checkpoint, None)),
            Err(error) => error,
        };
        let previous = dir.join(CHECKPOINTS).join(PREVIOUS);
        if !previous.is_file() {
            return Err(last);
        }
        Self::read_file(&previous).map(|checkpoint| (checkpoint, Some(last)))
    }

    fn read_file(path: &Path) -> Result<Self, OutputError> {
        let broken = |what: &str| OutputError::content(path, what);
        let file = fs::read(path).map_err(|e| broken(&format!("no checkpoint to resume from ({e})")))?;
        let header = file.split_first_chunk::<8>().filter(|(magic, _)| magic.starts_with(MAGIC));
        let Some((magic, rest)) = header else { return Err(broken("not a Coulter checkpoint")) };
        if magic[7] != VERSION {
            return Err(broken(
                "written by another version of Coulter, which stores checkpoints in another way",
            ));
        }
        let Some((packed, hash)) = rest.split_last_chunk::<8>() else {
            return Err(broken("the checkpoint is cut off"));
        };
        if xxh3_64(packed).to_le_bytes() != *hash {
            return Err(broken("the checkpoint is damaged (its hash is wrong)"));
        }
        let plain = zstd::decode_all(packed).map_err(|e| broken(&e.to_string()))?;
        let unreadable = |e: postcard::Error| broken(&format!("cannot be read: {e}"));
        let (precision, _) = postcard::take_from_bytes::<String>(&plain).map_err(unreadable)?;
        if precision != R::NAME {
            let wanted = R::NAME;
            return Err(broken(&format!(
                "the checkpoint is in {precision} precision, the case asks for {wanted}"
            )));
        }
        postcard::from_bytes(&plain).map_err(unreadable)
    }
}
