//! Mohr–Coulomb's yield surface with the smooth flow potential of Menétrey and Willam (1995), as Abaqus has it.
//!
//! With p the pressure, q the Mises stress and Θ the Lode angle (0 in triaxial extension, 60° in compression):
//! yield F = R_mc q − p tan φ − c; flow G = √((ε c tan ψ)² + (R_mw q)²) − p tan ψ. R_mc is the hexagon, R_mw an ellipse
//! through its corners on both meridians (for the default eccentricity e). The potential has no corners, so that one
//! formula serves the whole surface: a cutting-plane return (Ortiz and Simo 1986) in the plane of the deviator, then the
//! radial scaling that puts F = 0 to the last digit, which is exact because F is homogeneous in q.

use super::Real;
use super::elastic::Elastic;
use super::mohr_coulomb::MohrCoulomb;
use super::strength::{Returned, Strength};
use super::tensor::{Spectrum, Symmetric};

const SQRT_1_5: Real = 1.224_744_871_391_589;

/// Mohr–Coulomb with the potential of Menétrey and Willam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MenetreyWillam {
    pub(crate) elastic: Elastic,
    /// The yield surface.
    pub(crate) surface: MohrCoulomb,
    pub(crate) tan_friction: Real,
    pub(crate) tan_dilation: Real,
    pub(crate) cohesion: Real,
    /// R_mc = along sin Θ + across cos Θ.
    pub(crate) hexagon: [Real; 2],
    /// R_mc on the compression meridian, which R_mw is scaled by.
    pub(crate) meridian: Real,
    /// 1 − e² and 2e − 1.
    pub(crate) ellipse: [Real; 2],
    /// (ε c tan ψ)² [Pa²].
    pub(crate) offset: Real,
}

/// Shape of the potential: Abaqus' names and defaults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eccentricity {
    /// ε ≥ 0: how fast the hyperbola in the meridional plane nears its asymptote.
    pub meridional: Real,
    /// e, ½ < e ≤ 1: the ellipse in the deviatoric plane; 1 is a circle.
    pub deviatoric: Real,
}

impl Eccentricity {
    /// ε = 0.1, and e = (3 − sin φ)/(3 + sin φ): the ellipse goes through the hexagon's corners.
    #[must_use]
    pub fn usual(friction: Real) -> Self {
        Self { meridional: 0.1, deviatoric: (3.0 - friction.sin()) / (3.0 + friction.sin()) }
    }
}

impl MenetreyWillam {
    /// Strength from friction angle 0 ≤ φ < 90° [rad], dilation angle 0 ≤ ψ ≤ φ [rad], cohesion c ≥ 0 [Pa], the largest
    /// tension that is borne [Pa] (no more than c cot φ has any effect) and the shape of the potential.
    #[must_use]
    pub fn new(
        elastic: Elastic,
        friction: Real,
        dilation: Real,
        cohesion: Real,
        tension_limit: Real,
        shape: Eccentricity,
    ) -> Self {
        let (a, b) = (1.0 / (Real::sqrt(3.0) * friction.cos()), friction.tan() / 3.0);
        let root = 0.5 * Real::sqrt(3.0);
        let e = shape.deviatoric;
        Self {
            elastic,
            surface: MohrCoulomb::new(elastic, friction, dilation, cohesion, tension_limit),
            tan_friction: friction.tan(),
            tan_dilation: dilation.tan(),
            cohesion,
            hexagon: [0.5 * a - root * b, root * a + 0.5 * b],
            meridian: (3.0 - friction.sin()) / (6.0 * friction.cos()),
            ellipse: [1.0 - e * e, 2.0 * e - 1.0],
            offset: (shape.meridional * cohesion * dilation.tan()).powi(2),
        }
    }

    /// Strength known in double precision, in the one at hand.
    #[must_use]
    pub fn rounded(exact: &crate::double::menetrey_willam::MenetreyWillam) -> Self {
        Self {
            elastic: Elastic::rounded(&exact.elastic),
            surface: MohrCoulomb::rounded(&exact.surface),
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

    /// The least work of plastic flow over all Lode angles, c = 0: tan φ R_mw/R_mc − tan ψ, over tan φ. Below 0, which is so
    /// for ψ near φ because the ellipse bulges beyond the hexagon's sides, some flow would create energy.
    #[must_use]
    pub fn least_dissipation(&self) -> Real {
        let at = |degrees: u16| {
            let (sin, cos) = Real::from(degrees).to_radians().sin_cos();
            self.ellipse(cos, sin).0 / self.hexagon(cos, sin).0
        };
        let ratio = (0..=60).map(at).fold(Real::INFINITY, Real::min);
        if self.tan_friction > 0.0 { ratio - self.tan_dilation / self.tan_friction } else { ratio }
    }

    /// One cutting-plane step. `trial` is the Lode angle of the trial stress.
    #[inline(always)]
    fn cut(&self, from: Place, trial: (Real, Real), dilates: bool) -> Place {
        let (bulk, shear) = (self.elastic.bulk, self.elastic.shear);
        let tan_dilation = if dilates { self.tan_dilation } else { 0.0 };
        let offset = if dilates { self.offset } else { 0.0 };
        let Place { x, y, pressure, lode } = from;
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
        // Without shear stress there is no direction to flow in: the apex takes what is too much.
        let multiplier = if (excess > 0.0) & (stiffness > 0.0) { excess / stiffness } else { 0.0 };
        let step = 2.0 * shear * SQRT_1_5 * multiplier;
        let inward = step * radial;
        let inverse = if distance > 0.0 { 1.0 / distance } else { 0.0 };
        let (ux, uy) = (x * inverse, y * inverse);
        let left = if distance > inward { distance - inward } else { 0.0 };
        let along = if left > 0.0 { -step * hoop } else { 0.0 };
        let (x, y) = (left * ux - along * uy, left * uy + along * ux);
        let (x, y, lode) = within_sextant(x, y, trial.0, trial.1);
        Place { x, y, pressure: pressure + bulk * tan_dilation * multiplier, lode }
    }

    /// R_mc and its slope over Θ.
    #[inline(always)]
    fn hexagon(&self, cos: Real, sin: Real) -> (Real, Real) {
        let [along, across] = self.hexagon;
        (along * sin + across * cos, along * cos - across * sin)
    }

    /// R_mw and its slope over Θ.
    #[inline(always)]
    fn ellipse(&self, cos: Real, sin: Real) -> (Real, Real) {
        let [a, b] = self.ellipse;
        // 4(1 − e²) cos²Θ + 5e² − 4e, where 5e² − 4e = (2e − 1)² − (1 − e²).
        let root = (4.0 * a * cos * cos + b * b - a).max(0.0).sqrt();
        let over = 4.0 * a * cos * cos + b * b;
        let under = 2.0 * a * cos + b * root;
        let steepness = if root > 0.0 { cos / root } else { 0.0 };
        let over_slope = 8.0 * a * cos;
        let under_slope = 2.0 * a + 4.0 * a * b * steepness;
        let value = over / under;
        (self.meridian * value, -sin * self.meridian * (over_slope - value * under_slope) / under)
    }
}

impl Strength for MenetreyWillam {
    #[inline(always)]
    fn may_yield(&self, stress: Symmetric, plastic_strain: Real) -> bool {
        self.surface.may_yield(stress, plastic_strain)
    }

    #[inline(always)]
    fn return_map(&self, trial: Symmetric, _plastic_strain: Real, dilates: bool) -> Returned {
        let spectrum = Spectrum::of(trial);
        let start = Place { x: spectrum.norm, y: 0.0, pressure: -spectrum.mean, lode: spectrum.lode() };
        // Steps one after the other, not in a loop: the compiler then sees a loop over cells that it can vectorise. In an
        // explicit time step the second leaves 1e-6 of the yield stress; the scaling at the end takes what is left.
        let once = self.cut(start, start.lode, dilates);
        let twice = self.cut(once, start.lode, dilates);
        let Place { x, y, pressure, lode } = self.cut(twice, start.lode, dilates);
        let apex = -self.surface.apex();
        let pressure = if pressure > apex { pressure } else { apex };
        let (hexagon, _) = self.hexagon(lode.0, lode.1);
        let q = SQRT_1_5 * (x * x + y * y).sqrt();
        let borne = pressure * self.tan_friction + self.cohesion;
        let share = if hexagon * q > borne { (borne / (hexagon * q)).max(0.0) } else { 1.0 };
        let value = self.surface.capped(spectrum.principal_at(-pressure, share * x, share * y));
        self.surface.returned(&spectrum, value)
    }
}

/// Where a return is: in the plane spanned by the trial's deviator (x) and the direction at a right angle to it (y), where
/// the Mises stress is √1.5 times the distance from the origin.
#[derive(Clone, Copy)]
struct Place {
    x: Real,
    y: Real,
    pressure: Real,
    /// Cosine and sine of the Lode angle.
    lode: (Real, Real),
}

/// Keeps a point of the deviatoric plane within the sextant 0 ≤ Θ ≤ 60° of its trial, whose Lode angle has this cosine and
/// sine: neither surface nor potential is met beyond a meridian. Returns it with cosine and sine of its own angle.
#[inline(always)]
fn within_sextant(x: Real, y: Real, cos: Real, sin: Real) -> (Real, Real, (Real, Real)) {
    const HALF_SQRT_3: Real = 0.866_025_403_784_438_6;
    let distance = (x * x + y * y).sqrt();
    let inverse = if distance > 0.0 { 1.0 / distance } else { 0.0 };
    let (ux, uy) = (x * inverse, y * inverse);
    let (c, s) = (cos * ux - sin * uy, sin * ux + cos * uy);
    let (low, high) = (s < 0.0, c < 0.5);
    let still = distance == 0.0;
    let c = if still {
        cos
    } else if low {
        1.0
    } else if high {
        0.5
    } else {
        c
    };
    let s = if still {
        sin
    } else if low {
        0.0
    } else if high {
        HALF_SQRT_3
    } else {
        s
    };
    // Back from its own angle to that of the trial.
    (distance * (c * cos + s * sin), distance * (s * cos - c * sin), (c, s))
}
