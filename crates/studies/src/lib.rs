//! What many cases say together: studies of cases that vary, comparison with measurements, calibration.

pub mod analysis;
pub mod calibration;
pub mod charts;
pub mod comparison;
pub mod expression;
pub mod files;
pub mod history_columns;
mod laid_over;
pub mod measured;
pub mod page;
pub mod responses;
pub mod sheet;
pub mod sources;
pub mod statistics;
pub mod study;
pub mod sweep;
pub mod table;

pub use laid_over::laid_over;
