//! What is wrong with a case, at which key, and what to do about it. Where the key stands in a text is known
//! to `places`.

use std::collections::HashSet;
use std::fmt;

/// One thing that is wrong with a case.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Problem {
    /// Path of the key, such as `soil.cohesion`, `body.disc.forward.ramp` or `ground.velocity[1]`; of a
    /// section, such as `soil`, where it concerns several keys; empty where it concerns the case as a whole.
    pub path: String,
    /// What is wrong with the case.
    pub message: String,
    /// How to fix the problem.
    pub cure: String,
}

impl Problem {
    /// What is wrong at a path, and what to do about it.
    #[must_use]
    pub fn new(path: impl Into<String>, message: impl Into<String>, cure: impl Into<String>) -> Self {
        Self { path: path.into(), message: message.into(), cure: cure.into() }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            f.write_str(&self.message)
        } else {
            write!(f, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for Problem {}

/// What of an entry a problem is about: where the message points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// Value of the key that is wrong.
    Value,
    /// Name of the key that is wrong.
    Name,
}

/// Collects problems, so that all are reported at once.
#[derive(Debug, Default)]
pub struct Problems {
    found: Vec<(Aim, Problem)>,
    known: HashSet<Problem>,
    remarks: Vec<String>,
    ignores_resolution: bool,
}

impl Problems {
    /// For a case that is not simulated: what only the resolution of the grid and the cost of a run forbid is
    /// left out.
    pub fn without_resolution() -> Self {
        Self { ignores_resolution: true, ..Self::default() }
    }

    /// Whether problems of the resolution and the cost are left out.
    pub fn ignores_resolution(&self) -> bool {
        self.ignores_resolution
    }

    /// Adds a problem with the value at a path; the same one only once.
    pub fn add(&mut self, path: impl Into<String>, message: impl Into<String>, cure: impl Into<String>) {
        self.push(Aim::Value, Problem::new(path, message, cure));
    }

    /// Adds a problem with the name of the entry at a path.
    pub fn add_to_name(
        &mut self,
        path: impl Into<String>,
        message: impl Into<String>,
        cure: impl Into<String>,
    ) {
        self.push(Aim::Name, Problem::new(path, message, cure));
    }

    fn push(&mut self, aim: Aim, problem: Problem) {
        if self.known.insert(problem.clone()) {
            self.found.push((aim, problem));
        }
    }

    /// Adds the problems of another list.
    pub fn append(&mut self, others: Self) {
        others.found.into_iter().for_each(|(aim, problem)| self.push(aim, problem));
    }

    /// Keeps what is to be said of how a file was read, which is no problem; the same only once.
    pub fn remark(&mut self, remark: String) {
        if !self.remarks.contains(&remark) {
            self.remarks.push(remark);
        }
    }

    /// All remarks, in the order in which they were made.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// Whether there is no problem.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// Number of the problems.
    #[must_use]
    pub fn len(&self) -> usize {
        self.found.len()
    }

    /// All problems with what they are about, in the order in which they were found.
    pub fn into_aimed(self) -> Vec<(Aim, Problem)> {
        self.found
    }

    /// All problems, in the order in which they were found.
    pub fn into_list(self) -> Vec<Problem> {
        self.found.into_iter().map(|(_, problem)| problem).collect()
    }
}
