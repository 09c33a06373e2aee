//! The closed-form models, applied to the same case as the solver.

mod carried;
mod curves;
mod direction;
mod document;
mod model_input;
mod models_csv;
mod outlook;
mod predicted;
mod range;
mod saturated;
mod tables;
mod towed;
mod uncertainty;
mod variable;
mod water;

pub use curves::{Curves, Series, curves};
pub use document::document;
pub use model_input::{ModelInput, model_input};
pub use models_csv::models_csv;
pub use outlook::{Outlook, outlook};
pub use predicted::{PREDICTED, Predicted};
pub use range::{Range, Unreadable};
pub use saturated::{BladeUnderWater, PloughUnderWater};
pub use tables::{table, uncertainty_table};
pub use uncertainty::{Effort, InputDeviation, Interval, Intervals, MAX_INPUTS, intervals};
pub use variable::{Variable, find, variables};
pub use water::UnderWater;
