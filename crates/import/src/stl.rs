//! A surface as binary STL.

use crate::hull::Hull;

/// The bytes of a file, coordinates in metres.
pub(super) fn bytes(hull: &Hull) -> Vec<u8> {
    let mut bytes = vec![0_u8; 80];
    let head = b"UNITS=m";
    bytes[..head.len()].copy_from_slice(head);
    bytes.extend(u32::try_from(hull.triangles.len()).unwrap_or(u32::MAX).to_le_bytes());
    for triangle in &hull.triangles {
        // The normal follows from the corners.
        bytes.extend([0_u8; 12]);
        for corner in triangle {
            for value in hull.points[*corner] {
                bytes.extend((value as f32).to_le_bytes());
            }
        }
        bytes.extend([0_u8; 2]);
    }
    bytes
}
