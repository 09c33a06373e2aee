//! The study of a command: read from its file, or from the folder into which it was expanded.

use crate::failure::Failure;
use coulter::case;
use std::path::{Path, PathBuf};
use studies::study::{self, Study};
use studies::sweep::expand::expand;
use studies::sweep::line::CaseLine;
use studies::sweep::store::{Store, StudyError};

/// A study with its folder and its cases.
pub(super) struct Expanded {
    pub(super) study: Study,
    pub(super) store: Store,
    pub(super) lines: Vec<CaseLine>,
}

/// Reads a study file, or the quick version that it describes, expands it, and writes its folder.
pub(super) fn expanded(path: &Path, quick: bool, output: Option<&Path>) -> Result<Expanded, Failure> {
    if path.is_dir() {
        let shown = path.display();
        return Err(Failure::Request(format!(
            "{shown}: a folder, not a study; name the file of the study, or go on with `coulter sweep run {shown}` in the folder of one"
        )));
    }
    let text = case::text(path)?;
    let study = study::read(path, quick)?;
    let name = if quick { format!("{}_quick", study.name) } else { study.name.clone() };
    let folder = output.map_or_else(|| usual(&name), Path::to_path_buf);
    crate::common::refuse_file(&folder)?;
    let lines = expand(&study)?;
    let valid = lines.iter().filter(|line| line.refused.is_empty()).count();
    if let (0, Some(first)) = (valid, lines.first()) {
        return Err(Failure::Request(format!(
            "none of the {} cases of the study is valid; the first one: {}",
            lines.len(),
            first.refused
        )));
    }
    let store = Store::create(&folder, &study, &text, &lines).map_err(refused)?;
    Ok(Expanded { study, store, lines })
}

/// The usual folder of a study.
fn usual(name: &str) -> PathBuf {
    PathBuf::from("results").join(name)
}

/// The folder of a study that was expanded: named itself, or by its study file.
pub(super) fn opened(path: &Path) -> Result<Store, Failure> {
    let folder = match path.file_stem() {
        Some(stem) if path.is_file() => usual(&stem.to_string_lossy()),
        _ => path.to_path_buf(),
    };
    Store::open(&folder).map_err(refused)
}

/// A study as it was when it was expanded, with its cases.
pub(super) fn read(store: Store) -> Result<Expanded, Failure> {
    let origin = store.origin().map_err(refused)?;
    let study = study::read_expanded(&store.study_file(), (&origin.study, origin.quick), origin.cases)?;
    let lines = store.lines().map_err(refused)?;
    Ok(Expanded { study, store, lines })
}

pub(super) fn refused(error: StudyError) -> Failure {
    Failure::Request(error.to_string())
}
