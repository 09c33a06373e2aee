//! What is shown of a state, in whatever format: the soil of a cell, and the free surface.
//!
//! SI units, as computed; nothing here writes or draws.

mod cell;
mod heights;
mod rut;
mod surface;

pub use cell::shown_pressure;
pub use cell::{CellView, filled_cells, node_velocity};
pub use heights::surface_heights;
pub use rut::{Rut, ruts};
pub use surface::{HeightMap, SurfaceFigures, reference_height};
