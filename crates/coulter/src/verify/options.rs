//! What the suite is asked to do.

use std::path::PathBuf;

/// What the suite is asked to do.
#[derive(Clone, Debug, Default)]
pub struct Wish {
    /// Only what takes about a minute in all.
    pub fast: bool,
    /// Overrides for every case that is run from a case file.
    pub overrides: Vec<String>,
    /// Threads; 0 for one per core.
    pub threads: usize,
    /// Folder in which findings are kept, to go on from after a stop; `None` to keep nothing.
    pub folder: Option<PathBuf>,
    /// Takes no notice of findings that are kept already.
    pub fresh: bool,
}
