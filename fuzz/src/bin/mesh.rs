//! Files of surfaces, each read as every format.
#![no_main]

use coulter_fuzz::file;
use input::mesh_file::read;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    for name in ["surface.stl", "surface.obj", "surface.ply"] {
        match read(&file(name, data), Some(("mm", 1e-3))) {
            Ok(found) => assert!(found.report.volume > 0.0 && found.report.triangles >= 4),
            Err(problem) => assert!(!problem.message.is_empty() && !problem.cure.is_empty()),
        }
    }
});
