//! Contact between soil and bodies, at points of the bodies' surfaces.
//!
//! A contact point acts on the eight nodes of its cell. Its cell and weights are found by the contact search
//! after every remap and stay the same until the next. The contact law is velocity impulses, or penalty with
//! history.

mod body_fraction;
mod carried;
mod confined;
mod constraint;
mod constraint_points;
mod cut_cell;
mod effective_mass;
mod gather;
mod gauss_seidel;
mod impulse;
mod islands;
mod law;
mod method;
mod neighbours;
mod nodes;
mod overlap;
mod penalty;
mod place;
mod pore_pressure;
mod problem;
mod rim_stress;
mod search;
mod slip;
mod slip_terms;
mod solve;
mod surface;
pub(crate) mod workspace;

pub(crate) use body_fraction::{BodyCell, bodies_at_search, cut_out_bodies, filled};
pub(crate) use carried::carry;
pub(crate) use confined::{Pressed, find as find_confined, press, work as pressing_work};
pub(crate) use method::kept_per_constraint;
pub(crate) use overlap::remove_overlap;
pub(crate) use pore_pressure::find_pressure_cells;
pub(crate) use problem::ContactNode;
pub(crate) use search::{first_search, search};
pub(crate) use slip_terms::SlipTerms;
pub(crate) use solve::{ContactWork, apply, solve};
pub(crate) use surface::{Surface, layout, rim, stays_across};
