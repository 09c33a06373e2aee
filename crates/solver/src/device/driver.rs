//! What a device can do.

use ::kernels::launch::Kernel;
use std::fmt;
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

    /// Begins to copy from the device what the launches so far leave there; the next [`Driver::end_read`]
    /// waits for that, and not for what is launched in between.
    ///
    /// # Errors
    /// [`DeviceError`] if an earlier launch has failed, or the copy cannot begin.
    fn begin_read(&mut self, from: Address, bytes: usize) -> Result<(), DeviceError>;

    /// Ends the copy that was begun last: of as many bytes.
    ///
    /// # Errors
    /// [`DeviceError`] if an earlier launch or the copy has failed, or none was begun.
    fn end_read(&mut self, bytes: &mut [u8]) -> Result<(), DeviceError>;

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
