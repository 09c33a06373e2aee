//! NVIDIA's devices, by their driver's library, which is looked for when a run asks for one.
#![allow(unsafe_code)] // The driver's functions take addresses.

use super::driver::{Address, DeviceError, Driver, Launch};
use ::kernels::launch::Kernel;
use cudarc::driver::result::{self, DriverError};
use cudarc::driver::sys;
use rustc_hash::FxHashMap;
use std::ffi::{CString, c_void};

/// The kernels for a device, in the language that its driver compiles.
const PTX: [&str; 2] = [::kernels::PTX_SINGLE, ::kernels::PTX_DOUBLE];

/// Threads in a block: a multiprocessor has registers for two blocks in double precision, at 210 a
/// thread.
const BLOCK: u32 = 128;

/// A device.
#[derive(Debug)]
pub struct Cuda {
    name: String,
    context: sys::CUcontext,
    /// What is asked for is done in order; runs beside each other have a stream each.
    stream: sys::CUstream,
    kernels: FxHashMap<(bool, Kernel), sys::CUfunction>,
    /// What is reserved.
    reserved: Vec<Address>,
    crossed: u64,
    landing: Option<Landing>,
}

/// Where copies land that are under way: memory that cannot be paged out, its size, and what tells when they
/// have come.
#[derive(Debug)]
struct Landing {
    memory: *mut c_void,
    bytes: usize,
    has_come: sys::CUevent,
}

// SAFETY: a context may be made current by any thread, as every method does.
unsafe impl Send for Cuda {}
// SAFETY: what is shared is only looked at.
unsafe impl Sync for Cuda {}

fn failed(what: &str) -> impl Fn(DriverError) -> DeviceError + '_ {
    move |error| DeviceError(format!("{what}: {error}"))
}

impl Cuda {
    /// The device of this number.
    ///
    /// # Errors
    /// [`DeviceError`] if there is no driver or no such device, or if it does not take the kernels.
    pub fn new(number: u32) -> Result<Self, DeviceError> {
        // SAFETY: the library is the driver's.
        if !unsafe { sys::is_culib_present() } {
            return Err(DeviceError("no driver of NVIDIA was found (libcuda)".to_owned()));
        }
        result::init().map_err(failed("the driver does not start"))?;
        let device = result::device::get(i32::try_from(number).unwrap_or(i32::MAX))
            .map_err(failed("there is no such device"))?;
        let name = result::device::get_name(device).map_err(failed("the device has no name"))?;
        // SAFETY: the device is one.
        let context = unsafe { result::primary_ctx::retain(device) }.map_err(failed(&name))?;
        // SAFETY: the context was retained.
        unsafe { result::ctx::set_current(context) }.map_err(failed(&name))?;
        let stream =
            result::stream::create(result::stream::StreamKind::NonBlocking).map_err(failed(&name))?;
        let mut cuda = Self {
            name,
            context,
            stream,
            kernels: FxHashMap::default(),
            reserved: Vec::new(),
            crossed: 0,
            landing: None,
        };
        for (is_double, text) in [false, true].into_iter().zip(PTX) {
            cuda.load(is_double, text)?;
        }
        Ok(cuda)
    }

    fn load(&mut self, is_double: bool, text: &str) -> Result<(), DeviceError> {
        let text = CString::new(text).map_err(|error| DeviceError(error.to_string()))?;
        // SAFETY: the text is a module, and ends with a zero.
        let module = unsafe { result::module::load_data(text.as_ptr().cast::<c_void>()) }
            .map_err(failed("the device does not take the kernels"))?;
        for kernel in Kernel::ALL {
            let name = CString::new(kernel.name()).map_err(|error| DeviceError(error.to_string()))?;
            // SAFETY: the module was loaded.
            let function =
                unsafe { result::module::get_function(module, name) }.map_err(failed(kernel.name()))?;
            self.kernels.insert((is_double, *kernel), function);
        }
        Ok(())
    }

    /// Room for so many bytes to land.
    fn landing(&mut self, bytes: usize) -> Result<&Landing, DriverError> {
        if self.landing.as_ref().is_none_or(|landing| landing.bytes < bytes) {
            self.close_landing();
            // SAFETY: the memory is written before it is read.
            let memory = unsafe { result::malloc_host(bytes, 0) }?;
            let has_come = result::event::create(sys::CUevent_flags::CU_EVENT_DISABLE_TIMING)?;
            self.landing = Some(Landing { memory, bytes, has_come });
        }
        self.landing.as_ref().ok_or(DriverError(sys::cudaError_enum::CUDA_ERROR_NOT_READY))
    }

    fn close_landing(&mut self) {
        if let Some(Landing { memory, has_come, .. }) = self.landing.take() {
            // SAFETY: both were made by `landing`, and nothing is under way to the memory.
            let _ = unsafe { result::event::destroy(has_come).and_then(|()| result::free_host(memory)) };
        }
    }

    /// Makes the device that of the calling thread.
    fn enter(&self) -> Result<(), DeviceError> {
        // SAFETY: the context was retained.
        unsafe { result::ctx::set_current(self.context) }.map_err(failed("the device does not answer"))
    }
}

impl Driver for Cuda {
    fn allocate(&mut self, bytes: usize) -> Result<Address, DeviceError> {
        self.enter()?;
        let what = format!("{bytes} bytes are not free on the device");
        // SAFETY: what was reserved is set to zero at once.
        let address = unsafe { result::malloc_sync(bytes.max(1)) }.map_err(failed(&what))?;
        // SAFETY: as above.
        unsafe { result::memset_d8_async(address, 0, bytes.max(1), self.stream) }.map_err(failed(&what))?;
        self.reserved.push(Address(address));
        Ok(Address(address))
    }

    fn free(&mut self, address: Address) {
        self.reserved.retain(|reserved| *reserved != address);
        // What cannot be given back is given back when the program ends.
        // SAFETY: the solver gives back what it reserved, once.
        let _ = self.enter().map(|()| unsafe { result::free_sync(address.0) });
    }

    fn clear(&mut self, at: Address, bytes: usize) -> Result<(), DeviceError> {
        self.enter()?;
        // SAFETY: as many bytes were reserved there.
        unsafe { result::memset_d8_async(at.0, 0, bytes, self.stream) }
            .map_err(failed("clearing memory of the device"))
    }

    fn write(&mut self, to: Address, bytes: &[u8]) -> Result<(), DeviceError> {
        self.enter()?;
        self.crossed += bytes.len() as u64;
        // SAFETY: as many bytes were reserved there; they are taken before this returns, as their memory may
        // be paged out.
        unsafe { result::memcpy_htod_async(to.0, bytes, self.stream) }
            .map_err(failed("copying to the device"))
    }

    fn read(&mut self, from: Address, bytes: &mut [u8]) -> Result<(), DeviceError> {
        self.enter()?;
        self.crossed += bytes.len() as u64;
        // SAFETY: as many bytes were reserved there, and they have come before this returns.
        unsafe {
            result::memcpy_dtoh_async(bytes, from.0, self.stream)
                .and_then(|()| result::stream::synchronize(self.stream))
        }
        .map_err(failed("copying from the device"))
    }

    fn begin_read(&mut self, from: Address, bytes: usize) -> Result<(), DeviceError> {
        self.enter()?;
        self.crossed += bytes as u64;
        let stream = self.stream;
        let began = self.landing(bytes).and_then(|landing| {
            // SAFETY: as many bytes were reserved there, and have room where they land.
            unsafe {
                let there = std::slice::from_raw_parts_mut(landing.memory.cast::<u8>(), bytes);
                result::memcpy_dtoh_async(there, from.0, stream)?;
                result::event::record(landing.has_come, stream)
            }
        });
        began.map_err(failed("copying from the device"))
    }

    fn end_read(&mut self, bytes: &mut [u8]) -> Result<(), DeviceError> {
        self.enter()?;
        let landing = self.landing.as_ref().filter(|landing| landing.bytes >= bytes.len());
        let landing = landing.ok_or_else(|| DeviceError("no copy of this was begun".to_owned()))?;
        // SAFETY: the event was recorded behind the copy, which fills as many bytes.
        unsafe {
            result::event::synchronize(landing.has_come).map_err(failed("copying from the device"))?;
            bytes.copy_from_slice(std::slice::from_raw_parts(landing.memory.cast::<u8>(), bytes.len()));
        }
        Ok(())
    }

    fn launch(&mut self, launch: Launch) -> Result<(), DeviceError> {
        self.enter()?;
        let blocks = u32::try_from(launch.threads.div_ceil(BLOCK as usize))
            .map_err(|_| DeviceError("the grid has too many cells for a device".to_owned()))?;
        let function = self.kernels[&(launch.is_double, launch.kernel)];
        let mut arguments = launch.arguments.map(|argument| argument.cast_mut().cast::<c_void>());
        // SAFETY: the arguments are those that the kernel takes.
        unsafe {
            result::launch_kernel(function, (blocks, 1, 1), (BLOCK, 1, 1), 0, self.stream, &mut arguments)
        }
        .map_err(failed(launch.kernel.name()))
    }

    fn crossed(&self) -> u64 {
        self.crossed
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn free_memory(&self) -> Option<f64> {
        self.enter().ok()?;
        result::mem_get_info().ok().map(|(free, _)| free as f64)
    }
}

impl Drop for Cuda {
    fn drop(&mut self) {
        self.reserved.clone().into_iter().for_each(|address| self.free(address));
        let _ = self.enter().map(|()| self.close_landing());
        // SAFETY: nothing is asked of the stream any more.
        let _ = self.enter().map(|()| unsafe { result::stream::destroy(self.stream) });
    }
}
