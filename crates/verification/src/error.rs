//! Why a benchmark produced no figure.

use analytic::ModelError;
use coulter::case::CaseError;
use coulter::output::OutputError;
use solver::error::Breakdown;

/// Why a benchmark produced no figure.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    /// The case of a benchmark cannot be run with these overrides.
    #[error("the case is refused: {0}")]
    Case(String),
    /// The physics failed.
    #[error(transparent)]
    Physics(#[from] Breakdown),
    /// The case asks for single precision.
    #[error("this benchmark runs in double precision only")]
    DoubleOnly,
    /// What is expected of a figure is not known.
    #[error("{0}")]
    Expectation(String),
    /// A closed form has no value.
    #[error(transparent)]
    ClosedForm(#[from] ModelError),
    /// A checkpoint could not be written or read.
    #[error(transparent)]
    Output(#[from] OutputError),
}

impl From<CaseError> for VerifyError {
    fn from(error: CaseError) -> Self {
        Self::Case(error.problems.iter().map(|p| p.message.clone()).collect::<Vec<_>>().join("; "))
    }
}
