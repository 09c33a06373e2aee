//! How fast the solver is on this machine: cell-steps per core-second, time by stage, and the limits of the
//! machine.

mod measure;
mod measurement;
mod network;
mod on_device;
mod ranks;
mod scaling;
mod table;
mod work;

pub use measure::{Options, TOWED_DISC, measure};
pub use measurement::{Measurement, Operations, Split};
pub use network::Network;
pub use on_device::{DeviceMeasurement, device_table, measure_on_device};
pub use ranks::{RankError, RankMeasurement, measure_ranks};
pub use scaling::{Modelled, Scaling, scaling, scaling_table};
pub use table::table;
