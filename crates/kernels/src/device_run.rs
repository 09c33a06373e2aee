//! What a thread of any kernel does, by the kernel's name.
#![allow(unsafe_code)] // The arrays of a device are known by their addresses alone.

use super::Real;
use super::cells::Block;
use super::device::{
    CLAY, Material, PLAIN, SAND, give, move_node, strain, sum_lane, sum_plane, sum_row, take, total,
};
use super::device_arrays::Arrays;
use super::device_remap::{
    Averaging, Closed, Elasticity, Pass, carry, carry_mass, carry_momentum, close, collect_density,
    difference, displaced_volumes, dual_flux, dual_reach, mass_flux, mix, new_fractions, nodal_mass, reach,
    row_energies, shift, spread_density, stop_massless, store_density, take_back, undo_displacement,
    volume_flux, volume_fraction,
};
use super::physics::clay::Clay;
use super::physics::menetrey_willam::MenetreyWillam;
use super::physics::mohr_coulomb::MohrCoulomb;
use super::physics::sand::Sand;
use super::physics::von_mises::VonMises;
use super::return_mapping::{clay, menetrey_willam, mohr_coulomb, sand, von_mises};
use crate::launch::{Kernel, List};

macro_rules! run {
    (() $($variant:ident $name:ident($type:ty): |$a:ident, $more:ident, $block:ident, $n:ident| $does:expr;)*) => {
        /// Does what a thread of a kernel does.
        ///
        /// # Safety
        /// The arrays must be those of a grid, `more` the address of what the kernel is handed over besides,
        /// and no other thread may have the same number.
        pub unsafe fn run(kernel: Kernel, arrays: &Arrays, more: *const u8, block: &mut Block, number: usize) {
            match kernel {
                $(Kernel::$variant => {
                    // SAFETY: as the caller promises.
                    unsafe {
                        let ($a, $more, $block, $n) = (arrays, &*more.cast::<$type>(), block, number);
                        $does;
                    }
                })*
            }
        }

        /// Size of what a kernel is handed over besides the arrays [bytes].
        #[must_use]
        pub fn size_of_more(kernel: Kernel) -> usize {
            match kernel {
                $(Kernel::$variant => size_of::<$type>(),)*
            }
        }
    };
}

crate::each_kernel!(run,);
