//! The report of a run: `summary.json` for scripts, and `report.html`, one self-contained page.
//!
//! Both are made from the record of the run, its histories and what the other formats have left in the
//! folder, so that a report can be rebuilt without the state. The names in `summary.json` are a contract. No
//! other format depends on this one, but the intervals, which put several runs into one
//! report.

mod assembly;
mod body_rows;
mod cite;
mod confidence;
mod drawing;
mod headline;
mod page;
mod rows;
mod space;
mod summary;

pub use confidence::{confidence_lines, mean_lines};
pub use page::ReportWishes;
pub(crate) use page::{ReportText, write_report};
pub(crate) use summary::rims;
pub use summary::{BodySummary, EnergySummary, RimSummary, SoilSummary, Summary};
