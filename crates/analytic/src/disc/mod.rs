//! A disc towed through soil: free to sink under its weight; free to rotate, braked, locked or driven.
//!
//! θ is measured about the axle from the lowest point forwards; the soil is in contact with the rim for 0 ≤
//! θ ≤ θ_f. Drag F_H is positive when it resists the tow, F_V when the soil pushes the disc up.

mod assembly;
mod bearing_arc;
mod bow_wave;
mod drive;
mod equilibrium;
mod forces;
mod geometry;
mod rim;
mod side_faces;
mod transition;
mod wedge;

pub use assembly::{Assembly, assembly_forces};
pub use bearing_arc::{bearing_arc, indentation_force};
pub use bow_wave::bow_wave_height;
pub use drive::Drive;
pub(crate) use equilibrium::check_weight_carried;
pub use equilibrium::{Equilibrium, MAX_RELATIVE_SINKAGE, equilibrium, equilibrium_depth, equilibrium_of};
pub use forces::{DiscForces, Mechanism, Model, Setting, disc_forces, vertical_force};
pub use geometry::{Contact, Disc};
pub use rim::{Reaction, RimLoad, RimPressure};
pub use side_faces::{SideFaces, side_faces};
pub use transition::{median_angle, opposed_friction_forces, slip_from_transition, transition_from_slip};
pub use wedge::{Ends, Passive, WedgeFace, end_factor, wedge};
