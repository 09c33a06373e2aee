//! Problems at their places in a text.

use crate::problem::Problem;
use std::ops::Range;

/// What is wrong, and at which bytes of the text.
pub type Placed = (Range<usize>, Problem);

/// A problem at a place.
pub fn placed(at: Range<usize>, message: impl Into<String>, cure: impl Into<String>) -> Placed {
    (at, Problem::new("", message, cure))
}

/// The line of a byte of a text, counted from 1.
pub(crate) fn line_of(text: &str, at: usize) -> usize {
    text.as_bytes()[..at.min(text.len())].iter().filter(|byte| **byte == b'\n').count() + 1
}
