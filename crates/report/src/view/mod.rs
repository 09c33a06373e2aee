//! The soil surface and the bodies over time, as the report and rendered pictures show them in three
//! dimensions.
//!
//! Made from the field files of a run, so that a report can be rebuilt. Heights belong to positions, not to
//! columns of a grid that may travel. What a screen cannot show is left out: points, times and triangles are
//! thinned out evenly to the detail that is asked for.

mod lattice;
mod pack;
mod recording;
mod rigid;
mod solid;
mod surface;
mod surface_view;

pub(crate) use recording::{Detail, Recording, displacements};
pub(crate) use solid::RecordedBody;
pub(crate) use surface_view::SurfaceView;
