//! The closed forms for the same case that the solver runs: what every applicable model says of its body.

mod curves;
mod document;
mod outlook;
mod range;
mod setting;
mod sheet;
mod spread;
mod tables;
mod towed;
mod variable;

pub use curves::{Curves, Series, curves};
pub use document::document;
pub use outlook::{Outlook, outlook};
pub use range::{Range, Unreadable};
pub use setting::{Setting, setting};
pub use sheet::models_table;
pub use spread::{Effort, Interval, Intervals, Stated, intervals};
pub use tables::{table, uncertainty_table};
pub use variable::{Variable, find, variables};
