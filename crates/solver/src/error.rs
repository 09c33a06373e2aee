//! What can go wrong in a step.

use glam::DVec3;
use thiserror::Error;

/// The physics failed: the state is not to be trusted any more.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Breakdown {
    /// A field holds something that is not a number.
    #[error(
        "{field} is not a number at t = {time:.6} s (step {step}), near ({:.4}, {:.4}, {:.4}) m; a smaller courant number or a \
         stiffer soil may help",
        place.x, place.y, place.z
    )]
    NotANumber {
        /// Which field.
        field: &'static str,
        /// When [s].
        time: f64,
        /// In which step.
        step: u64,
        /// Where [m].
        place: DVec3,
    },
    /// Soil moves so fast that it crosses a good part of a cell in one step.
    #[error(
        "soil at ({:.4}, {:.4}, {:.4}) m moved {cells:.2} cells between two remaps at t = {time:.6} s (step {step}); a smaller \
         courant number, a slower body or a finer grid may help",
        place.x, place.y, place.z
    )]
    Runaway {
        /// How far, in cells of the smallest width.
        cells: f64,
        /// When [s].
        time: f64,
        /// In which step.
        step: u64,
        /// Where [m].
        place: DVec3,
    },
}
