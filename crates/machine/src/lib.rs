//! What this process may use of its machine: cores, memory and disk space.

pub mod cores;
mod memory;

pub use memory::{MemoryLeft, free_space, memory_available, memory_left};
