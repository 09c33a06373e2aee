//! What a variation changes in a case, and the case that follows.

use case::meshes::changed;
use case::resolved::Case;
use input::error::CaseError;

/// What a variation changes: overrides of the case, what they mean in words, and how much longer the case
/// takes.
pub(super) struct Change {
    pub(super) overrides: Vec<String>,
    pub(super) what: String,
    pub(super) time_factor: f64,
}

/// A case and its text.
#[derive(Clone, Copy)]
pub(super) struct Original<'a> {
    pub(super) case: &'a Case,
    pub(super) text: &'a str,
    pub(super) source_name: &'a str,
}

/// A variation that is not named yet: what differs, the case, its text, and how much longer it takes.
pub(super) type Unnamed = (String, Case, String, f64);

impl Original<'_> {
    /// The case with a change.
    pub(super) fn varied(self, change: Change) -> Result<Unnamed, String> {
        let (case, typed) =
            changed(self.case, self.text, self.source_name, &change.overrides).map_err(|e| reason(&e))?;
        Ok((change.what, case, typed, change.time_factor))
    }
}

/// The first problem of a case that cannot be had, in words.
pub(super) fn reason(error: &CaseError) -> String {
    let problem = error.problems.first();
    problem.map_or_else(|| error.to_string(), |problem| format!("it cannot be had: {}", problem.message))
}
