//! The entry points of the kernels on a device. `scripts/ptx` compiles them, once for each precision.
#![no_std]
#![feature(abi_ptx, stdarch_nvptx)]

use core::arch::nvptx::{_block_dim_x, _block_idx_x, _thread_idx_x};
use core::prelude::rust_2024::*;
#[cfg(precision = "double")]
use kernels::double as real;
#[cfg(precision = "single")]
use kernels::single as real;
use kernels::launch::List;
#[cfg(precision = "double")]
use physics::double as laws;
#[cfg(precision = "single")]
use physics::single as laws;
use laws::{clay::Clay, menetrey_willam::MenetreyWillam, mohr_coulomb::MohrCoulomb, sand::Sand, von_mises::VonMises};
use real::Real;
use real::cells::Block;
use real::device::*;
use real::device_arrays::Arrays;
use real::device_remap::*;
use real::return_mapping::*;

macro_rules! entries {
    (() $($variant:ident $name:ident($type:ty): |$a:ident, $more:ident, $block:ident, $n:ident| $does:expr;)*) => {
        $(#[unsafe(no_mangle)]
        pub unsafe extern "ptx-kernel" fn $name(arrays: Arrays, more: $type) {
            let mut block = Block::new();
            // SAFETY: the solver hands over addresses of its arrays, and launches a thread for each number.
            unsafe {
                let number = _block_idx_x() as usize * _block_dim_x() as usize + _thread_idx_x() as usize;
                let ($a, $more, $block, $n) = (&arrays, &more, &mut block, number);
                $does
            }
        })*
    };
}

kernels::each_kernel!(entries,);

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
