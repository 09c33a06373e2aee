//! Contact between soil and bodies, at points of the bodies' surfaces.
//!
//! A contact point acts on the eight nodes of its cell. The contact search finds its cell and weights at every remap; they stay
//! the same until the next. A contact law says how soil and body act on each other there: velocity impulses, or penalty with
//! history.

mod body_fraction;
mod constraint;
mod cut_cell;
mod impulse;
mod law;
mod method;
mod nodes;
mod overlap;
mod penalty;
mod scene;
mod search;
mod solve;
mod surface;
pub(crate) mod workspace;

pub(crate) use body_fraction::{BodyCell, cut_out_bodies};
pub(crate) use method::kept_per_constraint;
pub(crate) use overlap::remove_overlap;
pub(crate) use scene::ContactNode;
pub(crate) use search::{first_search, search};
pub(crate) use solve::{ContactWork, solve};
