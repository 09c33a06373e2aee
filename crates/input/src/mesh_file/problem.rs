//! What is wrong with the file of a surface.

use std::fmt;

/// Why a file cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshFileProblem {
    /// What is wrong with the file, and where.
    pub message: String,
    /// What to do about the file.
    pub cure: String,
}

impl MeshFileProblem {
    pub(super) fn new(message: impl Into<String>, cure: impl Into<String>) -> Self {
        Self { message: message.into(), cure: cure.into() }
    }
}

impl fmt::Display for MeshFileProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.message, self.cure)
    }
}

impl std::error::Error for MeshFileProblem {}

/// The refusal of a file.
pub(super) fn refuse<T>(message: impl Into<String>, cure: impl Into<String>) -> Result<T, MeshFileProblem> {
    Err(MeshFileProblem::new(message, cure))
}

/// What to do about a face that cannot be divided.
pub(super) const MEND_FACE: &str =
    "mend the face in the program that it comes from, or export the body with triangles only";

/// What to do about a file that ends too early or holds something else than it says.
pub(super) const DAMAGED: &str = "the file is damaged or of another kind: export the body again";
