//! A plane that cuts a unit cell at a given volume fraction (PLIC).
//!
//! Normal from the volume fractions round the cell (Youngs 1984); plane constant and cut volume in closed
//! form (Scardovelli & Zaleski 2000). Everything is done in the cell's own unit coordinates, and by
//! arithmetic and square roots alone: these have the same bits on every processor.

use crate::double::select::{clamp, max, min};
use crate::double::tensor::{SQRT_3, third_of_angle};

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

fn sorted([a, b, c]: [f64; 3]) -> [f64; 3] {
    let (low, high) = (min(a, b), max(a, b));
    let middle = min(high, c);
    [min(low, middle), max(low, middle), max(high, c)]
}

/// Volume of `{x in the unit cube: m·x ≤ a}`, `m ≥ 0` with sum 1 (Scardovelli & Zaleski 2000, eq. 4).
fn volume(m: [f64; 3], a: f64) -> f64 {
    let a = clamp(a, 0.0, 1.0);
    let is_above = a > 0.5;
    let below = volume_below_half(sorted(m), if is_above { 1.0 - a } else { a });
    if is_above { 1.0 - below } else { below }
}

fn volume_below_half([m1, m2, m3]: [f64; 3], a: f64) -> f64 {
    let m12 = m1 + m2;
    if a < m1 {
        a * a * a / (6.0 * m1 * m2 * m3)
    } else if a < m2 {
        // The corner term m1²/(6 m2 m3), also when m1 = 0.
        a * (a - m1) / (2.0 * m2 * m3) + m1 * m1 / (6.0 * m2 * m3)
    } else if a < min(m12, m3) {
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
    let fraction = clamp(fraction, 0.0, 1.0);
    let is_above = fraction > 0.5;
    let below = constant_below_half(sorted(m), if is_above { 1.0 - fraction } else { fraction });
    if is_above { 1.0 - below } else { below }
}

fn constant_below_half(m: [f64; 3], v: f64) -> f64 {
    let [m1, m2, m3] = m;
    let m12 = m1 + m2;
    let corner = if m2 > 0.0 { m1 * m1 / (6.0 * m2 * m3) } else { 0.0 };
    let edge = corner + 0.5 * (m2 - m1) / m3;
    let product = 6.0 * m1 * m2 * m3;
    if v < corner {
        return cube_root(product * v);
    }
    if v < edge {
        return 0.5 * (m1 + (m1 * m1 + 8.0 * m2 * m3 * (v - corner)).sqrt());
    }
    if m12 <= m3 && v >= 0.5 * m12 / m3 {
        return m3 * v + 0.5 * m12;
    }
    let (squares, cubes) = (m1 * m1 + m2 * m2, m1 * m1 * m1 + m2 * m2 * m2);
    if m12 <= m3 || v < volume_below_half(m, m3) {
        root([cubes - product * v, -3.0 * squares, 3.0 * m12, -1.0])
    } else {
        root([cubes + m3 * m3 * m3 - product * v, -3.0 * (squares + m3 * m3), 3.0, -2.0])
    }
}

/// The middle one of the three real roots of `a0 + a1 x + a2 x² + a3 x³`: Viète's formula, with a third of
/// the angle from complex numbers.
fn root([a0, a1, a2, a3]: [f64; 4]) -> f64 {
    let (a0, a1, a2) = (a0 / a3, a1 / a3, a2 / a3);
    let p = min(a1 / 3.0 - a2 * a2 / 9.0, -1e-300);
    let q = (a1 * a2 - 3.0 * a0) / 6.0 - a2 * a2 * a2 / 27.0;
    let cos3 = clamp(q / (-p * p * p).sqrt(), -1.0, 1.0);
    let (cos, sin) = third_of_angle(cos3, ((1.0 - cos3) * (1.0 + cos3)).sqrt());
    (-p).sqrt() * (SQRT_3 * sin - cos) - a2 / 3.0
}

/// Cube root of a number that is not negative, to within two units in the last place, by arithmetic alone:
/// the same bits on every processor, which a library does not promise.
fn cube_root(x: f64) -> f64 {
    /// 2⁵⁴, and its cube root: brings the subnormal numbers among the normal ones.
    const UP: [f64; 2] = [18_014_398_509_481_984.0, 262_144.0];
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let (x, back) = if x < 1e-290 { (x * UP[0], 1.0 / UP[1]) } else { (x, 1.0) };
    // A third of the exponent: right to 6 %. Halley's steps (1694) cube the error: 8e-5, 2e-13, none.
    let mut root = f64::from_bits(x.to_bits() / 3 + 0x2a9f_7893_0000_0000);
    for _ in 0..3 {
        let cube = root * root * root;
        root *= (cube + 2.0 * x) / (2.0 * cube + x);
    }
    root * back
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
    fn cube_roots_are_right_to_two_units_in_the_last_place() {
        let mut x = 1.7e-321;
        while x < 1e300 {
            let units = (cube_root(x).to_bits() as i64 - x.cbrt().to_bits() as i64).abs();
            assert!(units <= 2, "{x}: {units}");
            x *= 1.37;
        }
        assert_eq!([0.0, 1.0, f64::INFINITY].map(cube_root), [0.0, 1.0, f64::INFINITY]);
    }

    #[test]
    fn the_middle_root_is_that_of_the_trigonometric_formula() {
        for n in 0..=1000 {
            let cos3 = (f64::from(n) / 500.0 - 1.0).clamp(-1.0, 1.0);
            let angle = cos3.acos() / 3.0;
            // x³ − 3 x − 2 q, whose roots are 2 cos of a third of the angle, and of 120° from it.
            let found = root([-2.0 * cos3, -3.0, 0.0, 1.0]);
            let exact = SQRT_3 * angle.sin() - angle.cos();
            // At a double root half the digits are lost by either formula.
            let tolerance = if n == 0 || n == 1000 { 2e-8 } else { 1e-13 };
            assert!((found - exact).abs() < tolerance, "{cos3}: {found} {exact}");
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
