//! Devices on which the soil is strained instead of on the processor.
//!
//! A device holds the soil's fields, and takes the Lagrangian stage and the remaps (see
//! `cpu/kernels/on_device.rs`); contact and bodies are the processor's. The two exchange in a step what
//! contact touches, and the sums. A [`Driver`] is what a device can do: [`replay::Replay`] does it on
//! the processor, for tests without a device.

mod choice;
#[cfg(feature = "gpu")]
pub mod cuda;
mod driver;
pub mod replay;
mod touched;

pub use choice::{Device, footprint, require};
pub use driver::{Address, DeviceError, Driver, Launch};
pub use touched::Touched;
