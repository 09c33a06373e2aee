//! Files of a results folder: their names, how they are written (whole, or not at all) and read, and what can
//! go wrong.
//!
//! Every error names the file. Nothing here knows what is in a file.

mod error;
mod inside;
mod io;
mod names;

pub use error::Named;
pub use error::{FileError, OutputError};
pub use inside::{EntryKind, Inside};
pub use io::{make_folder, read_json, read_text, write_copy, write_json, write_whole, write_with};

pub use names::{
    BODIES, CHECKPOINTS, FIELDS, LISTS, LOG, PICTURES, PLOTS, REPORT, RESOLVED, SUMMARY, TYPED, VARIATIONS,
    file_safe,
};
