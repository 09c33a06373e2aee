//! The folder of a study: where its files are, and how they are read and written.

use super::id::CaseId;
use super::line::CaseLine;
use super::outcome::Outcome;
use crate::files;
use crate::study::{BaseCase, Study, copy_name};
use coulter::formats;
use coulter::output::{FileError, Inside};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::HashSet;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Version of the format of the folder.
pub const FORMAT: u32 = 2;
/// Largest file of a study that is read [bytes].
const MOST_BYTES: u64 = 4 << 30;

/// Why a study cannot go on.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// A file could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The folder holds something else.
    #[error("{} holds files that are not a study of Coulter; choose an empty or a new folder with -o DIR", .0.display())]
    Foreign(PathBuf),
    /// The folder holds no study.
    #[error("{} holds no study (there is no cases.jsonl in it); `coulter sweep expand STUDY.toml` makes one", .0.display())]
    NoStudy(PathBuf),
    /// A file does not have the expected content.
    #[error("{}: {problem}; `coulter sweep expand` writes it anew", .path.display())]
    Content {
        /// The file.
        path: PathBuf,
        /// What is wrong with the file.
        problem: String,
    },
    /// The folder is of another version of the format.
    #[error("{}: {problem}", .path.display())]
    Format {
        /// The file that says so.
        path: PathBuf,
        /// What is wrong, and what to do.
        problem: String,
    },
    /// No case has this id.
    #[error("no case of the study in {} has the id {id}; its cases.jsonl lists them", .folder.display())]
    NoCase {
        /// The id.
        id: String,
        /// The folder of the study.
        folder: PathBuf,
    },
    /// The case is no longer the one that was expanded.
    #[error(
        "the case {id} is no longer what it was when the study was expanded (now {now}): a file that it reads has changed, or this is \
         another version of Coulter; expand the study anew"
    )]
    Changed {
        /// The id in the list.
        id: CaseId,
        /// The id of the case as it is read now.
        now: CaseId,
    },
}

/// Where a study comes from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// Version of the format of the folder.
    pub format: u32,
    /// Name of the study.
    pub study: String,
    /// Whether this is the quick version of the study.
    pub quick: bool,
    /// The files of the cases, beside which the files lie that they name; their text is kept in the folder.
    pub cases: Vec<BaseCase>,
}

/// The folder of a study.
#[derive(Clone, Debug)]
pub struct Store {
    /// Path of the folder.
    pub folder: PathBuf,
}

impl Store {
    /// The study in a folder.
    ///
    /// # Errors
    /// Where the folder holds none, or one of another version of the format.
    pub fn open(folder: &Path) -> Result<Self, StudyError> {
        let store = Self { folder: folder.to_path_buf() };
        if !store.inside(LIST).exists() {
            return Err(StudyError::NoStudy(folder.to_path_buf()));
        }
        store.check_format()?;
        store.check_folders()?;
        Ok(store)
    }

    /// Refuses links, before anything is run whose outcome could not be entered.
    fn check_folders(&self) -> Result<(), StudyError> {
        Ok([OUTCOMES, RUNS].iter().try_for_each(|name| files::folder(&self.inside(name)).map(drop))?)
    }

    /// Writes a study into a folder: a new one, or one that holds a study. Outcomes of cases that are still
    /// part of it remain.
    ///
    /// # Errors
    /// Where the folder holds something else or a study of another version of the format, or cannot be
    /// written.
    pub fn create(folder: &Path, study: &Study, text: &str, lines: &[CaseLine]) -> Result<Self, StudyError> {
        let store = Self { folder: folder.to_path_buf() };
        if store.inside(LIST).exists() {
            store.check_format()?;
        } else if files::is_used(folder)? {
            return Err(StudyError::Foreign(folder.to_path_buf()));
        }
        store.check_folders()?;
        files::make_folder(&store.inside(""))?;
        files::write(&store.inside(STUDY), text.as_bytes())?;
        let mut cases = study.cases.clone();
        for (n, case) in cases.iter_mut().enumerate() {
            files::write(&store.inside(&case_file(n)), case.text.as_bytes())?;
            let path = std::path::absolute(&case.path).unwrap_or_else(|_| PathBuf::from(&case.path));
            case.path = path.display().to_string();
        }
        for chart in &study.charts {
            for (n, measured) in chart.measured.iter().enumerate() {
                store.write(&copy_name(&chart.name, n), &measured.bytes)?;
            }
        }
        let origin = Origin { format: FORMAT, study: study.name.clone(), quick: study.is_quick, cases };
        let origin = serde_json::to_string_pretty(&origin).unwrap_or_default() + "\n";
        files::write(&store.inside(ORIGIN), origin.as_bytes())?;
        // Last: a folder with a list is complete.
        files::write_with(&store.inside(LIST), |file| {
            lines.iter().try_for_each(|line| {
                serde_json::to_writer(&mut *file, line)?;
                file.write_all(b"\n")
            })
        })?;
        Ok(store)
    }

    fn check_format(&self) -> Result<(), StudyError> {
        let path = self.folder.join(ORIGIN);
        let origin: Value = serde_json::from_str(&self.text(ORIGIN)?)
            .map_err(|error| StudyError::Content { path: path.clone(), problem: error.to_string() })?;
        let again = "finish it with the version of Coulter that began it, or expand the study into another folder (-o DIR)";
        formats::check(origin["format"].as_u64(), FORMAT, "studies", again)
            .map_err(|problem| StudyError::Format { path, problem })
    }

    /// The list of the cases.
    #[must_use]
    pub fn list(&self) -> PathBuf {
        self.folder.join(LIST)
    }

    /// The study file as it was expanded.
    #[must_use]
    pub fn study_file(&self) -> PathBuf {
        self.folder.join(STUDY)
    }

    /// An entry of the folder.
    fn inside(&self, name: &str) -> Inside {
        Inside::of(&self.folder, name)
    }

    fn outcome_file(&self, id: &CaseId) -> Inside {
        self.inside(OUTCOMES).join(format!("{id}.json"))
    }

    fn failure_file(&self, id: &CaseId) -> Inside {
        self.inside(OUTCOMES).join(format!("{id}.failed"))
    }

    /// Results folder of the run of a case.
    ///
    /// # Errors
    /// Where it, or the folder of all runs, is a link.
    pub fn run_folder(&self, id: &CaseId) -> Result<PathBuf, StudyError> {
        Ok(files::folder(&self.inside(RUNS).join(id.as_str()))?)
    }

    /// Where the study comes from, with the texts of the cases that it varies.
    ///
    /// # Errors
    /// Where they cannot be read.
    pub fn origin(&self) -> Result<Origin, StudyError> {
        let origin = serde_json::from_str(&self.text(ORIGIN)?);
        let mut origin: Origin = origin.map_err(|error| StudyError::Content {
            path: self.folder.join(ORIGIN),
            problem: error.to_string(),
        })?;
        for (n, case) in origin.cases.iter_mut().enumerate() {
            case.text = self.text(&case_file(n))?;
        }
        Ok(origin)
    }

    fn text(&self, name: &str) -> Result<String, StudyError> {
        let bytes = files::read_inside(&self.inside(name), MOST_BYTES)?;
        String::from_utf8(bytes).map_err(|_| StudyError::Content {
            path: self.folder.join(name),
            problem: "it is not UTF-8 text".to_owned(),
        })
    }

    /// All cases.
    ///
    /// # Errors
    /// Where the list cannot be read.
    pub fn lines(&self) -> Result<Vec<CaseLine>, StudyError> {
        let text = self.text(LIST)?;
        text.lines().enumerate().map(|(n, line)| self.line(n, line)).collect()
    }

    fn line(&self, n: usize, text: &str) -> Result<CaseLine, StudyError> {
        serde_json::from_str(text).map_err(|error| StudyError::Content {
            path: self.list(),
            problem: format!("line {}: {error}", n + 1),
        })
    }

    /// The cases of these ids, in their order.
    ///
    /// # Errors
    /// Where the list cannot be read, or does not have one of them.
    pub fn find(&self, ids: &[String]) -> Result<Vec<CaseLine>, StudyError> {
        let text = self.text(LIST)?;
        let one = |id: &String| {
            // Only the line that is wanted is read as a whole: a list may have a million.
            let start = format!("{{\"id\":\"{id}\"");
            match text.lines().enumerate().find(|(_, line)| line.starts_with(&start)) {
                Some((n, line)) => self.line(n, line),
                None => Err(StudyError::NoCase { id: id.clone(), folder: self.folder.clone() }),
            }
        };
        ids.iter().map(one).collect()
    }

    /// The outcome of a case; `None` where there is none yet. One that a loss of power has left in pieces
    /// does not count.
    #[must_use]
    pub fn outcome(&self, id: &CaseId) -> Option<Outcome> {
        let bytes = files::read_inside(&self.outcome_file(id), MOST_BYTES).ok()?;
        serde_json::from_slice(&bytes).ok().filter(|outcome: &Outcome| outcome.id == *id)
    }

    /// The ids with an outcome file, whole or not.
    ///
    /// # Errors
    /// Where the folder cannot be read.
    pub fn with_outcome(&self) -> Result<HashSet<String>, StudyError> {
        let names = files::names(&self.inside(OUTCOMES))?;
        Ok(names.iter().filter_map(|name| name.strip_suffix(".json").map(str::to_owned)).collect())
    }

    /// Enters the outcome of a case; what failed before is forgotten.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn enter(&self, outcome: &Outcome) -> Result<(), StudyError> {
        let mut text = serde_json::to_string_pretty(outcome).unwrap_or_default();
        text.push('\n');
        write_with_folder(&self.outcome_file(&outcome.id), text.as_bytes())?;
        files::forget(&self.failure_file(&outcome.id));
        Ok(())
    }

    /// Notes why a case could not be brought to an outcome; it will be tried again.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn note_failure(&self, id: &CaseId, why: &str) -> Result<(), StudyError> {
        write_with_folder(&self.failure_file(id), why.as_bytes())
    }

    /// Why a case could not be brought to an outcome; `None` where it has not been tried, or the attempt was
    /// killed.
    #[must_use]
    pub fn failure(&self, id: &CaseId) -> Option<String> {
        let bytes = files::read_inside(&self.failure_file(id), MOST_BYTES).ok()?;
        Some(String::from_utf8_lossy(&bytes).trim().to_owned())
    }

    /// Writes one of the collected files, below the folder of the study.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn write(&self, name: &str, content: &[u8]) -> Result<PathBuf, StudyError> {
        let file = self.inside(name);
        write_with_folder(&file, content)?;
        Ok(file.path())
    }
}

/// Writes a file; its folder may have been removed, so that cases are run again.
fn write_with_folder(file: &Inside, content: &[u8]) -> Result<(), StudyError> {
    files::make_folder(&file.beside(""))?;
    Ok(files::write(file, content)?)
}

const LIST: &str = "cases.jsonl";
const STUDY: &str = "study.toml";
const ORIGIN: &str = "origin.json";
const OUTCOMES: &str = "outcomes";
const RUNS: &str = "runs";

/// The copy of a case by its number: `case.toml`, `case_2.toml`.
fn case_file(number: usize) -> String {
    if number == 0 { "case.toml".to_owned() } else { format!("case_{}.toml", number + 1) }
}
