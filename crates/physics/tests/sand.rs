//! The law of sand in element tests: critical state, peak, compression, contraction and dilation.

use physics::elastic::{Elastic, Stiffening};
use physics::sand::{RELATIVE_DENSITY, Sand, SandParameters};
use physics::tensor::{Symmetric, deviator, mean, mises};
use physics::yield_law::{Memory, Point, YieldLaw};

/// Angle of the critical state of the tests.
const CRITICAL: f64 = 32.0;
/// Steps of strain, and the size of one.
const STEPS: usize = 10_000;
const STEP: f64 = 4e-5;

fn sand() -> Sand {
    let parameters = SandParameters {
        critical_friction: CRITICAL.to_radians(),
        limit_density: [1350.0, 1650.0],
        bolton: [10.0, 0.7],
        reference_strain: 0.0009,
        compression_modulus: 20e6,
    };
    Sand::new(elastic(), Stiffening { least: 1e3, most: 1e5 }, &parameters)
}

fn elastic() -> Elastic {
    Elastic::new(75e6, 0.2)
}

/// A specimen that keeps its mass.
#[derive(Clone, Copy)]
struct Specimen {
    law: Sand,
    point: Point,
    /// Work done on it less what it stores, per volume [J/m³].
    dissipated: f64,
}

impl Specimen {
    /// Under an isotropic pressure [Pa] at a relative density.
    fn new(relative_density: f64, pressure: f64) -> Self {
        let law = sand();
        let [loosest, densest] = [1350.0, 1650.0];
        let density = loosest * densest / (densest - relative_density * (densest - loosest));
        assert!((law.relative_density(density) - relative_density).abs() < 1e-12);
        let stress = [-pressure, -pressure, -pressure, 0.0, 0.0, 0.0];
        let memory = Memory { stress_ratio: 0.0, preconsolidation: pressure, ..Memory::default() };
        Self { law, point: Point { stress, density, memory, ..Point::default() }, dissipated: 0.0 }
    }

    fn strained(mut self, strain: Symmetric) -> Self {
        let old = self.point.stress;
        let moduli = self.law.stiffening.moduli(elastic(), -mean(old));
        let (shear, volume) = (deviator(strain), 3.0 * mean(strain));
        let trial = std::array::from_fn(|n| {
            old[n] + 2.0 * moduli.shear * shear[n] + if n < 3 { moduli.bulk * volume } else { 0.0 }
        });
        self.point.density *= (-volume).exp();
        if self.law.may_yield(trial, &self.point) {
            let back = self.law.return_map(trial, &self.point);
            self.point.stress = back.stress;
            self.point.plastic_strain += back.plastic_strain;
            self.point.memory = back.memory;
        } else {
            self.point.stress = trial;
        }
        let new = self.point.stress;
        let work: f64 =
            (0..6).map(|n| 0.5 * (old[n] + new[n]) * strain[n] * if n < 3 { 1.0 } else { 2.0 }).sum();
        self.dissipated += work + self.law.energy(old) - self.law.energy(new);
        self
    }

    /// One step of triaxial compression: axial strain, and the lateral strain that keeps the lateral stress.
    fn triaxial(self, axial: f64) -> Self {
        let lateral = self.point.stress[0];
        let at = |side: f64| self.strained([side, side, -axial, 0.0, 0.0, 0.0]);
        let (mut low, mut high) = (-2.0 * axial, 2.0 * axial);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if at(middle).point.stress[0] < lateral { low = middle } else { high = middle }
        }
        at(0.5 * (low + high))
    }

    /// Mobilised angle of friction [°].
    fn angle(&self) -> f64 {
        let [x, _, z, ..] = self.point.stress;
        ((z - x) / (z + x)).asin().to_degrees()
    }

    /// Relative density.
    fn state(&self) -> f64 {
        self.law.relative_density(self.point.density)
    }
}

/// Angle of friction, relative density and compaction after each 250 steps of triaxial compression.
fn compressed(relative_density: f64, pressure: f64) -> Vec<[f64; 3]> {
    let mut specimen = Specimen::new(relative_density, pressure);
    let start = specimen.point.density;
    let mut seen = Vec::new();
    for n in 0..STEPS {
        specimen = specimen.triaxial(STEP);
        if n % 250 == 249 {
            seen.push([specimen.angle(), specimen.state(), (specimen.point.density / start).ln()]);
        }
    }
    assert!(specimen.dissipated > 0.0);
    seen
}

#[test]
fn loose_and_dense_sand_end_at_the_critical_state() {
    let critical = 0.7 / (10.0 - 150.0_f64.ln());
    for pressure in [1e3, 2e4] {
        for relative_density in [-0.1, 0.2, 0.5] {
            let [angle, state, _] = compressed(relative_density, pressure)[STEPS / 250 - 1];
            assert!((angle - CRITICAL).abs() < 1.0, "{relative_density} {pressure}: {angle}°");
            assert!((state - critical).abs() < 0.08, "{relative_density} {pressure}: I_D {state}");
        }
    }
}

#[test]
fn the_peak_rises_with_the_density_as_bolton_found() {
    for relative_density in [0.4, 0.6, 0.8] {
        let seen = compressed(relative_density, 1e4);
        let peak = seen.iter().map(|[angle, ..]| *angle).fold(0.0, f64::max);
        let index = relative_density * (10.0 - 150.0_f64.ln()) - 0.7;
        // Lower by what the sand loosens before its strength is mobilised.
        let short = CRITICAL + 3.4 * index - peak;
        assert!((0.0..2.5).contains(&short), "{relative_density}: {peak}°, index {index}");
        // Rate of dilation per axial strain, where it is largest.
        let rates = seen.windows(2).map(|pair| (pair[0][2] - pair[1][2]) / (250.0 * STEP));
        let rate = rates.fold(0.0, f64::max);
        assert!((0.6..1.05).contains(&(rate / (0.28 * index))), "{relative_density}: {rate}");
    }
}

#[test]
fn loose_sand_compacts_and_dense_sand_compacts_before_it_dilates() {
    let loose = compressed(-0.1, 1e4);
    assert!(loose.windows(2).all(|pair| pair[1][2] >= pair[0][2] - 1e-6));
    assert!(loose[STEPS / 250 - 1][2] > 0.015);
    let mut dense = Specimen::new(0.7, 1e4);
    let start = dense.point.density;
    let mut most = 0.0_f64;
    for _ in 0..125 {
        dense = dense.triaxial(STEP);
        most = most.max(dense.point.density / start - 1.0);
    }
    assert!(most > 1e-5);
    let end = compressed(0.7, 1e4)[STEPS / 250 - 1];
    assert!(end[2] < -0.03, "{}", end[2]);
}

#[test]
fn compression_is_stiffer_the_higher_the_pressure_and_leaves_compaction() {
    for confined in [false, true] {
        let mut specimen = Specimen::new(0.3, 500.0);
        let strain = |size: f64| {
            if confined { [0.0, 0.0, -size, 0.0, 0.0, 0.0] } else { [-size, -size, -size, 0.0, 0.0, 0.0] }
        };
        let start = specimen.point;
        let mut moduli = Vec::new();
        for target in [1e3, 3e3, 1e4, 3e4, 1e5] {
            while -specimen.point.stress[2] < target {
                specimen = specimen.strained(strain(1e-6));
            }
            let next = specimen.strained(strain(1e-6));
            moduli.push((specimen.point.stress[2] - next.point.stress[2]) / 1e-6);
        }
        assert!(moduli.windows(2).all(|pair| pair[1] > 1.3 * pair[0] && pair[0] > 0.0), "{moduli:?}");
        // Janbu: with the power 7/8 of the pressure in first loading, less where elastic strain counts.
        let exponent = (moduli[4] / moduli[0]).ln() / 100.0_f64.ln();
        assert!((0.6..0.9).contains(&exponent), "{exponent}");
        let loaded = specimen.point.density;
        let (mut lost, before) = (specimen, moduli[4]);
        lost = lost.strained(strain(-1e-6));
        let unloading = (lost.point.stress[2] - specimen.point.stress[2]) / 1e-6;
        assert!(unloading > 1.5 * before, "{unloading} {before}");
        while -specimen.point.stress[2] > 1e3 {
            specimen = specimen.strained(strain(-1e-6));
        }
        let (rise, kept) = (loaded - start.density, specimen.point.density - start.density);
        assert!(kept > 0.3 * rise && kept < rise, "{kept} {rise}");
        assert!(specimen.dissipated > 0.0);
    }
}

#[test]
fn opened_sand_bears_nothing_and_forgets() {
    let specimen = Specimen::new(0.5, 1e3).strained([1e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0]);
    assert_eq!(specimen.point.stress, [0.0; 6]);
    assert_eq!(specimen.point.memory, Memory::default());
}

#[test]
fn dense_sand_that_is_sheared_at_constant_volume_gains_pressure() {
    let mut specimen = Specimen::new(0.8, 1e3);
    for _ in 0..5000 {
        specimen = specimen.strained([0.0, 0.0, 0.0, 0.0, 0.0, STEP]);
    }
    assert!(-mean(specimen.point.stress) > 5e3, "{:?}", specimen.point.stress);
}

#[test]
fn strength_in_extension_and_plane_strain_follows_matsuoka_and_nakai() {
    let law = sand();
    let sin = CRITICAL.to_radians().sin();
    let compression = 6.0 * sin / (3.0 - sin);
    let [_, _, one] = law.invariants([-1.0, -1.0, -3.0, 0.0, 0.0, 0.0]);
    let [_, _, extension] = law.invariants([-3.0, -3.0, -1.0, 0.0, 0.0, 0.0]);
    assert!((one - 1.0).abs() < 1e-12);
    assert!((extension * compression - 6.0 * sin / (3.0 + sin)).abs() < 1e-12);
    // With the mean of the others as the middle stress: Matsuoka and Nakai's invariant, here in principal
    // stresses.
    let exact = (9.0 - sin * sin) / (1.0 - sin * sin);
    let invariant = |angle: f64| {
        let s = angle.to_radians().sin();
        let [a, b, c] = [1.0 + s, 1.0, 1.0 - s];
        (a + b + c) * (a * b + b * c + c * a) / (a * b * c)
    };
    let (mut low, mut high) = (20.0, 60.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if invariant(middle) < exact { low = middle } else { high = middle }
    }
    let s = low.to_radians().sin();
    let [p, q, shape] = law.invariants([-(1.0 + s), -1.0, -(1.0 - s), 0.0, 0.0, 0.0]);
    assert!((q / (shape * p) / compression - 1.0).abs() < 0.03, "{}", q / (shape * p) / compression);
}

#[test]
fn sand_in_its_densest_state_compacts_no_further() {
    // Shear at hardly any pressure, forwards and backwards, compacts loose sand.
    let shaken = |relative_density: f64| {
        let mut specimen = Specimen::new(relative_density, 10.0);
        let mut most = f64::NEG_INFINITY;
        for n in 0..2000 {
            let shear = if n / 20 % 2 == 0 { 1e-4 } else { -1e-4 };
            specimen = specimen.strained([-1e-6, -1e-6, -1e-6, 0.0, 0.0, shear]);
            let pressure = -mean(specimen.point.stress);
            most = most.max(pressure);
        }
        most
    };
    let [loose, densest] = [0.2, RELATIVE_DENSITY[1]].map(shaken);
    assert!(loose < 100.0, "{loose} Pa");
    // A volume strain of 0.6 % against elastic moduli that grow with the pressure.
    assert!(densest > 1e4, "{densest} Pa");
}

/// A point under triaxial compression with a share of its peak mobilised, and the ratio of that peak.
fn mobilised(relative_density: f64, pressure: f64, share: f64, preconsolidation: f64) -> (Point, f64) {
    let Specimen { law, mut point, .. } = Specimen::new(relative_density, pressure);
    let peak = law.peak_ratio(relative_density * (10.0 - 150.0_f64.ln()) - 0.7);
    point.stress = triaxial(pressure, share * peak * pressure);
    point.memory = Memory { stress_ratio: share * peak, preconsolidation, ..Memory::default() };
    (point, peak)
}

/// The stress of triaxial compression with these invariants.
fn triaxial(p: f64, q: f64) -> Symmetric {
    [q / 3.0 - p, q / 3.0 - p, -2.0 * q / 3.0 - p, 0.0, 0.0, 0.0]
}

#[test]
fn a_step_hardens_along_the_hyperbola_dilates_as_bolton_found_and_compacts_as_janbu_found() {
    for (relative_density, pressure, share) in
        [(0.2, 1e4, 0.3), (0.5, 2e4, 0.5), (0.7, 8e4, 0.9), (0.9, 5e3, 0.6)]
    {
        for (preconsolidation, rise) in [(1e9, 0.0), (1e9, 1e-4), (pressure, 1e-4)] {
            let (point, peak) = mobilised(relative_density, pressure, share, preconsolidation);
            let [p_trial, q_trial] =
                [pressure * (1.0 + rise), share * peak * pressure * (1.0 + 4.0 * rise + 1e-4)];
            let back = sand().return_map(triaxial(p_trial, q_trial), &point);
            let Elastic { bulk, shear } = sand().stiffening.moduli(elastic(), pressure);
            let (p, q, flow) = (-mean(back.stress), mises(back.stress), back.plastic_strain);
            assert!(((q_trial - q) / (3.0 * shear * flow) - 1.0).abs() < 1e-3);
            let looseness = relative_density - 0.5;
            let reference = 0.0009 * (-1.5 * looseness).exp() * (pressure / 2e4).max(1.0).sqrt();
            let strain = |ratio: f64| 2.0 * reference * (ratio / peak).powi(2) / (1.0 - ratio / peak);
            let hardened = strain(back.memory.stress_ratio) - strain(share * peak);
            assert!((hardened / flow - 1.0).abs() < 0.01, "{relative_density}: {hardened} {flow}");
            // Of Bolton's dilatancy at the peak, and less by 0.6 of what is missing to its ratio.
            let index = relative_density * (10.0 - 150.0_f64.ln()) - 0.7;
            let contraction = 0.6 * (1.0 - share) * peak - 0.28 * index / (1.0 + 2.0 / 3.0 * 0.28);
            let modulus = 20e6 * (pressure / 1e5).powf(0.75) * (1.15 * looseness).exp();
            let compacted = contraction * flow + (p - preconsolidation).max(0.0) / modulus;
            let volume = (p_trial - p) / bulk;
            assert!(
                (volume - compacted).abs() < 0.01 * (flow + volume.abs()),
                "{relative_density}: {volume} {compacted}"
            );
            assert!((back.memory.preconsolidation / p.max(preconsolidation) - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn pressure_alone_compacts_along_the_modulus_of_compression() {
    for (relative_density, pressure) in [(0.2, 1e3), (0.9, 8e4), (0.5, 10.0)] {
        let (point, _) = mobilised(relative_density, pressure, 0.0, pressure);
        let back = sand().return_map(triaxial(1.01 * pressure, 0.0), &point);
        let bulk = sand().stiffening.moduli(elastic(), pressure).bulk;
        let modulus = 20e6 * (pressure.max(50.0) / 1e5).powf(0.75) * (1.15 * (relative_density - 0.5)).exp();
        let rise = -mean(back.stress) / pressure - 1.0;
        assert!(
            (rise / (0.01 * modulus / (bulk + modulus)) - 1.0).abs() < 0.01,
            "{relative_density}: {rise}"
        );
        assert!(back.plastic_strain < 1e-12 && back.gap_strain == 0.0);
    }
    let (point, _) = mobilised(0.5, 1e4, 0.0, 1e4);
    let opened = sand().return_map(triaxial(-2e3, 0.0), &point).gap_strain;
    assert!((opened * sand().stiffening.moduli(elastic(), 1e4).bulk - 2e3).abs() < 1e-6);
}

#[test]
fn indices_and_ratios_are_those_of_their_definitions() {
    let law = sand();
    // I_D = (e_max − e)/(e_max − e_min) for grains of any density.
    let voids = |density: f64| 2650.0 / density - 1.0;
    let exact = |density: f64| (voids(1350.0) - voids(density)) / (voids(1350.0) - voids(1650.0));
    for density in [1300.0, 1500.0, 1700.0] {
        assert!((law.relative_density(density) - exact(density)).abs() < 1e-12);
    }
    assert!((exact(law.densest()) - 1.2).abs() < 1e-12);
    assert_eq!([0.0, 900.0, 2500.0].map(|density| law.relative_density(density)), [-0.5, -0.5, 1.2]);
    for (relative_density, pressure, index) in [
        (0.8, 1e4, 0.8 * (10.0 - 150_f64.ln()) - 0.7),
        (0.8, 4e5, 0.8 * (10.0 - 400_f64.ln()) - 0.7),
        (0.8, 9e6, 0.8 * (10.0 - 1000_f64.ln()) - 0.7),
        (1.2, 1e4, 4.0),
        (-0.9, 1e4, -4.0),
    ] {
        assert!((law.dilatancy_index(relative_density, pressure) - index).abs() < 1e-4, "{index}");
    }
    // 4° of friction per index, as a tangent at the critical state.
    let ratio = |degrees: f64| 6.0 * degrees.to_radians().sin() / (3.0 - degrees.to_radians().sin());
    let tangent = (ratio(CRITICAL + 1e-3) - ratio(CRITICAL - 1e-3)) / 2e-3;
    for (index, peak) in
        [(0.0, ratio(CRITICAL)), (2.0, ratio(CRITICAL) + 8.0 * tangent), (-9.0, 0.5 * ratio(CRITICAL))]
    {
        assert!((law.peak_ratio(index) - peak).abs() < 1e-6, "{index}");
    }
    let (point, peak) = mobilised(0.5, 1e4, 0.5, 1e4);
    for (p, q, yields) in [(0.999, 0.998, false), (1.001, 0.9, true), (0.9, 0.901, true), (-0.1, 0.0, true)] {
        let stress = triaxial(p * 1e4, q * 0.5 * peak * 1e4);
        assert_eq!(law.may_yield(stress, &point), yields, "{p} {q}");
        assert_eq!(law.energy(stress), law.stiffening.energy(elastic(), stress));
    }
}

#[test]
fn the_shape_of_the_surface_does_not_depend_on_the_axes() {
    let law = sand();
    // The shape of Sheng, Sloan and Yu in pure shear.
    let fourth = ((3.0 - CRITICAL.to_radians().sin()) / (3.0 + CRITICAL.to_radians().sin())).powi(4);
    let exact = (2.0 * fourth / (1.0 + fourth)).powf(0.25);
    for stress in [
        [-2e3, -1e3, -3e3, 0.0, 0.0, 0.0],
        [-2e3, -2e3, -2e3, 1e3, 0.0, 0.0],
        [-2e3, -2e3, -2e3, 0.0, 1e3, 0.0],
        [-2e3, -2e3, -2e3, 0.0, 0.0, 1e3],
    ] {
        let [p, q, shape] = law.invariants(stress);
        assert!(
            (p - 2e3).abs() < 1e-9 && (q - 1e3 * 3_f64.sqrt()).abs() < 1e-9 && (shape - exact).abs() < 1e-12
        );
    }
    // All components equal: uniaxial, here tension, at an angle to all axes.
    let [_, q, shape] = law.invariants([0.0, 0.0, 0.0, 1e3, 1e3, 1e3]);
    assert!((q - 3e3).abs() < 1e-9 && (shape - fourth.powf(0.25)).abs() < 1e-12);
    for n in [[1.0, 2.0, 2.0], [2.0, -1.0, 2.0], [-2.0, 2.0, 1.0]].map(|n| n.map(|x: f64| x / 3.0)) {
        for (q, exact) in [(-1e3, 1.0), (1e3, fourth.powf(0.25))] {
            let normal = n.map(|x| q * (x * x - 1.0 / 3.0) - 2e3);
            let sheared = [n[0] * n[1], n[1] * n[2], n[0] * n[2]].map(|product| q * product);
            let [p, found, shape] =
                law.invariants([normal[0], normal[1], normal[2], sheared[0], sheared[1], sheared[2]]);
            assert!((p - 2e3).abs() < 1e-9 && (found - q.abs()).abs() < 1e-9);
            assert!((shape - exact).abs() < 1e-12, "{n:?} {q}: {shape}");
        }
    }
}
