//! Von Mises with linear isotropic hardening, against closed-form solutions.

use physics::elastic::Elastic;
use physics::tensor::{Symmetric, contract, deviator, mean, mises};
use physics::von_mises::VonMises;
use physics::yield_law::{Point as LawPoint, YieldLaw};

const YIELD: f64 = 400e6;
const HARDENING: f64 = 100e6;

fn elastic() -> Elastic {
    Elastic::new(117e9, 0.35)
}

fn copper() -> VonMises {
    VonMises::new(elastic(), YIELD, HARDENING)
}

/// A point of the metal.
#[derive(Clone, Copy, Default)]
struct Point {
    stress: Symmetric,
    plastic_strain: f64,
    /// Plastic work per volume [J/m³].
    work: f64,
}

impl Point {
    /// The point after a strain increment.
    fn strained(self, increment: Symmetric) -> Self {
        let shear = deviator(increment).map(|d| 2.0 * elastic().shear * d);
        let volumetric = 3.0 * elastic().bulk * mean(increment);
        let trial: Symmetric =
            std::array::from_fn(|n| self.stress[n] + shear[n] + if n < 3 { volumetric } else { 0.0 });
        let back = copper().return_map(trial, &at(self.plastic_strain));
        let middle: Symmetric = std::array::from_fn(|n| 0.5 * (self.stress[n] + back.stress[n]));
        let lost: Symmetric = std::array::from_fn(|n| trial[n] - back.stress[n]);
        Self {
            stress: back.stress,
            plastic_strain: self.plastic_strain + back.plastic_strain,
            work: self.work + elastic().compliance(middle, lost),
        }
    }

    /// The same with the lateral strain of free lateral surfaces.
    fn uniaxial(self, axial: f64) -> Self {
        let at = |lateral: f64| self.strained([axial, lateral, lateral, 0.0, 0.0, 0.0]);
        let (mut low, mut high) = (-axial, axial);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if (at(middle).stress[1] > 0.0) == (axial > 0.0) { high = middle } else { low = middle }
        }
        at(0.5 * (low + high))
    }
}

/// Metal with this plastic strain.
fn at(plastic_strain: f64) -> LawPoint {
    LawPoint { plastic_strain, ..LawPoint::default() }
}

fn stresses() -> Vec<Symmetric> {
    let mut seed = 5_u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut all: Vec<Symmetric> = (0..4000).map(|_| std::array::from_fn(|_| 4e9 * next())).collect();
    all.extend([[0.0; 6], [3e9, 3e9, 3e9, 0.0, 0.0, 0.0], [1e8, -1e8, 0.0, 0.0, 0.0, 0.0]]);
    all
}

#[test]
fn uniaxial_tension_and_unloading_follow_the_bilinear_curve() {
    let young = 117e9;
    let mut point = Point::default();
    let mut strain = 0.0;
    for _ in 0..400 {
        point = point.uniaxial(5e-5);
        strain += 5e-5;
        let tangent = young * HARDENING / (young + HARDENING);
        let exact = (young * strain).min(YIELD + tangent * (strain - YIELD / young));
        assert!((point.stress[0] - exact).abs() < 1e-10 * YIELD, "{strain}: {} {exact}", point.stress[0]);
    }
    // The plastic strain is the total minus the elastic strain; its work is the area under the curve.
    let plastic = strain - point.stress[0] / young;
    assert!((point.plastic_strain - plastic).abs() < 1e-10 * plastic);
    let work = (YIELD + 0.5 * HARDENING * plastic) * plastic;
    // The step in which it first yields includes half of its elastic work.
    assert!((point.work - work).abs() < 1e-5 * work, "{} {work}", point.work);
    // On reversal it is elastic over twice the last stress, then yields: isotropic hardening.
    let last = point.stress[0];
    let steps = 2.0 * last / young / 1e-5;
    for _ in 0..steps.floor() as usize {
        point = point.uniaxial(-1e-5);
    }
    assert!((point.plastic_strain - plastic).abs() < 1e-10 * plastic);
    for _ in 0..50 {
        point = point.uniaxial(-1e-5);
    }
    assert!(point.plastic_strain > plastic);
    assert!((point.stress[0] + copper().flow_stress(point.plastic_strain)).abs() < 1e-10 * last);
}

#[test]
fn simple_shear_hardens_by_a_third_of_the_modulus() {
    // τ = σ_y/√3 + (H/3) γₚ, γₚ = √3 ε̄ₚ = γ − τ/G.
    let shear = elastic().shear;
    let mut point = Point::default();
    let mut angle = 0.0;
    for _ in 0..1000 {
        point = point.strained([0.0, 0.0, 0.0, 0.5e-4, 0.0, 0.0]);
        angle += 1e-4;
        let root = 3_f64.sqrt();
        let yielding = (YIELD / root + HARDENING / 3.0 * angle) / (1.0 + HARDENING / (3.0 * shear));
        let exact = (shear * angle).min(yielding);
        assert!((point.stress[3] - exact).abs() < 1e-10 * YIELD, "{angle}");
        assert!((point.plastic_strain - (angle - exact / shear) / root).abs() < 1e-12);
    }
    assert!(mean(point.stress) == 0.0 && point.stress[0] == 0.0);
}

#[test]
fn the_return_is_radial_ends_on_the_hardened_surface_and_keeps_the_pressure() {
    for trial in stresses() {
        for before in [0.0, 0.7, 3.0] {
            let law = copper();
            let back = law.return_map(trial, &at(before));
            assert_eq!(back, law.return_map(trial, &LawPoint { is_critical: true, ..at(before) }));
            assert!(back.gap_strain == 0.0 && (mean(back.stress) - mean(trial)).abs() < 1e-6);
            if mises(trial) <= law.flow_stress(before) {
                assert!(back.plastic_strain == 0.0 && !law.may_yield(trial, &at(before)));
                let moved = (0..6).map(|n| (back.stress[n] - trial[n]).abs()).fold(0.0, f64::max);
                assert!(moved < 1e-6, "{moved}");
                continue;
            }
            assert!(law.may_yield(trial, &at(before)));
            let now = law.flow_stress(before + back.plastic_strain);
            assert!((mises(back.stress) - now).abs() < 1e-10 * now, "{trial:?}");
            // Along the deviator of the trial, by 2 G times the plastic strain of size √(3/2) Δε̄ₚ.
            let (s, left) = (deviator(trial), deviator(back.stress));
            let cosine = contract(s, left) / (contract(s, s) * contract(left, left)).sqrt();
            assert!(1.0 - cosine < 1e-12);
            let off: Symmetric = std::array::from_fn(|n| (s[n] - left[n]) / (2.0 * elastic().shear));
            let size = (2.0 / 3.0 * contract(off, off)).sqrt();
            assert!((size - back.plastic_strain).abs() < 1e-10 * size);
            // The work is the flow stress times the plastic strain, never negative.
            let change: Symmetric = std::array::from_fn(|n| trial[n] - back.stress[n]);
            let work = elastic().compliance(back.stress, change);
            assert!(work > 0.0 && (work - now * back.plastic_strain).abs() < 1e-9 * work);
        }
    }
}
