//! Reading a checkpoint back.

use super::contents::{Checkpoint, MAGIC, VERSION};
use super::layout;
use super::paths::{IN_MEMORY, last, previous};
use crate::files::{Inside, OutputError};
use case::machine;
use solver::grid::Grid;
use solver::portion::Portion;
use solver::precision::Precision;
use std::cmp::Ordering;
use std::io::{self, Read};
use std::ops::Range;
use std::path::Path;
use xxhash_rust::xxh3::xxh3_64;

impl<R: Precision> Checkpoint<R> {
    /// Reads the last checkpoint of a results folder or, where that is not whole, the one before; with what
    /// is wrong with the last one in that case. The state is that on a `grid`, or on the block that this is.
    ///
    /// # Errors
    /// When there is none, or none is whole, or it was written by another version or in another precision.
    pub fn read(dir: &Path, grid: &Grid) -> Result<(Self, Option<OutputError>), OutputError> {
        let last = match Self::read_last(dir, grid) {
            Ok(checkpoint) => return Ok((checkpoint, None)),
            Err(error) => error,
        };
        if !previous(dir).exists() {
            return Err(last);
        }
        Self::read_previous(dir, grid).map(|checkpoint| (checkpoint, Some(last)))
    }

    /// Reads the last checkpoint alone.
    ///
    /// # Errors
    /// As [`Checkpoint::read`].
    pub fn read_last(dir: &Path, grid: &Grid) -> Result<Self, OutputError> {
        Self::read_file(&last(dir), grid)
    }

    /// Reads the checkpoint before the last.
    ///
    /// # Errors
    /// As [`Checkpoint::read`].
    pub fn read_previous(dir: &Path, grid: &Grid) -> Result<Self, OutputError> {
        Self::read_file(&previous(dir), grid)
    }

    fn read_file(file: &Inside, grid: &Grid) -> Result<Self, OutputError> {
        let (plain, _) = read_record(file)?;
        let checkpoint = Self::of_record(&plain, &file.path(), grid)?;
        drop(plain);
        checkpoint.with_portions(file, grid)
    }

    /// The checkpoint in bytes that [`CheckpointView::to_bytes`](super::CheckpointView::to_bytes) has made.
    ///
    /// # Errors
    /// As [`Checkpoint::read`].
    pub fn of_bytes(bytes: &[u8], grid: &Grid) -> Result<Self, OutputError> {
        let path = Path::new(IN_MEMORY);
        let (plain, _) = record_in(bytes, path)?;
        let checkpoint = Self::of_record(&plain, path, grid)?;
        if checkpoint.portions.is_empty() {
            return Ok(checkpoint);
        }
        Err(OutputError::content(path, "its soil is in files of its own"))
    }

    /// The checkpoint of a record; without soil where that is in files of its own.
    fn of_record(plain: &[u8], path: &Path, grid: &Grid) -> Result<Self, OutputError> {
        let broken = |what: &str| OutputError::content(path, what);
        let unreadable = |e: postcard::Error| broken(&format!("cannot be read: {e}"));
        let (precision, _) = postcard::take_from_bytes::<String>(plain).map_err(unreadable)?;
        if precision != R::NAME {
            let wanted = R::NAME;
            return Err(broken(&format!(
                "the checkpoint is in {precision} precision, the case asks for {wanted}"
            )));
        }
        let mut checkpoint: Self = postcard::from_bytes(plain).map_err(unreadable)?;
        let entries = if checkpoint.portions.is_empty() { grid.uncut().entries } else { 1 };
        if !checkpoint.state.has_entries(entries) {
            return Err(broken("its soil is not that of the grid"));
        }
        if checkpoint.portions.is_empty() && !grid.is_whole() {
            checkpoint.state = checkpoint.state.of_block(&grid.uncut(), grid);
        }
        Ok(checkpoint)
    }

    /// The checkpoint with the soil that lies in files of its own, if it does.
    fn with_portions(mut self, file: &Inside, grid: &Grid) -> Result<Self, OutputError> {
        if self.portions.is_empty() {
            return Ok(self);
        }
        self.state = self.state.without_soil(grid);
        for named in &self.portions {
            if grid.held_of(&named.layers).iter().any(Range::is_empty) {
                continue;
            }
            let beside = file.beside(&named.name);
            let wrong = |what: &str| OutputError::content(&beside.path(), what);
            let (plain, hash) = read_record(&beside)?;
            if hash != named.hash {
                return Err(wrong("it belongs to another checkpoint"));
            }
            let portion: Portion<R> =
                postcard::from_bytes(&plain).map_err(|e| wrong(&format!("cannot be read: {e}")))?;
            if portion.layers != named.layers || !portion.is_of(&self.state, grid) {
                return Err(wrong("it does not hold what the checkpoint says"));
            }
            self.state.put(grid, &portion);
        }
        Ok(self)
    }
}

/// The record of a file, unpacked, and its hash.
fn read_record(from: &Inside) -> Result<(Vec<u8>, u64), OutputError> {
    let path = from.path();
    let unread = |e: io::Error| OutputError::content(&path, format!("no checkpoint to resume from ({e})"));
    record_in(&from.read(most_bytes()).map_err(unread)?, &path)
}

/// The record in the contents of a file of this path, unpacked, and its hash.
fn record_in(file: &[u8], path: &Path) -> Result<(Vec<u8>, u64), OutputError> {
    let broken = |what: &str| OutputError::content(path, what);
    let header = file.split_first_chunk::<8>().filter(|(magic, _)| magic.starts_with(MAGIC));
    let Some((magic, rest)) = header else { return Err(broken("not a Coulter checkpoint")) };
    check_version(magic[7]).map_err(|problem| broken(&problem))?;
    let parts =
        rest.split_first_chunk::<8>().and_then(|(own, rest)| Some((own, rest.split_last_chunk::<8>()?)));
    let Some((layout, (packed, hash))) = parts else {
        return Err(broken("the checkpoint is cut off"));
    };
    if *layout != layout::hash() {
        return Err(broken(OTHER_LAYOUT));
    }
    let found = xxh3_64(packed);
    if found.to_le_bytes() != *hash {
        return Err(broken("the checkpoint is damaged (its hash is wrong)"));
    }
    let plain = unpacked(packed, most_bytes()).map_err(|e| broken(&e.to_string()))?;
    Ok((plain, found))
}

/// Largest record that is unpacked [bytes]: the state that is read from it takes as much memory again.
fn most_bytes() -> u64 {
    machine::memory_available().map_or(u64::MAX, |bytes| (0.5 * bytes) as u64)
}

/// Unpacks a record of at most `most` bytes: a few bytes of a forged file may say that they stand for any
/// number.
fn unpacked(packed: &[u8], most: u64) -> io::Result<Vec<u8>> {
    let mut plain = Vec::new();
    zstd::Decoder::new(packed)?.take(most.saturating_add(1)).read_to_end(&mut plain)?;
    if plain.len() as u64 > most {
        return Err(io::Error::other("its contents need more memory than is free"));
    }
    Ok(plain)
}

/// What is said of a checkpoint whose types have other fields.
const OTHER_LAYOUT: &str = "written by another version of Coulter, whose checkpoints hold other quantities; finish the run with that one";

/// Whether a checkpoint of this version can be read; if not, what to do.
fn check_version(found: u8) -> Result<(), String> {
    let [other, known] = [found, VERSION].map(u8::escape_ascii);
    let why = |age: &str, cure: &str| {
        Err(format!(
            "written by {age} version of Coulter (format {other} of checkpoints; this one reads {known}); {cure}"
        ))
    };
    match found.cmp(&VERSION) {
        Ordering::Equal => Ok(()),
        Ordering::Greater => why("a newer", "install that to resume the run"),
        Ordering::Less => why("an older", "finish the run with that one"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_is_unpacked_than_fits() {
        let packed = zstd::encode_all(&[0_u8; 1 << 20][..], 1).unwrap();
        assert_eq!(unpacked(&packed, 1 << 20).unwrap().len(), 1 << 20);
        assert!(unpacked(&packed, (1 << 20) - 1).unwrap_err().to_string().contains("memory"));
        assert!(unpacked(&packed[..packed.len() / 2], 1 << 20).is_err());
    }

    #[test]
    fn another_version_is_refused_with_what_to_do() {
        assert_eq!(check_version(VERSION), Ok(()));
        let [older, newer] = [VERSION - 1, VERSION + 1].map(|version| check_version(version).unwrap_err());
        assert!(older.contains("an older version") && older.contains("finish"), "{older}");
        assert!(newer.contains("a newer version") && newer.contains("install"), "{newer}");
    }

    #[test]
    fn another_layout_is_refused_before_its_contents_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let record = |layout: [u8; 8]| {
            let file = Inside::of(folder.path(), "checkpoint");
            let text = [&MAGIC[..], &[VERSION], &layout, &xxh3_64(b"").to_le_bytes()].concat();
            std::fs::write(file.path(), text).unwrap();
            read_record(&file).map(|_| ()).unwrap_err().to_string()
        };
        assert!(record([0; 8]).contains("other quantities"), "{}", record([0; 8]));
        assert!(!record(layout::hash()).contains("other quantities"));
    }
}
