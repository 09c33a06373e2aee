//! How many triangles a body may have.

use super::problem::{MeshFileProblem, refuse};

/// Most triangles of a body.
pub const MOST_TRIANGLES: usize = 2_000_000;

/// What to do about too many triangles.
pub(super) const TOO_MANY: &str =
    "export the body with fewer triangles: sides of a fifth of a cell of the grid are fine enough";

/// Refuses more triangles than a body may have; `place` says where there are so many.
pub(super) fn require_few(triangles: u64, place: &str) -> Result<(), MeshFileProblem> {
    if triangles <= MOST_TRIANGLES as u64 {
        return Ok(());
    }
    refuse(format!("{place} {triangles} triangles, at most {MOST_TRIANGLES} are possible"), TOO_MANY)
}
