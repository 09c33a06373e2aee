//! The loops over cells and nodes of soil that a time step consists of.
//!
//! All functions work on rows of cells or nodes, or parts of them; there are no files or threads in them,
//! and of a grid only its layout in memory. They are
//! written once, for numbers of the type `Real`, and compiled in [`double`] and in [`single`] precision: for
//! the processor in vectors, for a graphics card with rows of one cell.
// The same files on purpose; conversions that widen a number in single precision do nothing in double.
#![allow(clippy::duplicate_mod, clippy::useless_conversion)]

pub mod double;
pub mod exact_sum;
pub mod history;
pub mod launch;
pub mod layout;
pub mod mixture;
pub mod single;
pub mod sums;

#[cfg(not(target_arch = "nvptx64"))]
/// The kernels in double precision for a device of NVIDIA, as `scripts/ptx` compiles them.
pub const PTX_DOUBLE: &str = include_str!("ptx/double.ptx");
#[cfg(not(target_arch = "nvptx64"))]
/// The kernels in single precision for a device of NVIDIA.
pub const PTX_SINGLE: &str = include_str!("ptx/single.ptx");
