//! Fields for ParaView and PyVista: soil (`.vtr`), free surface and bodies (`.vtp`) over time, with a list of
//! each (`.pvd`).
//!
//! SI units, coordinates of the ground; the arrays are described in `docs/reference/results.md`. Files are
//! written as a stream, block by block, so that the memory for them does not grow with the grid, and appear
//! whole or not at all. A file is written once for a time; a resumed run goes on with the same numbers.

mod file;
mod polygons;
mod read;
mod series;
mod soil;
mod time_list;

pub use read::VtkFile;
pub use series::FieldSeries;
pub use time_list::{TimedFile, read_time_list};
