//! Pictures of a state as PNG: slices along the body's mid-plane, the rut from above; its sections as SVG and
//! CSV.
//!
//! The pictures are drawn from what `fields` shows of a state. They are for the eye: results are in the
//! tables and field files.

mod canvas;
mod frame;
mod picture;
mod rut;
mod scene;
mod shown;
mod soil;

pub(crate) use canvas::{Anchor, Canvas, SUPERSAMPLING, Tone, dark_variant};
pub use picture::{Caption, PICTURES, write_pictures};
pub use shown::Shown;
