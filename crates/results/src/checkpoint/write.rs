//! Writing a checkpoint.

use super::contents::{CheckpointView, MAGIC, PortionFile, Record, VERSION};
use super::layout;
use super::paths::{IN_MEMORY, failed, last, portion_name, previous, remove_old_portions};
use crate::files::{CHECKPOINTS, Inside, Named, OutputError, make_folder};
use serde::Serialize;
use solver::precision::Precision;
use std::io::{self, BufWriter, IntoInnerError, Write};
use std::path::Path;
use xxhash_rust::xxh3::Xxh3;

/// Level 1 is as fast as the disc.
const LEVEL: i32 = 1;

impl<R: Precision> CheckpointView<'_, R> {
    /// Writes the last checkpoint of a results folder and keeps the one before. All blocks of a grid must
    /// call this: each writes its soil and nodes, and when all have, the first the rest; until then the last
    /// checkpoint is the one before.
    ///
    /// # Errors
    /// When a file cannot be written; the checkpoints that are there stay.
    pub fn write(&self, dir: &Path) -> Result<(), OutputError> {
        let (last, previous) = (last(dir), previous(dir));
        self.write_to(dir, &last, || {
            if last.exists() { last.rename(&previous).named("replace", &previous.path()) } else { Ok(()) }
        })?;
        if self.is_first() { remove_old_portions(dir, self.state.step) } else { Ok(()) }
    }

    /// Writes the state of a run that broke down, next to the last good checkpoints.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn write_failed(&self, dir: &Path) -> Result<(), OutputError> {
        self.write_to(dir, &failed(dir), || Ok(()))
    }

    /// The checkpoint of a run in one process as bytes, for
    /// [`Checkpoint::of_bytes`](super::Checkpoint::of_bytes).
    ///
    /// # Errors
    /// Where memory does not suffice.
    pub fn to_bytes(&self) -> Result<Vec<u8>, OutputError> {
        let Self { precision, case, state, history, last_sample, .. } = self;
        let record = Record { precision, case, state, portions: &[], history, last_sample };
        write_content(Vec::new(), &record, Path::new(IN_MEMORY)).map(|(bytes, _)| bytes)
    }

    fn is_first(&self) -> bool {
        self.block.1.rank() == 0
    }

    fn write_to(
        &self,
        dir: &Path,
        file: &Inside,
        make_room: impl FnOnce() -> Result<(), OutputError>,
    ) -> Result<(), OutputError> {
        let portions = self.write_portion(dir)?;
        if !self.is_first() {
            return Ok(());
        }
        let without_soil;
        let mut state = self.state;
        if !portions.is_empty() {
            without_soil = self.state.without_fields();
            state = &without_soil;
        }
        let Self { precision, case, history, last_sample, .. } = self;
        let record = Record { precision, case, state, portions: &portions, history, last_sample };
        write_file(file, &record, make_room).map(|_| ())
    }

    /// Writes soil and nodes of a block; returns the files of all, in the first block. Nothing where there is
    /// only one.
    fn write_portion(&self, dir: &Path) -> Result<Vec<PortionFile>, OutputError> {
        let (grid, halo) = self.block;
        if halo.is_alone() {
            return Ok(Vec::new());
        }
        let name = |rank: usize| portion_name(self.state.step, [rank, halo.blocks()]);
        let layers = [0, 1, 2].map(|axis| grid.accounted(axis));
        let file = Inside::of(dir, CHECKPOINTS).join(name(halo.rank()));
        let hash = write_file(&file, &self.state.portion(grid, layers.clone()), || Ok(()))?;
        let own = layers.iter().flat_map(|own| [own.start as f64, own.end as f64]);
        let halves = [(hash >> 32) as f64, (hash & u64::from(u32::MAX)) as f64];
        let all = halo.collect(own.chain(halves).collect());
        let file = |(rank, numbers): (usize, &Vec<f64>)| PortionFile {
            name: name(rank),
            layers: std::array::from_fn(|axis| numbers[2 * axis] as usize..numbers[2 * axis + 1] as usize),
            hash: ((numbers[6] as u64) << 32) | numbers[7] as u64,
        };
        Ok(all.iter().enumerate().map(file).collect())
    }
}

/// Writes a record next to `file`, makes room and moves it there; returns its hash.
fn write_file(
    file: &Inside,
    record: &impl Serialize,
    make_room: impl FnOnce() -> Result<(), OutputError>,
) -> Result<u64, OutputError> {
    let (folder, path) = (file.beside(""), file.path());
    make_folder(&folder)?;
    let part = file.beside(format!("{}.checkpoint.part", file.stem()));
    let written = write_part(&part, record).and_then(|hash| make_room().map(|()| hash));
    let hash = match written {
        Ok(hash) => hash,
        Err(error) => {
            // What could not be written whole is of no use; that it cannot be removed either is no news.
            let _ = part.remove();
            return Err(error);
        }
    };
    part.rename(file).named("replace", &path)?;
    folder.sync_folder().named("write", &folder.path())?;
    Ok(hash)
}

fn write_part(draft: &Inside, record: &impl Serialize) -> Result<u64, OutputError> {
    let part = &*draft.path();
    let file = draft.create().named("create", part)?;
    let (out, hash) = write_content(BufWriter::with_capacity(1 << 20, file), record, part)?;
    let file = out.into_inner().map_err(IntoInnerError::into_error).named("write", part)?;
    file.sync_all().named("write", part)?;
    Ok(hash)
}

/// Writes what a file of this path holds; returns its hash.
fn write_content<W: Write>(
    mut out: W,
    record: &impl Serialize,
    path: &Path,
) -> Result<(W, u64), OutputError> {
    out.write_all(&[&MAGIC[..], &[VERSION], &layout::hash()].concat()).named("write", path)?;
    let mut hashed = Hashed { out, hash: Xxh3::new(), failure: None };
    pack(record, &mut hashed, path)?;
    let Hashed { mut out, hash, .. } = hashed;
    let hash = hash.digest();
    out.write_all(&hash.to_le_bytes()).named("write", path)?;
    Ok((out, hash))
}

/// Packs a record; a full disc is called by its name.
fn pack(record: &impl Serialize, hashed: &mut Hashed<impl Write>, part: &Path) -> Result<(), OutputError> {
    let encoder = zstd::Encoder::new(&mut *hashed, LEVEL).named("write", part)?;
    // Numbers come one by one.
    let buffer = BufWriter::with_capacity(1 << 16, encoder);
    let packed = match postcard::to_io(record, buffer) {
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
