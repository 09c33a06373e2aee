//! A plane that cuts a unit cell at a given volume fraction (PLIC).
//!
//! Normal from the volume fractions round the cell (Youngs 1984); plane constant and cut volume in closed
//! form (Scardovelli & Zaleski 2000). Everything is done in the cell's own unit coordinates.

/// A plane in a unit cell: soil is where `normal · x ≤ constant`, with the axes of negative normal components
/// mirrored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Absolute values of the normal's components, scaled to the sum 1.
    size: [f64; 3],
    /// Whether each axis is mirrored.
    mirrored: [bool; 3],
    /// Plane constant in mirrored coordinates.
    constant: f64,
}

impl Plane {
    /// The plane with the given normal (from soil to void, of any length) that encloses the volume fraction
    /// `fraction`.
    #[must_use]
    pub fn new(normal: [f64; 3], fraction: f64) -> Self {
        let sum = normal[0].abs() + normal[1].abs() + normal[2].abs();
        let size = if sum > 1e-300 { normal.map(|n| n.abs() / sum) } else { [0.0, 0.0, 1.0] };
        Self { size, mirrored: normal.map(|n| n < 0.0), constant: constant(size, fraction) }
    }

    /// Soil volume in the slab of the unit cell within `width` (0 to 1) of the low (or high) face of `axis`.
    #[must_use]
    pub fn slab(&self, axis: usize, high: bool, width: f64) -> f64 {
        let far = high != self.mirrored[axis];
        let start = if far { 1.0 - width } else { 0.0 };
        let mut size = self.size;
        let shifted = self.constant - size[axis] * start;
        size[axis] *= width;
        let sum = size[0] + size[1] + size[2];
        if sum <= 1e-300 {
            return if shifted >= 0.0 { width } else { 0.0 };
        }
        width * volume(size.map(|m| m / sum), shifted / sum)
    }
}

fn sorted(mut m: [f64; 3]) -> [f64; 3] {
    m.sort_by(f64::total_cmp);
    m
}

/// Volume of `{x in the unit cube: m·x ≤ a}`, `m ≥ 0` with sum 1 (Scardovelli & Zaleski 2000, eq. 4).
fn volume(m: [f64; 3], a: f64) -> f64 {
    let a = a.clamp(0.0, 1.0);
    if a > 0.5 { 1.0 - volume_below_half(sorted(m), 1.0 - a) } else { volume_below_half(sorted(m), a) }
}

fn volume_below_half([m1, m2, m3]: [f64; 3], a: f64) -> f64 {
    let m12 = m1 + m2;
    if a < m1 {
        a.powi(3) / (6.0 * m1 * m2 * m3)
    } else if a < m2 {
        // The corner term m1²/(6 m2 m3), also when m1 = 0.
        a * (a - m1) / (2.0 * m2 * m3) + m1 * m1 / (6.0 * m2 * m3)
    } else if a < m12.min(m3) {
        (a * a * (3.0 * m12 - a) + m1 * m1 * (m1 - 3.0 * a) + m2 * m2 * (m2 - 3.0 * a)) / (6.0 * m1 * m2 * m3)
    } else if m3 < m12 {
        let cubic = a * a * (3.0 - 2.0 * a)
            + m1 * m1 * (m1 - 3.0 * a)
            + m2 * m2 * (m2 - 3.0 * a)
            + m3 * m3 * (m3 - 3.0 * a);
        cubic / (6.0 * m1 * m2 * m3)
    } else {
        (2.0 * a - m12) / (2.0 * m3)
    }
}

/// The inverse of [`volume`].
fn constant(m: [f64; 3], fraction: f64) -> f64 {
    let fraction = fraction.clamp(0.0, 1.0);
    let m = sorted(m);
    if fraction > 0.5 {
        1.0 - constant_below_half(m, 1.0 - fraction)
    } else {
        constant_below_half(m, fraction)
    }
}

fn constant_below_half(m: [f64; 3], v: f64) -> f64 {
    let [m1, m2, m3] = m;
    let m12 = m1 + m2;
    let corner = if m2 > 0.0 { m1 * m1 / (6.0 * m2 * m3) } else { 0.0 };
    let edge = corner + 0.5 * (m2 - m1) / m3;
    let product = 6.0 * m1 * m2 * m3;
    if v < corner {
        (product * v).cbrt()
    } else if v < edge {
        0.5 * (m1 + (m1 * m1 + 8.0 * m2 * m3 * (v - corner)).sqrt())
    } else if m12 <= m3 {
        if v >= 0.5 * m12 / m3 {
            m3 * v + 0.5 * m12
        } else {
            root([m1.powi(3) + m2.powi(3) - product * v, -3.0 * (m1 * m1 + m2 * m2), 3.0 * m12, -1.0])
        }
    } else if v < volume_below_half(m, m3) {
        root([m1.powi(3) + m2.powi(3) - product * v, -3.0 * (m1 * m1 + m2 * m2), 3.0 * m12, -1.0])
    } else {
        let cubes = m1.powi(3) + m2.powi(3) + m3.powi(3);
        root([cubes - product * v, -3.0 * (m1 * m1 + m2 * m2 + m3 * m3), 3.0, -2.0])
    }
}

/// The middle one of the three real roots of `a0 + a1 x + a2 x² + a3 x³`.
fn root([a0, a1, a2, a3]: [f64; 4]) -> f64 {
    let (a0, a1, a2) = (a0 / a3, a1 / a3, a2 / a3);
    let p = (a1 / 3.0 - a2 * a2 / 9.0).min(-1e-300);
    let q = (a1 * a2 - 3.0 * a0) / 6.0 - a2.powi(3) / 27.0;
    let angle = (q / (-p * p * p).sqrt()).clamp(-1.0, 1.0).acos() / 3.0;
    (-p).sqrt() * (3.0_f64.sqrt() * angle.sin() - angle.cos()) - a2 / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normals() -> Vec<[f64; 3]> {
        let mut all =
            vec![[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 1.0], [1.0, 1.0, 1.0], [1e-9, 1.0, -1e-5]];
        for a in 1..10 {
            for b in 1..10 {
                all.push([f64::from(a) - 5.3, f64::from(b) - 4.1, 2.0]);
            }
        }
        all
    }

    #[test]
    fn the_plane_encloses_its_volume_fraction() {
        for n in normals() {
            for step in 1..200 {
                let fraction = f64::from(step) / 200.0;
                let plane = Plane::new(n, fraction);
                for axis in 0..3 {
                    let whole = plane.slab(axis, true, 1.0);
                    assert!((whole - fraction).abs() < 1e-9, "{n:?} {fraction} {whole}");
                    let sum = plane.slab(axis, true, 0.3) + plane.slab(axis, false, 0.7);
                    assert!((sum - fraction).abs() < 1e-9, "{n:?} {fraction} {sum}");
                }
            }
        }
    }

    #[test]
    fn a_flat_surface_is_cut_flat() {
        let plane = Plane::new([0.0, 0.0, 1.0], 0.4);
        assert!((plane.slab(2, false, 0.3) - 0.3).abs() < 1e-12);
        assert!(plane.slab(2, true, 0.3).abs() < 1e-12);
        assert!((plane.slab(0, true, 0.25) - 0.1).abs() < 1e-12);
    }
}
