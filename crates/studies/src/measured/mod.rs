//! Measured curves from CSV files, and the records that measurements, runs and models have in common.
//!
//! A file has a header line that names every column with its unit, `sinkage [mm],vertical [N]`, then lines of numbers, separated by
//! commas or by semicolons; `#` begins a comment. Whatever is wrong is refused with its line, its column and a cure.

mod header;
mod quantity;
mod read;
mod record;
mod text;

pub use quantity::Quantity;
pub use read::{MAX_BYTES, parse, read};
pub use record::{Channel, Record};
