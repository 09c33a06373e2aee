//! The case: what was typed (`schema`), and what it means (`Case`, SI units).

pub mod resolved;

pub use resolved::Case;
