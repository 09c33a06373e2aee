//! Contact between soil and bodies at points of the bodies' surfaces.
//!
//! A point acts on the eight nodes of the cell that it lies in. Where it lies, and with which weights, is found at
//! every remap and kept till the next. How soil and body act on each other there is a `ContactLaw`'s business; two
//! were built: penalty with a history, and velocity impulses.

mod body_fraction;
mod constraint;
mod cut_cell;
mod impulse;
mod law;
mod nodes;
mod overlap;
mod penalty;
mod scene;
mod search;
mod solve;
mod surface;
pub(crate) mod workspace;

pub(crate) use body_fraction::{BodyCell, cut_out_bodies};
pub(crate) use law::kept_per_patch;
pub(crate) use overlap::remove_overlap;
pub(crate) use scene::TouchedNode;
pub(crate) use search::{first_search, search};
pub(crate) use solve::{ContactWork, solve};
