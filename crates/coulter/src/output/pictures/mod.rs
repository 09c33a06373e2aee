//! Pictures of a state as PNG: slices along the body's mid-plane, the rut from above; its sections as SVG and CSV.
//!
//! They are drawn at the end of a run from what `fields` shows; not a number on a picture serves as a result.

mod canvas;
mod frame;
mod picture;
mod rut;
mod scene;

pub use picture::{Caption, PICTURES, write_pictures};
