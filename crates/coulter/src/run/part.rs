//! Which part of a run with variations a run is; an ordinary run is none.

/// A run among variations.
#[derive(Debug, Default)]
pub(super) struct Part {
    /// Label of the progress of the run, such as `variation 1 of 3, cells 15mm`; empty for an ordinary run.
    pub(super) label: String,
    /// Whether the run is a variation, and not the case itself.
    pub(super) is_beside: bool,
}

impl Part {
    /// A message that says which part it is about.
    pub(super) fn headed(&self, message: String) -> String {
        if self.label.is_empty() { message } else { format!("{}: {message}", self.label) }
    }
}
