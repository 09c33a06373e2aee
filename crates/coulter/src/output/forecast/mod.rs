//! The output of a forecast: its files, and its curves over the plots of a run.
//!
//! What the closed-form models say comes from `crate::forecast`; here it is only written and drawn.

mod files;
mod overlays;

pub use files::{ForecastFiles, write_forecast};
pub use overlays::overlays;
