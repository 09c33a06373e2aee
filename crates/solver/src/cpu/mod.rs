//! The loops over cells and nodes, on the processor's cores. Those over fields are compiled twice, for
//! [`double`](crate::double) and [`single`](crate::single) precision; the names here are those of double precision.

pub mod cut;
pub mod machine;
pub mod stopwatch;
pub mod threads;

pub use crate::double::{energy, remap, workspace};
