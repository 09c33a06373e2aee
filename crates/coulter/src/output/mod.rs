//! What a run leaves behind.

pub mod chart;
mod colour;
pub mod csv;
mod error;
mod fields;
pub mod plot;
pub mod record;
pub mod reference;
pub mod run_record;
mod scale;
pub mod steady;
pub mod summary;
pub mod surface;
pub mod table;
mod vtk;
pub use error::OutputError;
