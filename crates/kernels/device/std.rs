//! What the sources of `physics` and `kernels` need of `std`, for a device that has only `core`: the square
//! root. Other functions of floats are named in constructors, which the host alone calls.
#![no_std]
#![feature(core_intrinsics, rustc_attrs)]
#![allow(internal_features)]
#![rustc_coherence_is_core]

#[doc(no_inline)]
pub use core::*;

unsafe extern "C" {
    /// No kernel may call it: a call would leave its name in the assembly.
    fn there_is_no_library_on_the_device() -> !;
}

macro_rules! functions {
    ($real:ident, $sqrt:ident: $($name:ident($($argument:ty),*) -> $result:ty;)*) => {
        impl $real {
            #[inline(always)]
            pub fn sqrt(self) -> Self {
                // SAFETY: it takes any number.
                unsafe { intrinsics::$sqrt(self) }
            }

            $(pub fn $name(self, $(_: $argument),*) -> $result {
                // SAFETY: it is never called.
                unsafe { there_is_no_library_on_the_device() }
            })*
        }
    };
    ($real:ident, $sqrt:ident) => {
        functions! { $real, $sqrt:
            sin() -> Self; cos() -> Self; tan() -> Self; sin_cos() -> (Self, Self); ln() -> Self; powi(i32) -> Self;
        }
    };
}

functions!(f64, sqrtf64);
functions!(f32, sqrtf32);
