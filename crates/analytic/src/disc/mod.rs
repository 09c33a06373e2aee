//! A disc towed through soil: free to sink under its weight, free to turn, braked, locked or driven.
//!
//! θ is measured about the axle from the lowest point forwards; the soil touches the rim for 0 ≤ θ ≤ θ_f. Drag F_H is
//! positive when it resists the tow, F_V when the soil pushes the disc up.

mod assembly;
mod bearing_arc;
mod drive;
mod equilibrium;
mod forces;
mod geometry;
mod heap;
mod rim;
mod side_faces;
mod transition;
mod wedge;

pub use assembly::{Assembly, assembly_forces};
pub use bearing_arc::bearing_arc;
pub use drive::Drive;
pub(crate) use drive::MOST_SLIP;
pub(crate) use equilibrium::carries;
pub use equilibrium::{DEEPEST, Equilibrium, equilibrium, equilibrium_of, first_depth};
pub use forces::{DiscForces, Mechanism, Model, Setting, disc_forces, vertical_force};
pub use geometry::{Contact, Disc};
pub use heap::heap_height;
pub use rim::{Reaction, RimLoad, RimPressure};
pub use side_faces::{SideFaces, side_faces};
pub use transition::{median_angle, rolling_split, slip_from_transition, transition_from_slip};
pub use wedge::{Passive, end_factor, wedge};
