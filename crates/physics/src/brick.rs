//! The eight-node brick with one integration point on a box cell: velocity gradient and hourglass control.
//!
//! On a box the gradient at the centre needs only four sums over the eight corners (Q1P0; Flanagan &
//! Belytschko 1981): the plain sum and the sums signed by the side along x, y, z. These four patterns and the
//! four hourglass patterns are an orthogonal basis of the corner values, so the hourglass component is what
//! remains after subtracting the four sums: a viscous force against it needs no hourglass vectors.

use super::Real;

/// Sums of one velocity component over the corners of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sums {
    /// Plain sum Σ v.
    pub plain: Real,
    /// Sums signed by the side: Σ ±v along x, y, z.
    pub side: [Real; 3],
    /// Sum of squares Σ v².
    pub square: Real,
}

impl Sums {
    /// Sums over corner values; `v[row]` holds the corners at low and high x of the rows (y, z) = (0,0),
    /// (1,0), (0,1), (1,1).
    #[inline(always)]
    #[must_use]
    pub fn of(v: [[Real; 2]; 4]) -> Self {
        let sum = v.map(|[low, high]| low + high);
        let difference = v.map(|[low, high]| high - low);
        let square = v.map(|[low, high]| low * low + high * high);
        Self {
            plain: (sum[0] + sum[1]) + (sum[2] + sum[3]),
            side: [
                (difference[0] + difference[1]) + (difference[2] + difference[3]),
                (sum[1] - sum[0]) + (sum[3] - sum[2]),
                (sum[2] - sum[0]) + (sum[3] - sum[1]),
            ],
            square: (square[0] + square[1]) + (square[2] + square[3]),
        }
    }

    /// Sum of squares of the hourglass component, times eight: Σ over the patterns of (Γ·v)².
    #[inline(always)]
    #[must_use]
    pub fn hourglass(&self) -> Real {
        let [x, y, z] = self.side;
        8.0 * self.square - self.plain * self.plain - (x * x + y * y + z * z)
    }
}

/// Coefficient of the hourglass force [kg/s]: `ε ρ c l² / 4` (Flanagan & Belytschko 1981), to be scaled by
/// the volume fraction. The force on a corner is −coefficient · (8 v − plain ∓ side_x ∓ side_y ∓ side_z).
#[inline(always)]
#[must_use]
pub fn hourglass_coefficient(epsilon: Real, density: Real, wave_speed: Real, length: Real) -> Real {
    0.25 * epsilon * density * wave_speed * length * length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_field_has_its_gradient_and_no_hourglass() {
        // v = 2 + 3x − 5y + 7z on the unit cube.
        let v = |x: Real, y: Real, z: Real| 2.0 + 3.0 * x - 5.0 * y + 7.0 * z;
        let row = |y, z| [v(0.0, y, z), v(1.0, y, z)];
        let sums = Sums::of([row(0.0, 0.0), row(1.0, 0.0), row(0.0, 1.0), row(1.0, 1.0)]);
        assert_eq!(sums.side.map(|s| s / 4.0), [3.0, -5.0, 7.0]);
        assert!(sums.hourglass().abs() < 1e-12);
    }

    #[test]
    fn a_pure_hourglass_field_is_all_hourglass() {
        let sums = Sums::of([[1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]]);
        assert_eq!((sums.plain, sums.side), (0.0, [0.0; 3]));
        assert_eq!(sums.hourglass(), 64.0);
    }

    #[test]
    fn an_hourglass_decays_at_the_rate_of_its_coefficient() {
        // Corners of mass ρ l³/8 against the force 8 C v decay at 16 ε c/l: here 16 · 0.1 · 150 m/s/0.5 m.
        let (density, length): (Real, Real) = (1600.0, 0.5);
        let coefficient = hourglass_coefficient(0.1, density, 150.0, length);
        assert!((64.0 * coefficient / (density * length.powi(3)) - 480.0).abs() < 1e-3);
    }
}
