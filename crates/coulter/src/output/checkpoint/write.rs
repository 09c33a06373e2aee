//! Writing a checkpoint.

use super::contents::{CheckpointView, MAGIC, VERSION};
use super::paths::{failed_path, path, previous_path};
use crate::output::files::{CHECKPOINTS, Named, OutputError, make_folder, sync_folder};
use solver::precision::Precision;
use std::fs::{self, File};
use std::io::{self, BufWriter, IntoInnerError, Write};
use std::path::Path;
use xxhash_rust::xxh3::Xxh3;

/// Level 1 is as fast as the disc.
const LEVEL: i32 = 1;

impl<R: Precision> CheckpointView<'_, R> {
    /// Writes the last checkpoint of a results folder and keeps the one before.
    ///
    /// # Errors
    /// When the file cannot be written; the checkpoints that are there stay.
    pub fn write(&self, dir: &Path) -> Result<(), OutputError> {
        let (path, previous) = (path(dir), previous_path(dir));
        self.write_to(dir, &path, || {
            if path.is_file() { fs::rename(&path, &previous).named("replace", &previous) } else { Ok(()) }
        })
    }

    /// Writes the state of a run that broke down, next to the last good checkpoints.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_failed(&self, dir: &Path) -> Result<(), OutputError> {
        self.write_to(dir, &failed_path(dir), || Ok(()))
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
