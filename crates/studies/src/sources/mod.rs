//! Where curves come from besides measurements: the history of a run, and the closed-form models of a case.

mod closed_form;
mod curve;
mod left_out;
mod run;

pub use closed_form::{Along, ClosedForm, ClosedForms};
pub use curve::{local_means, rising, rising_rows};
pub use left_out::{LeftOut, place, says_nothing};
pub use run::{BodySamples, RunSource, read_run, read_samples};
