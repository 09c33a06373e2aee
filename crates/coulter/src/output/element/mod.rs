//! The output of element tests: the curves as a table and as plots, the key figures as a document.
//!
//! What the tests give comes from `crate::element`; here it is only written and drawn.

mod files;
mod plots;

pub use files::write_element_tests;
