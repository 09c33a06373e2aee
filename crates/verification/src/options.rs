//! What the suite is asked to do.

use std::path::PathBuf;

/// Options of the verification suite.
#[derive(Clone, Debug, Default)]
pub struct SuiteOptions {
    /// Run only what takes about a minute in all.
    pub fast: bool,
    /// Overrides for every case that is run from a case file.
    pub overrides: Vec<String>,
    /// Threads; 0 for as many as `coulter::case::cores::threads_by_default`.
    pub threads: usize,
    /// Folder of the result cache, from which a stopped verification continues; `None` for no cache.
    pub folder: Option<PathBuf>,
    /// Ignore results that are cached already.
    pub fresh: bool,
    /// Run nothing: the rows say what is expected, but their figures mean nothing.
    pub only_list: bool,
}
