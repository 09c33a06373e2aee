//! From case file to report: the public API of the library.

pub mod bench;
pub mod blocks;
pub mod element;
pub mod forecast;
pub mod interrupts;
pub mod output;
pub mod run;
pub mod session;
pub mod simulation;
mod stages;

pub use case;
pub use input::printed;
pub use mechanics;
pub use results::{confidence, formats, history, trust};
