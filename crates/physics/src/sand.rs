//! Sand from loose to dense, with its density as state.
//!
//! With p = −tr σ/3 and q = √(3/2 s:s), two mechanisms yield:
//!
//! * **Shear**: q = η g(θ) p. g is the shape of Matsuoka and Nakai's surface as Sheng, Sloan and Yu (2000)
//!   write it, 1 in triaxial compression. The mobilised stress ratio η = x η_p grows with the plastic shear
//!   strain γ = 2 a x²/(1 − x) towards that of the peak, η_p = M + k_b I_R: elastic at first, half of it at
//!   γ = a. M is the stress ratio of the critical state, I_R = I_D (Q − ln p) − R the relative dilatancy
//!   index of Bolton (1986), which does not change below 150 kPa (Bolton 1987), I_D the relative density.
//!   Flow is radial in the deviatoric plane; plastic volume compacts by D = A (M − k_d I_R − η) per plastic
//!   shear strain. At the peak that is a multiple of I_R; where I_R = 0, D vanishes at η = M: the critical
//!   state.
//! * **Compression**: p = p_c, the preconsolidation pressure, which grows with the compaction at a plastic
//!   bulk modulus that rises with pressure (Janbu 1963) and density.
//!
//! Density is the state that both share: what shear and compression compact is denser, and so stronger.
//! Elastic moduli grow with the square root of the pressure. Free of branches, so that loops vectorise.

use super::Real;
use super::elastic::{Elastic, Stiffening};
use super::select::{clamp, max, min};
use super::tensor::{Symmetric, contract, deviator, mean};
use super::yield_law::{Memory, Point, Returned, YieldLaw};

/// Pressure to which the compression modulus refers [Pa].
const ATMOSPHERE: Real = 1e5;
/// Pressure up to which the reference strain is constant [Pa]. Below it triaxial tests of Toyoura sand show
/// no change (Fukushima and Tatsuoka 1984).
const CONSTANT_STRAIN: Real = 2e4;
/// Least mobilised share x of the peak at which the hardening is evaluated: it has no bound at x = 0.
const LEAST_SHARE: Real = 0.02;
/// Pressures between which Bolton's index changes [Pa]: it is constant below 150 kPa (Bolton 1987).
const INDEX_PRESSURE: [Real; 2] = [1.5e5, 1e6];
/// Range of Bolton's index (he found none above 4; the lower bound only keeps the index of soil that was
/// thrown up in range).
const INDEX: [Real; 2] = [-4.0, 4.0];
/// Lowest pressure at which the compression modulus is evaluated [Pa]; chosen: the weight of a few
/// millimetres of sand.
const LEAST_PRESSURE: Real = 50.0;
/// Largest D over 3 G/(K M), at which a return under constrained volume has no solution.
const MOST_CONTRACTION: f64 = 0.7;
/// A, the slope of the dilatancy over the stress ratio. Like the constants below fitted to the tests of
/// Karlsruhe fine sand (Wichtmann and Triantafyllidis 2016) and of Toyoura sand (Fukushima and Tatsuoka 1984)
/// together.
const DILATANCY: f64 = 0.6;
/// Peak friction angle less the critical one over Bolton's index, in triaxial compression: 4.0° [rad]. Sand
/// that softens passes its peak short of it; of what is reached Bolton (1986) found 3°.
const PEAK_ANGLE: f64 = 0.069_813_170_079_773_18;
/// Dilatancy −dε_v/dε₁ at the peak over Bolton's index (Bolton 1986: 0.3).
const PEAK_DILATANCY: f64 = 0.28;
/// Range of the relative density, wider than that of the standard tests: sand may be laid looser than in
/// them, and vibration or shear may pack it closer. Soil that was thrown up has no density to speak of, and
/// none is packed closer than this: grains do not crush.
pub const RELATIVE_DENSITY: [f64; 2] = [-0.5, 1.2];
/// Compression modulus of sand in its densest state [Pa].
const RIGID: Real = 1e15;
/// How the reference strain falls and the compression modulus rises with the relative density: exponents of
/// e.
const STRAIN_DENSITY: Real = -1.5;
const COMPRESSION_DENSITY: Real = 1.15;

/// Parameters of sand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SandParameters {
    /// Friction angle of the critical state in triaxial compression φ_cv [rad].
    pub critical_friction: f64,
    /// Dry density in its loosest and in its densest state, ρ_min and ρ_max [kg/m³].
    pub limit_density: [f64; 2],
    /// Bolton's Q and R.
    pub bolton: [f64; 2],
    /// Plastic shear strain at which half of the strength is mobilised, at I_D = 0.5 and 20 kPa or less.
    pub reference_strain: f64,
    /// Bulk modulus of plastic compression at I_D = 0.5 and 100 kPa [Pa].
    pub compression_modulus: f64,
}

/// The law of a sand.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Sand {
    pub(crate) elastic: Elastic,
    /// How the elastic moduli grow with the pressure.
    pub stiffening: Stiffening,
    /// M.
    pub(crate) critical_ratio: Real,
    /// α⁴, α = (3 − sin φ)/(3 + sin φ): the ratio of M in triaxial extension to that in compression.
    pub(crate) extension: Real,
    pub(crate) limit_density: [Real; 2],
    /// Density at the upper end of [`RELATIVE_DENSITY`] [kg/m³].
    pub(crate) densest: Real,
    pub(crate) bolton: [Real; 2],
    /// k_b.
    pub(crate) peak: Real,
    /// k_d.
    pub(crate) onset: Real,
    /// Largest D.
    pub(crate) most_contraction: Real,
    pub(crate) reference_strain: Real,
    pub(crate) compression_modulus: Real,
}

impl Sand {
    /// A sand from its elastic moduli at the pressure at which they stop growing, and its parameters.
    #[must_use]
    pub fn new(elastic: Elastic, stiffening: Stiffening, parameters: &SandParameters) -> Self {
        let SandParameters { critical_friction, limit_density, bolton, .. } = *parameters;
        let [loosest, densest] = limit_density;
        let (sin, cos) = critical_friction.sin_cos();
        let ratio = 6.0 * sin / (3.0 - sin);
        let alpha: f64 = (3.0 - sin) / (3.0 + sin);
        let peak = 18.0 * cos / ((3.0 - sin) * (3.0 - sin)) * PEAK_ANGLE;
        // Per shear strain ε₁ − ε_v/3 instead of per ε₁, at an index of 2.
        let dilatancy = PEAK_DILATANCY / (1.0 + 2.0 / 3.0 * PEAK_DILATANCY);
        Self {
            elastic,
            stiffening,
            critical_ratio: ratio as Real,
            extension: alpha.powi(4) as Real,
            limit_density: limit_density.map(|density| density as Real),
            densest: (loosest / (1.0 - RELATIVE_DENSITY[1] * (1.0 - loosest / densest))) as Real,
            bolton: bolton.map(|constant| constant as Real),
            peak: peak as Real,
            onset: (dilatancy / DILATANCY - peak) as Real,
            most_contraction: (MOST_CONTRACTION * 3.0 / ratio) as Real * elastic.shear / elastic.bulk,
            reference_strain: parameters.reference_strain as Real,
            compression_modulus: parameters.compression_modulus as Real,
        }
    }

    /// Double-precision parameters, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::sand::Sand) -> Self {
        Self {
            elastic: Elastic::cast(&exact.elastic),
            stiffening: Stiffening::cast(&exact.stiffening),
            critical_ratio: exact.critical_ratio as Real,
            extension: exact.extension as Real,
            limit_density: exact.limit_density.map(|density| density as Real),
            densest: exact.densest as Real,
            bolton: exact.bolton.map(|constant| constant as Real),
            peak: exact.peak as Real,
            onset: exact.onset as Real,
            most_contraction: exact.most_contraction as Real,
            reference_strain: exact.reference_strain as Real,
            compression_modulus: exact.compression_modulus as Real,
        }
    }

    /// Density in the densest state that the sand is compacted to [kg/m³].
    #[must_use]
    pub fn densest(&self) -> Real {
        self.densest
    }

    /// Elastic energy density at a stress [J/m³].
    #[inline(always)]
    #[must_use]
    pub fn energy(&self, stress: Symmetric) -> Real {
        self.stiffening.energy(self.elastic, stress)
    }

    /// Relative density I_D = (e_max − e)/(e_max − e_min) at a density [kg/m³], within [`RELATIVE_DENSITY`].
    #[inline(always)]
    #[must_use]
    pub fn relative_density(&self, density: Real) -> Real {
        let [loosest, densest] = self.limit_density;
        let relative_density = densest / (densest - loosest) * (1.0 - loosest / max(density, 1.0));
        clamp(relative_density, RELATIVE_DENSITY[0] as Real, RELATIVE_DENSITY[1] as Real)
    }

    /// Bolton's relative dilatancy index I_R at a relative density and a mean pressure [Pa].
    #[inline(always)]
    #[must_use]
    pub fn dilatancy_index(&self, relative_density: Real, pressure: Real) -> Real {
        let [q, r] = self.bolton;
        let pressure = clamp(pressure, INDEX_PRESSURE[0], INDEX_PRESSURE[1]);
        clamp(relative_density * (q - logarithm(pressure * 1e-3)) - r, INDEX[0], INDEX[1])
    }

    /// Stress ratio of the peak at a dilatancy index.
    #[inline(always)]
    #[must_use]
    pub fn peak_ratio(&self, index: Real) -> Real {
        max(self.critical_ratio + self.peak * index, 0.5 * self.critical_ratio)
    }

    /// Mean pressure p [Pa], deviatoric stress q [Pa], and the shape g(θ) of the surface at a stress [Pa].
    #[inline(always)]
    #[must_use]
    pub fn invariants(&self, stress: Symmetric) -> [Real; 3] {
        let s = deviator(stress);
        let [xx, yy, zz, xy, yz, xz] = s;
        let squared = 1.5 * contract(s, s);
        let q = squared.sqrt();
        let third = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
        // cos 3θ: 1 in triaxial compression, −1 in extension.
        let cubed = squared * q;
        let lode = if cubed > 0.0 { clamp(-13.5 * third / cubed, -1.0, 1.0) } else { 1.0 };
        let a = self.extension;
        let shape = (2.0 * a / (1.0 + a - (1.0 - a) * lode)).sqrt().sqrt();
        [-mean(stress), q, shape]
    }
}

/// What governs plastic flow at a point.
struct Moduli {
    /// Stress ratio of the peak.
    peak: Real,
    /// Stress ratio mobilised so far.
    ratio: Real,
    /// Compaction D per plastic shear strain.
    contraction: Real,
    /// Increase of the mobilised ratio per plastic shear strain.
    hardening: Real,
    /// Bulk modulus of plastic compression [Pa].
    compression: Real,
}

/// A return in shear: the plastic shear strain is the ratio of what lies `beyond` the surface [Pa] to a
/// `slope` [Pa], and each unit of it lowers the pressure by `relief` [Pa].
#[derive(Clone, Copy)]
struct Shearing {
    pressure: Real,
    beyond: Real,
    slope: Real,
    relief: Real,
}

impl Sand {
    /// The moduli of plastic flow at a point whose stress ratio has `reached` a value, under a trial pressure
    /// [Pa].
    #[inline(always)]
    fn plastic_moduli(&self, point: &Point, pressure: Real, reached: Real) -> Moduli {
        let relative_density = self.relative_density(point.density) + point.memory.nonlocal_density;
        let index = self.dilatancy_index(relative_density, pressure);
        let peak = self.peak_ratio(index);
        let ratio = min(max(point.memory.stress_ratio, reached), peak);
        let contraction = DILATANCY as Real * (self.critical_ratio - self.onset * index - ratio);
        let looseness = relative_density - 0.5;
        let share = max(ratio / peak, LEAST_SHARE);
        let left = 1.0 - share;
        let strain = self.reference_strain
            * exponential(STRAIN_DENSITY * looseness)
            * max(pressure * (1.0 / CONSTANT_STRAIN), 1.0).sqrt();
        let root = (max(pressure, LEAST_PRESSURE) * (1.0 / ATMOSPHERE)).sqrt();
        let compression =
            self.compression_modulus * exponential(COMPRESSION_DENSITY * looseness) * (root * root.sqrt());
        let is_densest = point.density >= self.densest;
        Moduli {
            peak,
            ratio,
            // Sand in its densest state cannot be packed any closer.
            contraction: min(contraction, if is_densest { 0.0 } else { self.most_contraction }),
            hardening: 0.5 * peak * left * left / (strain * share * (2.0 - share)),
            compression: if is_densest { RIGID } else { compression },
        }
    }
}

impl YieldLaw for Sand {
    const REMEMBERS: bool = true;

    #[inline(always)]
    fn may_yield(&self, stress: Symmetric, point: &Point) -> bool {
        let [p, q, shape] = self.invariants(stress);
        let Memory { stress_ratio, preconsolidation, .. } = point.memory;
        (p <= 0.0) | (p > preconsolidation) | (q > stress_ratio * shape * p)
    }

    #[inline(always)]
    fn return_map(&self, trial: Symmetric, point: &Point) -> Returned {
        let [p_trial, q_trial, shape] = self.invariants(trial);
        let [p_old, q_old, shape_old] = self.invariants(point.stress);
        let Elastic { bulk, shear } = self.stiffening.moduli(self.elastic, p_old);
        // The surfaces hold the stress at the start, also where soil was mixed.
        let preconsolidation = max(point.memory.preconsolidation, max(p_old, 0.0));
        let reached = if p_old > 0.0 { q_old / (shape_old * p_old) } else { 0.0 };

        let Moduli { peak, ratio, contraction, hardening, compression: modulus } =
            self.plastic_moduli(point, p_trial, reached);

        let surface = ratio * shape;
        let sheared = |pressure: Real, bulk: Real| Shearing {
            pressure,
            beyond: max(q_trial - surface * pressure, 0.0),
            slope: 3.0 * shear + max(pressure, 0.0) * shape * hardening - bulk * surface * contraction,
            relief: bulk * contraction,
        };
        // While compression yields too, shear compacts against the softer of the two.
        let portion = modulus / (bulk + modulus);
        let both = sheared(preconsolidation + (p_trial - preconsolidation) * portion, bulk * portion);
        let alone = sheared(p_trial, bulk);
        let stays_compressed = both.relief * both.beyond < (both.pressure - preconsolidation) * both.slope;
        let compresses = (p_trial > preconsolidation) & stays_compressed;
        let of = |both: Real, alone: Real| if compresses { both } else { alone };
        let flow = of(both.beyond, alone.beyond) / of(both.slope, alone.slope);
        let p = of(both.pressure, alone.pressure) - of(both.relief, alone.relief) * flow;
        let bears = p > 0.0;
        let p = if bears { p } else { 0.0 };
        let ratio = min(ratio + hardening * flow, peak);
        let q = min(q_trial, ratio * shape * p);

        let scale = if q_trial > 0.0 { q / q_trial } else { 0.0 };
        let mut stress = deviator(trial).map(|s| s * scale);
        stress[0] -= p;
        stress[1] -= p;
        stress[2] -= p;
        // Soil that has opened is loose, and forgets.
        let memory = Memory {
            stress_ratio: if bears { ratio } else { 0.0 },
            preconsolidation: if bears { max(preconsolidation, p) } else { 0.0 },
            ..point.memory
        };
        Returned {
            stress,
            plastic_strain: if bears { flow } else { 0.0 },
            gap_strain: if bears { 0.0 } else { max(-p_trial / bulk, 0.0) },
            memory,
        }
    }
}

/// eˣ within 0.5 % for |x| ≤ 2, in a form that vectorises.
#[inline(always)]
fn exponential(x: Real) -> Real {
    let x = clamp(x, -2.0, 2.0) / 16.0;
    let y = 1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0)));
    let y = y * y;
    let y = y * y;
    let y = y * y;
    y * y
}

/// Natural logarithm within 5e-6 for 150 ≤ x ≤ 1000: twice that of √x, by the series of the inverse
/// hyperbolic tangent about √(150 · 1000).
#[inline(always)]
fn logarithm(x: Real) -> Real {
    const MIDDLE: Real = 387.298_334_620_741_7;
    const LOG_MIDDLE: Real = 5.959_195_286_539_196;
    let y = (x * (1.0 / MIDDLE)).sqrt();
    let t = (y - 1.0) / (y + 1.0);
    let z = t * t;
    LOG_MIDDLE + 4.0 * t * (1.0 + z * (1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_forms_of_functions_are_close() {
        let close = |found: Real, exact: Real, tolerance: Real| (found / exact - 1.0).abs() < tolerance;
        for n in 0..=100_u8 {
            let x = 150.0 * Real::powf(1000.0 / 150.0, Real::from(n) / 100.0);
            assert!(close(logarithm(x), x.ln(), 1e-6), "{x}");
            let small = 0.04 * (Real::from(n) - 50.0);
            assert!(close(exponential(small), small.exp(), 5e-3), "{small}");
        }
    }
}
