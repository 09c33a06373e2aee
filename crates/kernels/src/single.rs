//! The loops in single precision.

/// The precision of the soil's fields.
pub type Real = f32;

/// Numbers in the widest vector register.
#[cfg(not(target_arch = "nvptx64"))]
pub const LANES: usize = 64 / size_of::<Real>();
/// A thread of the device has one cell.
#[cfg(target_arch = "nvptx64")]
pub const LANES: usize = 1;

use physics::single as physics;

#[path = "cells.rs"]
pub mod cells;
#[path = "device.rs"]
pub mod device;
#[path = "lanes.rs"]
pub mod lanes;
#[path = "nodes.rs"]
pub mod nodes;
#[path = "return_mapping.rs"]
pub mod return_mapping;
#[path = "stress.rs"]
pub mod stress;
