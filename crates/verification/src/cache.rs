//! A cache on disk of what a stopped verification has already obtained.
//!
//! Every finished part of a benchmark leaves its rows and balances in a file, which begins with a hash of the
//! program itself (and so of the cases in it) and of the options. Another program, or other options, ignore
//! and overwrite it.

use crate::options::SuiteOptions;
use crate::row::Row;
use crate::run_balances::RunBalances;
use coulter::output::Inside;
use serde::{Deserialize, Serialize};
use std::io::Write;
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// The results of one part of a benchmark.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct CachedPart {
    pub(crate) rows: Vec<Row>,
    pub(crate) balances: Vec<RunBalances>,
}

/// A folder of results that belong to one program and one set of options.
#[derive(Debug)]
pub(crate) struct ResultCache {
    folder: PathBuf,
    key: u64,
}

impl ResultCache {
    /// The cache in a folder; `None` if the program itself cannot be read, and so not be hashed.
    pub(crate) fn new(folder: &Path, options: &SuiteOptions) -> Option<Self> {
        let program = std::fs::read(std::env::current_exe().ok()?).ok()?;
        let mut key = Xxh3::new();
        key.update(&program);
        key.update(&[u8::from(options.fast)]);
        for typed in &options.overrides {
            key.update(typed.as_bytes());
            key.update(&[0]);
        }
        Some(Self { folder: folder.to_path_buf(), key: key.digest() })
    }

    /// The cached results of a part, if there are any.
    pub(crate) fn read(&self, id: &'static str, part: &str) -> Option<CachedPart> {
        let file = self.file(id, part).read(u64::MAX).ok()?;
        let (head, body) = file.split_first_chunk::<16>()?;
        if *head != self.head(body) {
            return None;
        }
        let mut found: CachedPart = postcard::from_bytes(body).ok()?;
        found.rows.iter_mut().for_each(|row| row.id = id);
        found.balances.iter_mut().for_each(|run| run.id = id);
        Some(found)
    }

    /// Caches the results of a part.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub(crate) fn write(&self, id: &str, part: &str, found: &CachedPart) -> std::io::Result<()> {
        let body = postcard::to_stdvec(found).map_err(std::io::Error::other)?;
        Inside::of(&self.folder, "").make_folder()?;
        let content = [&self.head(&body)[..], &body].concat();
        let draft = format!(".draft-{}", std::process::id());
        let done = self.file(id, part).write_whole(&draft, |file| file.write_all(&content));
        done.map_err(|error| error.source)
    }

    fn file(&self, id: &str, part: &str) -> Inside {
        let plain: String = part.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        // Different parts may have the same letters and digits: a hash tells them apart.
        let name = format!("{id}_{plain}_{:08x}.cached", xxh3_64(part.as_bytes()) as u32);
        Inside::of(&self.folder, name)
    }

    /// The key of program and options, and the hash of what follows.
    fn head(&self, body: &[u8]) -> [u8; 16] {
        let mut head = [0; 16];
        head[..8].copy_from_slice(&self.key.to_le_bytes());
        head[8..].copy_from_slice(&xxh3_64(body).to_le_bytes());
        head
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_back_for_the_same_options_only() {
        let folder = tempfile::tempdir().unwrap();
        let options = SuiteOptions { fast: true, ..SuiteOptions::default() };
        let cache = ResultCache::new(folder.path(), &options).unwrap();
        assert!(cache.read("B1", "B/h = 8").is_none());
        let row = Row::info("B1", "B/h = 8", "N_c", f64::NAN).within(5.0, 0.1, "Prandtl");
        cache.write("B1", "B/h = 8", &CachedPart { rows: vec![row], balances: Vec::new() }).unwrap();
        let found = cache.read("B1", "B/h = 8").unwrap();
        assert_eq!((found.rows[0].id, found.rows[0].source.as_ref()), ("B1", "Prandtl"));
        assert!(found.rows[0].obtained.is_nan() && cache.read("B1", "B_h = 8").is_none());
        let other = SuiteOptions { overrides: vec!["soil.law=elastic".into()], ..options };
        assert!(ResultCache::new(folder.path(), &other).unwrap().read("B1", "B/h = 8").is_none());
    }

    #[test]
    fn damaged_results_are_ignored() {
        let folder = tempfile::tempdir().unwrap();
        let cache = ResultCache::new(folder.path(), &SuiteOptions::default()).unwrap();
        cache.write("A4", "", &CachedPart { rows: Vec::new(), balances: Vec::new() }).unwrap();
        let path = cache.file("A4", "").path();
        let mut file = std::fs::read(&path).unwrap();
        *file.last_mut().unwrap() ^= 1;
        std::fs::write(&path, file).unwrap();
        assert!(cache.read("A4", "").is_none());
    }
}
