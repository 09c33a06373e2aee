//! Mohr–Coulomb plasticity with a non-associated flow rule and a tension cut-off; Tresca is its case φ = ψ =
//! 0.
//!
//! Yield: (σ₁ − σ₃) + (σ₁ + σ₃) sin φ = 2 c cos φ, σ₁ ≥ σ₂ ≥ σ₃, tension positive. Flow: the same with ψ for
//! φ. The return mapping is the closed form in principal stresses of de Souza Neto, Perić & Owen (2008, ch.
//! 8): main plane, two edges, apex, then the tension cut-off of the principal stresses. c = 0 needs no
//! special treatment: the apex is then the stress-free state, and the opening beyond it is recorded as gap
//! strain. Free of branches, so that loops vectorise.

use super::Real;
use super::elastic::Elastic;
use super::select::max;
use super::tensor::{Spectrum, Symmetric, THIRD, contract, deviator, mean};
use super::yield_law::{Memory, Point, Returned, YieldLaw};

/// Strength parameters, and the moduli of the return mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct MohrCoulomb {
    pub(crate) elastic: Elastic,
    pub(crate) sin_friction: Real,
    /// 2 c cos φ [Pa].
    pub(crate) cohesive: Real,
    /// c cot φ [Pa], infinite for φ = 0.
    pub(crate) apex: Real,
    /// Tension cut-off [Pa].
    pub(crate) tension_cutoff: Real,
    /// The return mapping of dilating soil, and of soil at its critical density.
    pub(crate) dilating: Flow,
    pub(crate) critical: Flow,
}

/// Direction and stiffness of the return mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct Flow {
    pub(crate) sin_dilation: Real,
    /// Moduli of the return mapping: A, and B at either edge [Pa].
    pub(crate) plane: Real,
    pub(crate) right: Real,
    pub(crate) left: Real,
    /// 1/A [1/Pa] and 1/(A² − B²) at either edge [1/Pa²].
    pub(crate) per_plane: Real,
    pub(crate) per_right: Real,
    pub(crate) per_left: Real,
    /// Decrease of σ₁ and increases of σ₂ and σ₃ per unit of the plastic multiplier [Pa].
    pub(crate) correction: [Real; 3],
}

impl Flow {
    fn new(elastic: Elastic, sp: Real, sy: Real) -> Self {
        let (k, g) = (elastic.bulk, elastic.shear);
        let plane = 4.0 * g * (1.0 + sp * sy / 3.0) + 4.0 * k * sp * sy;
        let right = 2.0 * g * (1.0 + sp + sy - sp * sy / 3.0) + 4.0 * k * sp * sy;
        let left = 2.0 * g * (1.0 - sp - sy - sp * sy / 3.0) + 4.0 * k * sp * sy;
        Self {
            sin_dilation: sy,
            plane,
            right,
            left,
            per_plane: 1.0 / plane,
            per_right: 1.0 / (plane * plane - right * right),
            per_left: 1.0 / (plane * plane - left * left),
            correction: [
                2.0 * g * (1.0 + sy / 3.0) + 2.0 * k * sy,
                (4.0 * g / 3.0 - 2.0 * k) * sy,
                2.0 * g * (1.0 - sy / 3.0) - 2.0 * k * sy,
            ],
        }
    }

    fn cast(exact: &crate::double::mohr_coulomb::Flow) -> Self {
        Self {
            sin_dilation: exact.sin_dilation as Real,
            plane: exact.plane as Real,
            right: exact.right as Real,
            left: exact.left as Real,
            per_plane: exact.per_plane as Real,
            per_right: exact.per_right as Real,
            per_left: exact.per_left as Real,
            correction: exact.correction.map(|modulus| modulus as Real),
        }
    }
}

impl MohrCoulomb {
    /// The law from the friction angle 0 ≤ φ < 90° [rad], dilation angle 0 ≤ ψ ≤ φ [rad], cohesion c ≥ 0 [Pa]
    /// and tension cut-off [Pa] (at most c cot φ has an effect).
    #[must_use]
    pub fn new(
        elastic: Elastic,
        friction: Real,
        dilation: Real,
        cohesion: Real,
        tension_cutoff: Real,
    ) -> Self {
        let (sp, sy) = (friction.sin(), dilation.sin());
        let apex = if sp > 0.0 { cohesion * friction.cos() / sp } else { Real::INFINITY };
        Self {
            elastic,
            sin_friction: sp,
            cohesive: 2.0 * cohesion * friction.cos(),
            apex,
            tension_cutoff: tension_cutoff.min(apex),
            dilating: Flow::new(elastic, sp, sy),
            critical: Flow::new(elastic, sp, 0.0),
        }
    }

    /// Tresca, from the undrained shear strength s_u > 0 [Pa].
    #[must_use]
    pub fn tresca(elastic: Elastic, shear_strength: Real) -> Self {
        Self::new(elastic, 0.0, 0.0, shear_strength, Real::INFINITY)
    }

    /// Double-precision parameters, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::mohr_coulomb::MohrCoulomb) -> Self {
        Self {
            elastic: Elastic::cast(&exact.elastic),
            sin_friction: exact.sin_friction as Real,
            cohesive: exact.cohesive as Real,
            apex: exact.apex as Real,
            tension_cutoff: exact.tension_cutoff as Real,
            dilating: Flow::cast(&exact.dilating),
            critical: Flow::cast(&exact.critical),
        }
    }

    /// Yield function (σ₁ − σ₃) + (σ₁ + σ₃) sin φ − 2 c cos φ [Pa] of the principal stresses [Pa], largest
    /// first.
    #[inline(always)]
    #[must_use]
    pub fn yield_function(&self, [s1, _, s3]: [Real; 3]) -> Real {
        (s1 - s3) + (s1 + s3) * self.sin_friction - self.cohesive
    }

    /// Undrained shear strength [Pa] of soil without friction; `None` for other soil.
    #[must_use]
    pub fn undrained_strength(&self) -> Option<Real> {
        (self.sin_friction == 0.0).then_some(0.5 * self.cohesive)
    }

    /// Hydrostatic tensile strength c cot φ [Pa]; infinite for φ = 0.
    #[inline(always)]
    #[must_use]
    pub fn apex(&self) -> Real {
        self.apex
    }

    /// The result for a trial stress that is mapped to these principal stresses, with the same principal
    /// axes.
    #[inline(always)]
    pub(crate) fn returned(&self, trial: &Spectrum, value: [Real; 3]) -> Returned {
        let stress = trial.with_principal(value);
        let new_mean = (value[0] + value[1] + value[2]) * THIRD;
        let (per_bulk, per_shear) = (1.0 / self.elastic.bulk, 0.5 / self.elastic.shear);
        let open = (value[0] >= self.tension_cutoff) & (value[2] >= self.tension_cutoff);
        let gap_strain = if open { max((trial.mean - new_mean) * per_bulk, 0.0) } else { 0.0 };
        let mut square = 0.0;
        for n in 0..3 {
            let change = (trial.principal[n] - trial.mean) - (value[n] - new_mean);
            square += change * change;
        }
        let plastic_strain = (square * (2.0 / 3.0)).sqrt() * per_shear;
        Returned { stress, plastic_strain, gap_strain, memory: Memory::default() }
    }

    /// Selected value by value, which the compiler turns into blends.
    #[inline(always)]
    fn flow(&self, dilates: bool) -> Flow {
        let pick = |a: Real, b: Real| if dilates { a } else { b };
        let (a, b) = (&self.dilating, &self.critical);
        Flow {
            sin_dilation: pick(a.sin_dilation, b.sin_dilation),
            plane: pick(a.plane, b.plane),
            right: pick(a.right, b.right),
            left: pick(a.left, b.left),
            per_plane: pick(a.per_plane, b.per_plane),
            per_right: pick(a.per_right, b.per_right),
            per_left: pick(a.per_left, b.per_left),
            correction: [
                pick(a.correction[0], b.correction[0]),
                pick(a.correction[1], b.correction[1]),
                pick(a.correction[2], b.correction[2]),
            ],
        }
    }

    /// Return mapping of principal stresses [Pa] in shear: to the plane, else an edge, else the apex.
    #[inline(always)]
    pub(crate) fn shear_return(&self, [s1, s2, s3]: [Real; 3], dilates: bool) -> [Real; 3] {
        let flow = self.flow(dilates);
        let [c1, c2, c3] = flow.correction;
        let (sp, sy) = (self.sin_friction, flow.sin_dilation);
        let fa = self.yield_function([s1, s2, s3]);
        let g = max(fa, 0.0) * flow.per_plane;
        let plane = [s1 - c1 * g, s2 + c2 * g, s3 + c3 * g];
        let on_plane = (plane[0] >= plane[1]) & (plane[1] >= plane[2]);

        let to_right = (1.0 - sy) * s1 - 2.0 * s2 + (1.0 + sy) * s3 > 0.0;
        let fb_right = (s1 - s2) + (s1 + s2) * sp - self.cohesive;
        let fb_left = (s2 - s3) + (s2 + s3) * sp - self.cohesive;
        let fb = if to_right { fb_right } else { fb_left };
        let (a, b, per) = (
            flow.plane,
            if to_right { flow.right } else { flow.left },
            if to_right { flow.per_right } else { flow.per_left },
        );
        let (ga, gb) = ((a * fa - b * fb) * per, (a * fb - b * fa) * per);
        let right = [s1 - c1 * (ga + gb), s2 + c2 * ga + c3 * gb, s3 + c3 * ga + c2 * gb];
        let left = [s1 - c1 * ga + c2 * gb, s2 + c2 * ga - c1 * gb, s3 + c3 * (ga + gb)];
        // On an edge two stresses are equal: bitwise, so that rounding cannot change their order.
        let (right_pair, left_pair) = (0.5 * (right[1] + right[2]), 0.5 * (left[0] + left[1]));
        let edge =
            if to_right { [right[0], right_pair, right_pair] } else { [left_pair, left_pair, left[2]] };
        let on_edge = (edge[0] >= edge[2]) & (edge[0] <= self.apex);

        let apex = if self.apex < Real::INFINITY { self.apex } else { 0.0 };
        let mut value = [0.0; 3];
        for n in 0..3 {
            value[n] = if on_plane {
                plane[n]
            } else if on_edge {
                edge[n]
            } else {
                apex
            };
        }
        value
    }

    /// Tension cut-off of the principal stresses [Pa].
    #[inline(always)]
    pub(crate) fn cut_off(&self, value: [Real; 3]) -> [Real; 3] {
        value.map(|s| if s < self.tension_cutoff { s } else { self.tension_cutoff })
    }
}

impl YieldLaw for MohrCoulomb {
    /// Compares with the cone inscribed in the pyramid.
    #[inline(always)]
    fn may_yield(&self, stress: Symmetric, _point: &Point) -> bool {
        let s = deviator(stress);
        let p = mean(stress);
        let root = (0.5 * contract(s, s)).sqrt();
        let sp = self.sin_friction;
        // 1.1548 ≥ 2/√3 bounds the largest principal deviator by √J₂.
        let shears = 2.0 * root * (1.0 + sp * sp / 3.0).sqrt() > self.cohesive - 2.0 * p * sp;
        let opens = p + 1.1548 * root > self.tension_cutoff;
        shears | opens
    }

    #[inline(always)]
    fn return_map(&self, trial: Symmetric, point: &Point) -> Returned {
        let spectrum = Spectrum::of(trial);
        let value = self.cut_off(self.shear_return(spectrum.principal, !point.is_critical));
        self.returned(&spectrum, value)
    }
}
