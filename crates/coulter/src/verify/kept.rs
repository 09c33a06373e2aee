//! What a stopped verification has already found, kept on disk so that the next one does not find it again.
//!
//! Every finished part of a benchmark leaves its rows and ledgers in a file. The file names what they were found with: a
//! hash of the program itself (and so of the cases in it) and of the request. Another program, or another request,
//! takes no notice of it and overwrites it.

use super::options::Wish;
use super::row::Row;
use super::run_ledgers::Ledgers;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// What one part of a benchmark found.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Found {
    pub(super) rows: Vec<Row>,
    pub(super) ledgers: Vec<Ledgers>,
}

/// A folder of findings that belong to one program and one request.
#[derive(Debug)]
pub(super) struct Kept {
    folder: PathBuf,
    key: u64,
}

impl Kept {
    /// The findings in a folder. `None` if the program cannot be read, and nothing can be told apart.
    pub(super) fn new(folder: &Path, wish: &Wish) -> Option<Self> {
        let program = std::fs::read(std::env::current_exe().ok()?).ok()?;
        let mut key = Xxh3::new();
        key.update(&program);
        key.update(&[u8::from(wish.fast)]);
        for typed in &wish.overrides {
            key.update(typed.as_bytes());
            key.update(&[0]);
        }
        Some(Self { folder: folder.to_path_buf(), key: key.digest() })
    }

    /// What was found of a part, if it was.
    pub(super) fn read(&self, id: &'static str, part: &str) -> Option<Found> {
        let file = std::fs::read(self.file(id, part)).ok()?;
        let (head, body) = file.split_first_chunk::<16>()?;
        if *head != self.head(body) {
            return None;
        }
        let mut found: Found = postcard::from_bytes(body).ok()?;
        found.rows.iter_mut().for_each(|row| row.id = id);
        found.ledgers.iter_mut().for_each(|run| run.id = id);
        Some(found)
    }

    /// Keeps what was found of a part.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub(super) fn write(&self, id: &str, part: &str, found: &Found) -> std::io::Result<()> {
        let body = postcard::to_stdvec(found).map_err(std::io::Error::other)?;
        std::fs::create_dir_all(&self.folder)?;
        let path = self.file(id, part);
        // A stop while it is written must not leave half a file behind.
        let draft = path.with_extension(format!("draft-{}", std::process::id()));
        std::fs::write(&draft, [&self.head(&body)[..], &body].concat())?;
        std::fs::rename(&draft, &path)
    }

    fn file(&self, id: &str, part: &str) -> PathBuf {
        let plain: String = part.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        // Two parts may look alike when only letters and digits are left of them.
        self.folder.join(format!("{id}_{plain}_{:08x}.found", xxh3_64(part.as_bytes()) as u32))
    }

    /// The key of program and request, and the hash of what follows.
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
    fn findings_come_back_for_the_same_request_only() {
        let folder = tempfile::tempdir().unwrap();
        let wish = Wish { fast: true, ..Wish::default() };
        let kept = Kept::new(folder.path(), &wish).unwrap();
        assert!(kept.read("B1", "B/h = 8").is_none());
        let row = Row::note("B1", "B/h = 8", "N_c", f64::NAN).within(5.0, 0.1, "Prandtl");
        kept.write("B1", "B/h = 8", &Found { rows: vec![row], ledgers: Vec::new() }).unwrap();
        let found = kept.read("B1", "B/h = 8").unwrap();
        assert_eq!((found.rows[0].id, found.rows[0].source.as_ref()), ("B1", "Prandtl"));
        assert!(found.rows[0].obtained.is_nan() && kept.read("B1", "B_h = 8").is_none());
        let other = Wish { overrides: vec!["soil.law=elastic".into()], ..wish };
        assert!(Kept::new(folder.path(), &other).unwrap().read("B1", "B/h = 8").is_none());
    }

    #[test]
    fn damaged_findings_are_none() {
        let folder = tempfile::tempdir().unwrap();
        let kept = Kept::new(folder.path(), &Wish::default()).unwrap();
        kept.write("A4", "", &Found { rows: Vec::new(), ledgers: Vec::new() }).unwrap();
        let path = kept.file("A4", "");
        let mut file = std::fs::read(&path).unwrap();
        *file.last_mut().unwrap() ^= 1;
        std::fs::write(&path, file).unwrap();
        assert!(kept.read("A4", "").is_none());
    }
}
