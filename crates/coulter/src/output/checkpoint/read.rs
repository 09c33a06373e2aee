//! Reading a checkpoint back.

use super::contents::{Checkpoint, MAGIC, VERSION};
use super::paths::{path, previous_path};
use crate::output::files::OutputError;
use solver::precision::Precision;
use std::fs;
use std::path::Path;
use xxhash_rust::xxh3::xxh3_64;

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
        let previous = previous_path(dir);
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
