//! One interval for each force and sinkage of a run, from the same case on other meshes, in a larger domain,
//! at half the speed and in the other precision, and what dominates it.
//!
//! The intervals are calculated from histories and grades alone; `run` makes them, `output` reads them. The
//! formulas and their sources are in `docs/theory/confidence.md`.

mod checks;
mod combine;
mod convergence;
mod evaluate;
mod figures;
mod promise;
mod statistics;
pub mod variations;
mod wanted;

pub use combine::{REACH_DOMAIN, REACH_SPEED, SAFETY_PRECISION};
pub use convergence::{Convergence, OnMesh};
pub use evaluate::{VariedRun, evaluate};
pub use figures::{BodyConfidence, Confidence, ConfidenceInterval, Contribution, Status, VariationResult};
pub use wanted::Wanted;
