//! Devices on which the soil is strained instead of on the processor.
//!
//! Between two remaps a device holds the soil's fields, and takes the Lagrangian stage (see
//! `cpu/kernels/device.rs`); contact, bodies and remaps are the processor's. The two exchange in a step what
//! contact touches, and the sums. A [`Driver`] is what a device can do: [`replay::Replay`] does it on the
//! processor, for tests without a device.

#[cfg(feature = "gpu")]
pub mod cuda;
pub mod replay;

use crate::fields::HISTORY;
use crate::model::Model;
use crate::scalar::Scalar;
use ::kernels::launch::{Kernel, MEASURED, POWERS, PlaneSum, ROW_SUMS};
use ::kernels::sums::COEFFICIENTS;
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Address in the memory of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Address(pub u64);

impl Address {
    /// The address as that of an array.
    pub(crate) fn pointer<T>(self) -> *mut T {
        std::ptr::with_exposed_provenance_mut(self.0 as usize)
    }
}

/// What strains the soil of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Device {
    /// The processor.
    #[default]
    Processor,
    /// A graphics card of NVIDIA, by its number.
    Gpu(u32),
    /// The processor in place of a graphics card, with its kernels: slow, for comparison.
    StandIn,
}

impl FromStr for Device {
    type Err = String;

    /// The device of this name: `cpu`, `gpu`, `gpu:1`, `stand-in`.
    fn from_str(name: &str) -> Result<Self, String> {
        let number = |name: &str| name.strip_prefix("gpu:")?.parse().ok();
        match name {
            "cpu" => Ok(Self::Processor),
            "gpu" => Ok(Self::Gpu(0)),
            "stand-in" => Ok(Self::StandIn),
            _ => number(name).map(Self::Gpu).ok_or_else(|| {
                format!("`{name}` is no device: cpu, gpu, gpu:N for the card of number N, or stand-in")
            }),
        }
    }
}

impl Device {
    /// Opens the device; `None` for the processor.
    ///
    /// # Errors
    /// [`DeviceError`] if there is no such device, or if the program was built without the feature `gpu`.
    pub fn open(self) -> Result<Option<Box<dyn Driver>>, DeviceError> {
        match self {
            Self::Processor => Ok(None),
            Self::StandIn => Ok(Some(Box::new(replay::Replay::default()))),
            #[cfg(feature = "gpu")]
            Self::Gpu(number) => Ok(Some(Box::new(cuda::Cuda::new(number)?))),
            #[cfg(not(feature = "gpu"))]
            Self::Gpu(_) => Err(DeviceError(
                "this program was built without graphics cards: cargo build --release --features gpu"
                    .to_owned(),
            )),
        }
    }
}

/// Fails if a device cannot hold the fields of a model, or a model needs what devices cannot do.
///
/// # Errors
/// [`DeviceError`] says which.
pub fn require<R: Scalar>(model: &Model, driver: &dyn Driver) -> Result<(), DeviceError> {
    if model.pore_water.is_some() {
        return Err(DeviceError("pore water flows on the processor alone".to_owned()));
    }
    let needed = footprint::<R>(model);
    match driver.free_memory().filter(|free| needed > *free) {
        Some(free) => Err(DeviceError(format!(
            "the grid takes {:.1} GB, and {:.1} GB are free on {}",
            1e-9 * needed,
            1e-9 * free,
            driver.name()
        ))),
        None => Ok(()),
    }
}

/// Memory that a grid takes on a device [bytes], without what contact touches.
#[must_use]
pub fn footprint<R: Scalar>(model: &Model) -> f64 {
    let history = HISTORY.iter().filter(|variable| model.kinds().need(variable)).count();
    // Volume fraction, two masses, stress, two velocities, displacement.
    let reals = 3 + 6 + history + 6 + 3 + COEFFICIENTS + POWERS + MEASURED;
    let per_entry = reals * size_of::<R>() + 2;
    let (rows, planes) = (model.grid.rows() * (model.grid.cells()[2] + 3), model.grid.cells()[2] + 2);
    let sums = rows * (ROW_SUMS * size_of::<f64>() + 1) + planes * ROW_SUMS * size_of::<PlaneSum>();
    (per_entry * model.grid.entries + sums) as f64
}

/// What the processor touches in a step: contact nodes, and cells whose stress it changes; indices in memory,
/// none of them twice.
#[derive(Debug)]
pub struct Touched {
    pub(crate) nodes: Vec<u32>,
    pub(crate) cells: Vec<u32>,
}

/// Why a device does not do what it is asked to.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct DeviceError(pub String);

/// A launch of a kernel.
pub struct Launch<'a> {
    /// The kernel.
    pub kernel: Kernel,
    /// Number of threads; more than these do nothing.
    pub threads: usize,
    /// Whether the fields are in double precision.
    pub is_double: bool,
    /// What the kernel is handed over: its arrays, and what it needs besides.
    pub arguments: [*const u8; 2],
    /// What a thread does, on the processor.
    pub on_processor: &'a mut dyn FnMut(usize),
}

impl fmt::Debug for Launch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} with {} threads", self.kernel.name(), self.threads)
    }
}

/// What a device can do. Copies and launches are done in the order in which they are asked for.
pub trait Driver: fmt::Debug + Send + Sync {
    /// Reserves memory [bytes], filled with zeros.
    ///
    /// # Errors
    /// [`DeviceError`] if there is not as much.
    fn allocate(&mut self, bytes: usize) -> Result<Address, DeviceError>;

    /// Gives back what was reserved.
    fn free(&mut self, address: Address);

    /// Sets memory to zero.
    ///
    /// # Errors
    /// [`DeviceError`] if an earlier launch has failed, or this does.
    fn clear(&mut self, at: Address, bytes: usize) -> Result<(), DeviceError>;

    /// Copies to the device.
    ///
    /// # Errors
    /// [`DeviceError`] if an earlier launch has failed, or the copy does.
    fn write(&mut self, to: Address, bytes: &[u8]) -> Result<(), DeviceError>;

    /// Copies from the device, once all that was launched is done.
    ///
    /// # Errors
    /// [`DeviceError`] if an earlier launch has failed, or the copy does.
    fn read(&mut self, from: Address, bytes: &mut [u8]) -> Result<(), DeviceError>;

    /// Launches a kernel.
    ///
    /// # Errors
    /// [`DeviceError`] if it cannot be.
    fn launch(&mut self, launch: Launch) -> Result<(), DeviceError>;

    /// Bytes that have crossed to the device and back since the driver began.
    fn crossed(&self) -> u64;

    /// Name of the device.
    fn name(&self) -> &str;

    /// Memory that is free on the device [bytes], if it can be known.
    fn free_memory(&self) -> Option<f64>;
}
