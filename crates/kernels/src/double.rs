//! The loops in double precision.

/// The precision of the soil's fields.
pub type Real = f64;

/// Numbers in the widest vector register.
#[cfg(not(target_arch = "nvptx64"))]
pub const LANES: usize = 64 / size_of::<Real>();
/// A thread of the device has one cell.
#[cfg(target_arch = "nvptx64")]
pub const LANES: usize = 1;

/// A cell with more soil than this counts as full: no interface is reconstructed.
pub const FULL: f64 = 1.0 - 1e-9;

use physics::double as physics;

#[path = "cells.rs"]
pub mod cells;
#[path = "device.rs"]
pub mod device;
#[path = "device_arrays.rs"]
pub mod device_arrays;
#[path = "device_remap.rs"]
pub mod device_remap;
#[path = "device_run.rs"]
pub mod device_run;
#[path = "energy.rs"]
pub mod energy;
#[path = "flux.rs"]
pub mod flux;
#[path = "lanes.rs"]
pub mod lanes;
#[path = "nodes.rs"]
pub mod nodes;
#[path = "nonlocal.rs"]
pub mod nonlocal;
#[path = "post_remap.rs"]
pub mod post_remap;
#[path = "remap.rs"]
pub mod remap;
#[path = "return_mapping.rs"]
pub mod return_mapping;
#[path = "stress.rs"]
pub mod stress;
#[path = "transport.rs"]
pub mod transport;
