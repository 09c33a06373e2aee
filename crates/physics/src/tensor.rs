//! Symmetric second-order tensors as six numbers: xx, yy, zz, xy, yz, xz.

use super::select::max;
use super::{MERIDIAN, NO_STRESS, Real};

/// A symmetric tensor: xx, yy, zz, xy, yz, xz.
pub type Symmetric = [Real; 6];

/// A factor, since a division takes as long as a dozen multiplications.
pub(crate) const THIRD: Real = 1.0 / 3.0;

/// One third of the trace.
#[inline(always)]
#[must_use]
pub fn mean(a: Symmetric) -> Real {
    (a[0] + a[1] + a[2]) * THIRD
}

/// The deviator: the tensor minus its mean on the diagonal.
#[inline(always)]
#[must_use]
pub fn deviator(a: Symmetric) -> Symmetric {
    let m = mean(a);
    [a[0] - m, a[1] - m, a[2] - m, a[3], a[4], a[5]]
}

/// Double contraction `a : b`.
#[inline(always)]
#[must_use]
pub fn contract(a: Symmetric, b: Symmetric) -> Real {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5])
}

/// The square `a · a`.
#[inline(always)]
#[must_use]
pub fn square(a: Symmetric) -> Symmetric {
    let [xx, yy, zz, xy, yz, xz] = a;
    [
        xx * xx + xy * xy + xz * xz,
        xy * xy + yy * yy + yz * yz,
        xz * xz + yz * yz + zz * zz,
        xx * xy + xy * yy + xz * yz,
        xy * xz + yy * yz + yz * zz,
        xx * xz + xy * yz + xz * zz,
    ]
}

/// Von Mises equivalent stress √(3 J₂).
#[inline(always)]
#[must_use]
pub fn mises(a: Symmetric) -> Real {
    let s = deviator(a);
    (1.5 * contract(s, s)).sqrt()
}

/// Jaumann rate of a tensor that rotates with the material: `w a − a w`, with the spin
/// `w = [w_xy, w_yz, w_xz]`, the upper triangle of the skew-symmetric part of the velocity gradient,
/// `w_ij = ½(∂v_i/∂x_j − ∂v_j/∂x_i)`.
#[inline(always)]
#[must_use]
pub fn jaumann(a: Symmetric, w: [Real; 3]) -> Symmetric {
    let [xx, yy, zz, xy, yz, xz] = a;
    let [wxy, wyz, wxz] = w;
    [
        2.0 * (wxy * xy + wxz * xz),
        2.0 * (wyz * yz - wxy * xy),
        -2.0 * (wxz * xz + wyz * yz),
        wxy * (yy - xx) + wxz * yz + wyz * xz,
        wyz * (zz - yy) - wxy * xz - wxz * xy,
        wxz * (zz - xx) + wxy * yz - wyz * xy,
    ]
}

/// Principal values in closed form, and the two deviatoric directions in which they are expressed.
///
/// Without eigenvectors and trigonometric functions: `cos 3θ` and `sin 3θ` follow from two invariants that
/// are accurate at the meridians (where the arc cosine of the usual formula loses half the digits), the
/// complex cube root from three Newton steps.
#[derive(Clone, Copy, Debug)]
pub struct Spectrum {
    /// Mean value.
    pub mean: Real,
    /// Norm of the deviator, √(s:s).
    pub norm: Real,
    /// Principal values, largest first.
    pub principal: [Real; 3],
    /// Unit tensor along the deviator.
    pub radial: Symmetric,
    /// Deviatoric unit tensor perpendicular to it, towards larger Lode angles; 0 on a meridian.
    pub hoop: Symmetric,
    /// Principal values of `radial`.
    pub radial_principal: [Real; 3],
    /// Principal values of `hoop`.
    pub hoop_principal: [Real; 3],
}

pub(crate) const SQRT_3: Real = 1.732_050_807_568_877_2;
const SQRT_2_3: Real = 0.816_496_580_927_726;

impl Spectrum {
    /// Spectrum of `a`. Finite for every finite `a`.
    #[inline(always)]
    #[must_use]
    pub fn of(a: Symmetric) -> Self {
        let mean = mean(a);
        let s = deviator(a);
        let norm = contract(s, s).sqrt();
        let inverse = if norm > NO_STRESS { 1.0 / norm } else { 0.0 };
        let radial = s.map(|x| x * inverse);
        // t = r² − ⅓ I has a component perpendicular to r of the norm sin 3θ / √6.
        let mut t = square(radial);
        let third = contract(radial, radial) * THIRD;
        t[0] -= third;
        t[1] -= third;
        t[2] -= third;
        let along = contract(t, radial);
        let mut cross: Symmetric = [0.0; 6];
        for n in 0..6 {
            cross[n] = t[n] - along * radial[n];
        }
        let cross_norm = contract(cross, cross).sqrt();
        let cross_inverse = if cross_norm > MERIDIAN { -1.0 / cross_norm } else { 0.0 };
        let hoop = cross.map(|x| x * cross_inverse);
        let (cos, sin) = third_of_angle(along, cross_norm);
        let radial_principal = deviator_values(cos, sin);
        let hoop_principal = deviator_values(-sin, cos);
        let principal = radial_principal.map(|x| mean + norm * x);
        Self { mean, norm, principal, radial, hoop, radial_principal, hoop_principal }
    }

    /// Cosine and sine of the Lode angle Θ: 0 where the two smaller principal values are equal, 60° where the
    /// two larger are.
    #[inline(always)]
    #[must_use]
    pub fn lode(&self) -> (Real, Real) {
        (self.radial_principal[0] / SQRT_2_3, -self.hoop_principal[0] / SQRT_2_3)
    }

    /// Principal values of the tensor with this mean and the deviator components `along` `radial` and
    /// `across`, along `hoop`.
    #[inline(always)]
    #[must_use]
    pub fn principal_at(&self, mean: Real, along: Real, across: Real) -> [Real; 3] {
        let (a, b) = (self.radial_principal, self.hoop_principal);
        [
            mean + along * a[0] + across * b[0],
            mean + along * a[1] + across * b[1],
            mean + along * a[2] + across * b[2],
        ]
    }

    /// The tensor with the same axes and other principal values.
    #[inline(always)]
    #[must_use]
    pub fn with_principal(&self, value: [Real; 3]) -> Symmetric {
        let mean = (value[0] + value[1] + value[2]) * THIRD;
        let dot =
            |b: [Real; 3]| (value[0] - mean) * b[0] + (value[1] - mean) * b[1] + (value[2] - mean) * b[2];
        let (along, across) = (dot(self.radial_principal), dot(self.hoop_principal));
        let mut out: Symmetric = [mean, mean, mean, 0.0, 0.0, 0.0];
        for n in 0..6 {
            out[n] += along * self.radial[n] + across * self.hoop[n];
        }
        out
    }
}

/// Cosine and sine of θ in [0, 60°] from numbers in the ratio cos 3θ : sin 3θ (sine not negative).
#[inline(always)]
pub(crate) fn third_of_angle(cos3: Real, sin3: Real) -> (Real, Real) {
    let size = (cos3 * cos3 + sin3 * sin3).sqrt();
    let scale = if size > 1e-12 { 1.0 / size } else { 0.0 };
    let (a, b) = if size > 1e-12 { (cos3 * scale, sin3 * scale) } else { (1.0, 0.0) };
    let mut c = 0.75 + 0.25 * a;
    let mut s = max(1.0 - c * c, 0.0).sqrt();
    // Newton for z³ = w on the unit circle, where 1/z² is the conjugate's square. An error e of the angle
    // becomes e³/3; the initial error is below 0.21, so the third step is exact to rounding.
    for _ in 0..3 {
        let (re, im) = (c * c - s * s, 2.0 * c * s);
        let x = 2.0 * c + a * re + b * im;
        let y = 2.0 * s + b * re - a * im;
        let length = 1.0 / (x * x + y * y).sqrt();
        c = x * length;
        s = y * length;
    }
    (c, s)
}

/// Principal values of the unit deviator at Lode angle θ, largest first.
#[inline(always)]
fn deviator_values(cos: Real, sin: Real) -> [Real; 3] {
    [
        SQRT_2_3 * cos,
        SQRT_2_3 * (-0.5 * cos + 0.5 * SQRT_3 * sin),
        SQRT_2_3 * (-0.5 * cos - 0.5 * SQRT_3 * sin),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tolerance for rounding, relative to the size of the numbers.
    const ROUNDING: Real = 20.0 * Real::EPSILON;

    fn samples() -> Vec<Symmetric> {
        let mut seed = 7_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as Real / (1_u64 << 53) as Real - 0.5
        };
        let mut all: Vec<Symmetric> = (0..2000).map(|_| std::array::from_fn(|_| 1e5 * next())).collect();
        all.extend([
            [-3.0, -3.0, -7.0, 0.0, 0.0, 0.0],
            [-3.0, -7.0, -7.0, 0.0, 0.0, 0.0],
            [2.0; 6],
            [0.0; 6],
        ]);
        all
    }

    #[test]
    fn spectrum_has_the_invariants_of_the_tensor() {
        for a in samples() {
            let p = Spectrum::of(a).principal;
            let scale = 1.0 + mises(a);
            assert!(p[0] >= p[1] && p[1] >= p[2], "{a:?} {p:?}");
            assert!((p[0] + p[1] + p[2] - 3.0 * mean(a)).abs() < ROUNDING * scale);
            let q = (0.5 * ((p[0] - p[1]).powi(2) + (p[1] - p[2]).powi(2) + (p[2] - p[0]).powi(2))).sqrt();
            assert!((q - mises(a)).abs() < ROUNDING * scale);
            let s = deviator(a);
            let j3 = contract(square(s), s) / 3.0;
            let m = mean(a);
            assert!(((p[0] - m) * (p[1] - m) * (p[2] - m) - j3).abs() < ROUNDING * scale.powi(3));
        }
    }

    #[test]
    fn the_same_principal_values_restore_the_tensor() {
        for a in samples() {
            let spectrum = Spectrum::of(a);
            let b = spectrum.with_principal(spectrum.principal);
            for n in 0..6 {
                assert!((a[n] - b[n]).abs() < ROUNDING * (1.0 + mises(a)), "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn spin_keeps_the_invariants() {
        for a in samples() {
            let rate = jaumann(a, [0.3, -0.7, 0.2]);
            let size = 1.0 + contract(a, a);
            assert!(mean(rate).abs() < ROUNDING * size.sqrt() && contract(rate, a).abs() < ROUNDING * size);
        }
    }
}
