//! The memory of the program: the system's, with an end in words where there is none left.
#![allow(unsafe_code)] // an allocator is unsafe by its kind; this one passes on what it is asked

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;

/// Message where memory runs out.
const OUT_OF_MEMORY: &str = "error: not enough memory: a limit of this machine, of this process (ulimit -v, ulimit -d) or of a batch system \
                             was reached; make grid.cell larger, or the limit, or use fewer --threads\n";

/// The system's allocator. Where it has no memory the program ends here with exit code 2 instead of an abort:
/// a limit of the machine, of the process or of a batch system was reached, and a smaller request or a larger
/// limit is the cure.
pub(crate) struct Memory;

fn or_end(memory: *mut u8) -> *mut u8 {
    if memory.is_null() {
        // Neither the line nor standard error needs memory.
        let _ = std::io::stderr().write_all(OUT_OF_MEMORY.as_bytes());
        signal_hook::low_level::exit(2);
    }
    memory
}

// SAFETY: every call is passed on to the system's allocator as it is, and what that returns is returned.
unsafe impl GlobalAlloc for Memory {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as promised by the caller.
        or_end(unsafe { System.alloc(layout) })
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as promised by the caller.
        or_end(unsafe { System.alloc_zeroed(layout) })
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: as promised by the caller.
        unsafe { System.dealloc(memory, layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as promised by the caller.
        or_end(unsafe { System.realloc(memory, layout, size) })
    }
}
