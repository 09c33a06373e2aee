//! Which part of a mesh study, or of a run with variations, a run is; an ordinary run is none.

/// A run among those of a mesh study, or among variations.
#[derive(Debug, Default)]
pub(super) struct Part {
    /// What its progress is labelled with, such as `mesh 1 of 3`; empty for an ordinary run.
    pub(super) label: String,
    /// Names of the coarser meshes whose runs lie below this one's folder.
    pub(super) meshes: Vec<String>,
    /// Whether it is on one of the coarser meshes, or a variation, and not the case itself.
    pub(super) is_beside: bool,
}

impl Part {
    /// A message that says which part it is about.
    pub(super) fn headed(&self, message: String) -> String {
        if self.label.is_empty() { message } else { format!("{}: {message}", self.label) }
    }
}
