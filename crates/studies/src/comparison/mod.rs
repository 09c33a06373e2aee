//! Runs, closed forms and measurements side by side: aligned, with differences, peaks and steady means.

mod align;
mod common;
mod compare;
mod document;
mod figures;
mod item;
mod settled;
mod steady;

pub use align::{Aligned, aligned};
pub use compare::{Compared, Comparison, ComparisonRequest, compare};
pub use document::{comparison_csv, comparison_document, comparison_page, comparison_text};
pub use figures::{Differences, Peak, differences};
pub use item::{Item, ItemKind, Unreadable, read_item};
pub(crate) use settled::settle_signs;
pub use steady::{SteadyMean, steady_mean};
