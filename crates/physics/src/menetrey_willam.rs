//! The Mohr–Coulomb yield surface with the smooth flow potential of Menétrey and Willam (1995), as in Abaqus.
//!
//! With p the pressure, q the Mises stress and Θ the Lode angle (0 in triaxial extension, 60° in
//! compression): yield F = R_mc q − p tan φ − c; flow G = √((ε c tan ψ)² + (R_mw q)²) − p tan ψ. R_mc is the
//! hexagon, R_mw an ellipse through its corners on both meridians (for the default eccentricity e). The
//! potential has no corners, so one formula covers the whole surface: a cutting-plane return mapping (Ortiz
//! and Simo 1986) in the deviatoric plane, followed by a radial scaling to F = 0, which is exact because F is
//! homogeneous in q.

use super::Real;
use super::elastic::Elastic;
use super::mohr_coulomb::MohrCoulomb;
use super::select::max;
use super::tensor::{Spectrum, Symmetric};
use super::yield_law::{Point, Returned, YieldLaw};

const SQRT_1_5: Real = 1.224_744_871_391_589;
/// Rounding of a returned pressure, over the pressure of the trial stress.
const ROUNDING: Real = 10.0 * Real::EPSILON;

/// Mohr–Coulomb with the potential of Menétrey and Willam.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct MenetreyWillam {
    pub(crate) elastic: Elastic,
    /// The yield surface.
    pub(crate) surface: MohrCoulomb,
    pub(crate) tan_friction: Real,
    pub(crate) tan_dilation: Real,
    pub(crate) cohesion: Real,
    /// Coefficients of R_mc over sin Θ and cos Θ.
    pub(crate) hexagon: [Real; 2],
    /// R_mc on the compression meridian, the scale of R_mw.
    pub(crate) meridian: Real,
    /// 1 − e² and 2e − 1.
    pub(crate) ellipse: [Real; 2],
    /// (ε c tan ψ)² [Pa²].
    pub(crate) offset: Real,
}

/// Eccentricities of the flow potential, with the names and defaults of Abaqus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eccentricity {
    /// ε ≥ 0: the rate at which the hyperbola in the meridional plane approaches its asymptote.
    pub meridional: Real,
    /// e, ½ < e ≤ 1: the out-of-roundness of the ellipse in the deviatoric plane; 1 is a circle.
    pub deviatoric: Real,
}

impl Eccentricity {
    /// The default: ε = 0.1 and e = (3 − sin φ)/(3 + sin φ), for which the ellipse passes through the
    /// hexagon's corners; φ in radians.
    #[must_use]
    pub fn usual(friction: Real) -> Self {
        Self { meridional: 0.1, deviatoric: (3.0 - friction.sin()) / (3.0 + friction.sin()) }
    }
}

impl MenetreyWillam {
    /// The law from the friction angle 0 ≤ φ < 90° [rad], dilation angle 0 ≤ ψ ≤ φ [rad], cohesion c ≥ 0
    /// [Pa], tension cut-off [Pa] (at most c cot φ has an effect) and the eccentricities of the potential.
    #[must_use]
    pub fn new(
        elastic: Elastic,
        friction: Real,
        dilation: Real,
        cohesion: Real,
        tension_cutoff: Real,
        shape: Eccentricity,
    ) -> Self {
        let (a, b) = (1.0 / (Real::sqrt(3.0) * friction.cos()), friction.tan() / 3.0);
        let root = 0.5 * Real::sqrt(3.0);
        let e = shape.deviatoric;
        Self {
            elastic,
            surface: MohrCoulomb::new(elastic, friction, dilation, cohesion, tension_cutoff),
            tan_friction: friction.tan(),
            tan_dilation: dilation.tan(),
            cohesion,
            hexagon: [0.5 * a - root * b, root * a + 0.5 * b],
            meridian: (3.0 - friction.sin()) / (6.0 * friction.cos()),
            ellipse: [1.0 - e * e, 2.0 * e - 1.0],
            offset: (shape.meridional * cohesion * dilation.tan()).powi(2),
        }
    }

    /// Double-precision parameters, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::menetrey_willam::MenetreyWillam) -> Self {
        Self {
            elastic: Elastic::cast(&exact.elastic),
            surface: MohrCoulomb::cast(&exact.surface),
            tan_friction: exact.tan_friction as Real,
            tan_dilation: exact.tan_dilation as Real,
            cohesion: exact.cohesion as Real,
            hexagon: exact.hexagon.map(|factor| factor as Real),
            meridian: exact.meridian as Real,
            ellipse: exact.ellipse.map(|factor| factor as Real),
            offset: exact.offset as Real,
        }
    }

    /// The yield surface.
    #[must_use]
    pub fn surface(&self) -> &MohrCoulomb {
        &self.surface
    }

    /// Smallest plastic dissipation over all Lode angles for c = 0: (tan φ R_mw/R_mc − tan ψ)/tan φ. Negative
    /// for ψ close to φ, where flow would create energy, because the ellipse lies outside the hexagon's
    /// sides.
    #[must_use]
    pub fn least_dissipation(&self) -> Real {
        let at = |degrees: u16| {
            let (sin, cos) = Real::from(degrees).to_radians().sin_cos();
            self.ellipse(cos, sin).0 / self.hexagon(cos, sin).0
        };
        let ratio = (0..=60).map(at).fold(Real::INFINITY, Real::min);
        if self.tan_friction > 0.0 { ratio - self.tan_dilation / self.tan_friction } else { ratio }
    }

    /// One cutting-plane step; `trial` is cosine and sine of the Lode angle of the trial stress.
    #[inline(always)]
    fn cutting_plane_step(&self, from: Iterate, trial: (Real, Real), dilates: bool) -> Iterate {
        let (bulk, shear) = (self.elastic.bulk, self.elastic.shear);
        let tan_dilation = if dilates { self.tan_dilation } else { 0.0 };
        let offset = if dilates { self.offset } else { 0.0 };
        let Iterate { x, y, pressure, lode } = from;
        let distance = (x * x + y * y).sqrt();
        let q = SQRT_1_5 * distance;
        let (hexagon, hexagon_slope) = self.hexagon(lode.0, lode.1);
        let (ellipse, ellipse_slope) = self.ellipse(lode.0, lode.1);
        let length = (offset + (ellipse * q) * (ellipse * q)).sqrt();
        let scale = if length > 0.0 { q / length } else { 0.0 };
        let (radial, hoop) = (ellipse * ellipse * scale, ellipse * ellipse_slope * scale);
        let excess = hexagon * q - pressure * self.tan_friction - self.cohesion;
        let stiffness =
            3.0 * shear * (hexagon * radial + hexagon_slope * hoop) + bulk * self.tan_friction * tan_dilation;
        // Without shear stress the flow has no direction; the excess is removed at the apex.
        let multiplier = if (excess > 0.0) & (stiffness > 0.0) { excess / stiffness } else { 0.0 };
        let step = 2.0 * shear * SQRT_1_5 * multiplier;
        let inward = step * radial;
        let inverse = if distance > 0.0 { 1.0 / distance } else { 0.0 };
        let (ux, uy) = (x * inverse, y * inverse);
        let radius = if distance > inward { distance - inward } else { 0.0 };
        let across = if radius > 0.0 { -step * hoop } else { 0.0 };
        let (x, y) = (radius * ux - across * uy, radius * uy + across * ux);
        let (x, y, lode) = within_sextant(x, y, trial.0, trial.1);
        Iterate { x, y, pressure: pressure + bulk * tan_dilation * multiplier, lode }
    }

    /// R_mc and its derivative with respect to Θ.
    #[inline(always)]
    fn hexagon(&self, cos: Real, sin: Real) -> (Real, Real) {
        let [of_sin, of_cos] = self.hexagon;
        (of_sin * sin + of_cos * cos, of_sin * cos - of_cos * sin)
    }

    /// R_mw and its derivative with respect to Θ.
    #[inline(always)]
    fn ellipse(&self, cos: Real, sin: Real) -> (Real, Real) {
        let [a, b] = self.ellipse;
        // 4(1 − e²) cos²Θ + 5e² − 4e, where 5e² − 4e = (2e − 1)² − (1 − e²).
        let root = max(4.0 * a * cos * cos + b * b - a, 0.0).sqrt();
        let numerator = 4.0 * a * cos * cos + b * b;
        let denominator = 2.0 * a * cos + b * root;
        let root_slope = if root > 0.0 { cos / root } else { 0.0 };
        let numerator_slope = 8.0 * a * cos;
        let denominator_slope = 2.0 * a + 4.0 * a * b * root_slope;
        let value = numerator / denominator;
        let slope = -sin * self.meridian * (numerator_slope - value * denominator_slope) / denominator;
        (self.meridian * value, slope)
    }
}

impl YieldLaw for MenetreyWillam {
    #[inline(always)]
    fn may_yield(&self, stress: Symmetric, point: &Point) -> bool {
        self.surface.may_yield(stress, point)
    }

    #[inline(always)]
    fn return_map(&self, trial: Symmetric, point: &Point) -> Returned {
        let dilates = !point.is_critical;
        let spectrum = Spectrum::of(trial);
        let start = Iterate { x: spectrum.norm, y: 0.0, pressure: -spectrum.mean, lode: spectrum.lode() };
        // Unrolled, so that the compiler can vectorise the loop over cells. In an explicit time step the
        // second step leaves an error of 1e-6 of the yield stress; the scaling at the end removes the rest.
        let once = self.cutting_plane_step(start, start.lode, dilates);
        let twice = self.cutting_plane_step(once, start.lode, dilates);
        let Iterate { x, y, pressure, lode } = self.cutting_plane_step(twice, start.lode, dilates);
        // Where dilation ends at the apex it does so up to rounding, and soil opens at the apex alone.
        let apex = -self.surface.apex();
        let rounding = ROUNDING * start.pressure.abs();
        let pressure = if pressure > apex + rounding { pressure } else { apex };
        let (hexagon, _) = self.hexagon(lode.0, lode.1);
        let q = SQRT_1_5 * (x * x + y * y).sqrt();
        let strength = pressure * self.tan_friction + self.cohesion;
        let scale = if hexagon * q > strength { max(strength / (hexagon * q), 0.0) } else { 1.0 };
        let value = self.surface.cut_off(spectrum.principal_at(-pressure, scale * x, scale * y));
        self.surface.returned(&spectrum, value)
    }
}

/// An iterate of the return mapping, in the deviatoric plane spanned by the trial deviator (x) and the
/// direction perpendicular to it (y); the Mises stress is √1.5 times the distance from the origin.
#[derive(Clone, Copy)]
struct Iterate {
    x: Real,
    y: Real,
    pressure: Real,
    /// Cosine and sine of the Lode angle.
    lode: (Real, Real),
}

/// Restricts a point of the deviatoric plane to the sextant 0 ≤ Θ ≤ 60° of the trial stress, whose Lode angle
/// has this cosine and sine. Returns the point with the cosine and sine of its own Lode angle.
#[inline(always)]
fn within_sextant(x: Real, y: Real, cos: Real, sin: Real) -> (Real, Real, (Real, Real)) {
    const HALF_SQRT_3: Real = 0.866_025_403_784_438_6;
    let distance = (x * x + y * y).sqrt();
    let inverse = if distance > 0.0 { 1.0 / distance } else { 0.0 };
    let (ux, uy) = (x * inverse, y * inverse);
    let (c, s) = (cos * ux - sin * uy, sin * ux + cos * uy);
    let (low, high) = (s < 0.0, c < 0.5);
    let is_origin = distance == 0.0;
    let c = if is_origin {
        cos
    } else if low {
        1.0
    } else if high {
        0.5
    } else {
        c
    };
    let s = if is_origin {
        sin
    } else if low {
        0.0
    } else if high {
        HALF_SQRT_3
    } else {
        s
    };
    // From its own Lode angle back to the axes of the trial stress.
    (distance * (c * cos + s * sin), distance * (s * cos - c * sin), (c, s))
}
