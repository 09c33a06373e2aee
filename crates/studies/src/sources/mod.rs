//! Where curves come from besides measurements: the history of a run, and the closed-form models of a case.

mod closed_form;
mod curve;
mod run;

pub use closed_form::{Along, ClosedForm};
pub use curve::{local_means, rising};
pub use run::{RunSource, read_run};
