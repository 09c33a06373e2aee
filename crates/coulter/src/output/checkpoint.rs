//! Checkpoints: everything that changes, so that a run can go on as if it had never stopped.
//!
//! A file holds a magic word, the hash of what follows, and a compressed record of the state, the history and the case
//! that they belong to. It is written beside the old one and then moved over it: a kill at any time leaves one whole.

use super::error::{OutputError, make_folder, write_whole};
use super::folder::CHECKPOINTS;
use super::record::History;
use serde::{Deserialize, Serialize};
use solver::precision::Precision;
use solver::state::{Received, State};
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::xxh3_64;

const MAGIC: &[u8; 8] = b"COULTER3";
const FILE: &str = "last.checkpoint";
/// Level 1 is as fast as the disc.
const LEVEL: i32 = 1;

/// What a checkpoint holds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint<R = f64> {
    /// Name of the precision of its fields. It stands first, so that it can be read whatever it is.
    pub precision: String,
    /// The resolved case, as text; a run must not go on with another.
    pub case: String,
    /// The state of the solver.
    pub state: State<R>,
    /// The history so far.
    pub history: History,
    /// Time and impulses at the last sample.
    pub sampled: (f64, Vec<Received>),
    /// Wall clock spent [s].
    pub wall_s: f64,
}

/// Path of the checkpoint of a results folder.
#[must_use]
pub fn path(dir: &Path) -> PathBuf {
    dir.join(CHECKPOINTS).join(FILE)
}

impl<R: Precision> Checkpoint<R> {
    /// Writes the checkpoint of a results folder; returns its path.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, dir: &Path) -> Result<PathBuf, OutputError> {
        let path = path(dir);
        make_folder(&dir.join(CHECKPOINTS))?;
        let plain = postcard::to_stdvec(self).map_err(|e| OutputError::content(&path, e))?;
        let packed = zstd::encode_all(&plain[..], LEVEL).map_err(|e| OutputError::content(&path, e))?;
        let mut file = Vec::with_capacity(packed.len() + 16);
        file.extend_from_slice(MAGIC);
        file.extend_from_slice(&xxh3_64(&packed).to_le_bytes());
        file.extend_from_slice(&packed);
        write_whole(&path, &file)?;
        Ok(path)
    }

    /// Reads the checkpoint of a results folder.
    ///
    /// # Errors
    /// When there is none, or it is not whole, or it was written by another version or in another precision.
    pub fn read(dir: &Path) -> Result<Self, OutputError> {
        let path = path(dir);
        let broken = |what: &str| OutputError::content(&path, what);
        let file = std::fs::read(&path).map_err(|e| broken(&format!("no checkpoint to go on from ({e})")))?;
        let Some((magic, rest)) = file.split_first_chunk::<8>() else {
            return Err(broken("this is no checkpoint"));
        };
        let Some((hash, packed)) = rest.split_first_chunk::<8>() else {
            return Err(broken("this is no checkpoint"));
        };
        if magic != MAGIC {
            return Err(broken("this is no checkpoint of this version of Coulter"));
        }
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
