//! Pictures in space and animations of a run, drawn by the processor: no display and no graphics card is
//! needed.
//!
//! Made from the recording that [`view`](super::view) reads back from the field files, in more detail than a
//! page can hold. The chain: `camera` projects, `mesh` makes the triangles of a time, `raster` finds what is
//! seen in every pixel, `shadow` what the sun sees, `frame` lights and labels a picture, `animation` writes
//! frames one after the other.

mod animation;
mod camera;
mod frame;
mod mesh;
mod options;
mod raster;
mod shadow;
mod write;

pub use options::{Colouring, ImageFormat, RenderOptions, Viewpoint};
pub use write::render;
