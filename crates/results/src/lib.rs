//! What a run gives: histories and their quantities, fields, trust, intervals, and the files of a results
//! folder.
//!
//! Each format has a folder of modules that states its contract.

pub mod checkpoint;
pub mod confidence;
pub mod domain;
pub mod fields;
pub mod files;
pub mod folder;
pub mod formats;
pub mod ground_column;
pub mod history;
pub mod overlay;
pub mod progress;
pub mod tables;
pub mod trust;
pub mod vtk;
pub mod vtkhdf;

pub use files::{EntryKind, FileError, Inside, OutputError};
pub use progress::Progress;
