//! A device that the processor stands in for: the same kernels on the same arrays, in the order of a grid of
//! blocks of threads, the blocks in random order.
#![allow(unsafe_code)] // Memory that is known by its addresses, as that of a device.

use super::driver::{Address, DeviceError, Driver, Launch};
use rustc_hash::FxHashMap;

/// Threads in a block.
const BLOCK: usize = 128;

/// The stand-in.
#[derive(Debug, Default)]
pub struct Replay {
    memory: FxHashMap<u64, Vec<u64>>,
    /// State of the generator of random orders.
    seed: u64,
    crossed: u64,
    /// What a copy has taken that was begun.
    begun: Option<Vec<u8>>,
    /// Memory that may be reserved [bytes], if there is a limit.
    pub limit: Option<usize>,
    /// Launches after which every other one fails, as when a device is lost.
    pub lost_after: Option<u64>,
    launched: u64,
}

impl Replay {
    /// A number below `end`, from a linear congruential generator.
    fn random(&mut self, end: usize) -> usize {
        self.seed = self.seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.seed >> 33) as usize) % end
    }

    fn require(&self, at: Address, bytes: usize) -> Result<(), DeviceError> {
        let holds = |(start, words): (&u64, &Vec<u64>)| {
            at.0 >= *start && at.0 + bytes as u64 <= start + 8 * words.len() as u64
        };
        let is_known = self.memory.iter().any(holds);
        is_known.then_some(()).ok_or_else(|| DeviceError("an address outside all memory".to_owned()))
    }
}

impl Driver for Replay {
    fn allocate(&mut self, bytes: usize) -> Result<Address, DeviceError> {
        let taken: usize = self.memory.values().map(|words| 8 * words.len()).sum();
        if self.limit.is_some_and(|limit| taken + bytes > limit) {
            return Err(DeviceError(format!("{bytes} bytes are not free")));
        }
        let mut words = vec![0_u64; bytes.div_ceil(8).max(1)];
        let address = words.as_mut_ptr().expose_provenance() as u64;
        self.memory.insert(address, words);
        Ok(Address(address))
    }

    fn free(&mut self, address: Address) {
        self.memory.remove(&address.0);
    }

    fn clear(&mut self, at: Address, bytes: usize) -> Result<(), DeviceError> {
        self.require(at, bytes)?;
        // SAFETY: the memory reserved there is as long.
        unsafe { at.pointer::<u8>().write_bytes(0, bytes) };
        Ok(())
    }

    fn write(&mut self, to: Address, bytes: &[u8]) -> Result<(), DeviceError> {
        self.require(to, bytes.len())?;
        self.crossed += bytes.len() as u64;
        // SAFETY: the memory reserved there is as long.
        unsafe { to.pointer::<u8>().copy_from_nonoverlapping(bytes.as_ptr(), bytes.len()) };
        Ok(())
    }

    fn read(&mut self, from: Address, bytes: &mut [u8]) -> Result<(), DeviceError> {
        self.require(from, bytes.len())?;
        self.crossed += bytes.len() as u64;
        // SAFETY: the memory reserved there is as long.
        unsafe { bytes.as_mut_ptr().copy_from_nonoverlapping(from.pointer::<u8>(), bytes.len()) };
        Ok(())
    }

    fn begin_read(&mut self, from: Address, bytes: usize) -> Result<(), DeviceError> {
        let mut begun = vec![0; bytes];
        self.read(from, &mut begun)?;
        self.begun = Some(begun);
        Ok(())
    }

    fn end_read(&mut self, bytes: &mut [u8]) -> Result<(), DeviceError> {
        let begun = self.begun.take().filter(|begun| begun.len() == bytes.len());
        bytes.copy_from_slice(&begun.ok_or_else(|| DeviceError("no copy of this was begun".to_owned()))?);
        Ok(())
    }

    fn launch(&mut self, launch: Launch) -> Result<(), DeviceError> {
        self.launched += 1;
        if self.lost_after.is_some_and(|last| self.launched > last) {
            return Err(DeviceError("the device is lost".to_owned()));
        }
        let mut blocks: Vec<usize> = (0..launch.threads.div_ceil(BLOCK)).collect();
        for n in (1..blocks.len()).rev() {
            let other = self.random(n + 1);
            blocks.swap(n, other);
        }
        for block in blocks {
            // The last block has more threads than there is work for.
            (block * BLOCK..(block + 1) * BLOCK).for_each(&mut *launch.on_processor);
        }
        Ok(())
    }

    fn crossed(&self) -> u64 {
        self.crossed
    }

    fn name(&self) -> &str {
        "the processor in place of a graphics card"
    }

    fn free_memory(&self) -> Option<f64> {
        None
    }
}
