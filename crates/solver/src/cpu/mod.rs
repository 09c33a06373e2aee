//! The loops over cells and nodes, on the cores of the processor.

pub(crate) mod fields_on_device;
pub(crate) mod kernels;
pub mod machine;
pub mod partition;
pub(crate) mod seepage;
pub(crate) mod stage_sums;
pub mod stopwatch;
pub mod threads;
pub(crate) mod workspace;
