//! The repair of a surface into a closed solid: points on a coarse lattice, so that many coincide, lie on
//! edges and in faces.
#![no_main]

use geometry::{MassProperties, Mesh, repaired};
use glam::DVec3;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some((count, rest)) = data.split_first() else { return };
    let (points, triangles) = rest.split_at(rest.len().min(3 * usize::from(*count)));
    let point = |x: &[u8]| DVec3::from_array([0, 1, 2].map(|axis| f64::from(x[axis].cast_signed())));
    let surface = Mesh {
        points: points.chunks_exact(3).map(point).collect(),
        triangles: triangles.chunks_exact(3).map(|t| [0, 1, 2].map(|n| u32::from(t[n]))).collect(),
    };
    if let Ok(found) = repaired(&surface) {
        let volume = MassProperties::of_mesh(found.solid.surface()).volume;
        assert!(volume > 0.0 && volume.is_finite() && found.shells > found.cavities);
    }
});
