//! Undrained clay: Tresca's law where nothing changes its strength, and the strength that remoulding and rate
//! leave.

use physics::clay::{Clay, ClayParameters};
use physics::elastic::Elastic;
use physics::mohr_coulomb::MohrCoulomb;
use physics::tensor::Symmetric;
use physics::yield_law::{Memory, Point, YieldLaw};

const STRENGTH: f64 = 5e3;
const LASTING: ClayParameters = ClayParameters {
    sensitivity: 1.0,
    remoulding_strain: 20.0,
    rate_strengthening: 0.0,
    reference_rate: 1e-5,
};

fn elastic() -> Elastic {
    Elastic::new(3e6, 0.49)
}

fn intact(duration: f64) -> Point {
    let memory = Memory { intact_strength: STRENGTH, ..Memory::default() };
    Point { memory, duration, ..Point::default() }
}

/// Shear stress [Pa] after simple shear to an engineering strain at a rate [1/s], in steps of 1e-4 of strain.
fn shear_stress(parameters: &ClayParameters, rate: f64, strain: f64) -> f64 {
    const STEP: f64 = 1e-4;
    let (law, mut point) = (Clay::new(elastic(), parameters), intact(STEP / rate));
    for _ in 0..(strain / STEP).round() as usize {
        let mut trial = point.stress;
        trial[3] += elastic().shear * STEP;
        let returned = law.return_map(trial, &point);
        point.stress = returned.stress;
        point.plastic_strain += returned.plastic_strain;
    }
    point.stress[3]
}

#[test]
fn clay_that_keeps_its_strength_is_tresca() {
    let (clay, tresca) = (Clay::new(elastic(), &LASTING), MohrCoulomb::tresca(elastic(), STRENGTH));
    let trials: [Symmetric; 4] = [
        [-2e4, -9e3, -3e4, 2e3, -1e3, 500.0],
        [1e4, -2e4, 3e3, 0.0, 4e3, -6e3],
        [-1e5, -1e5, -7e4, 1e4, 0.0, 0.0],
        [-1e3, -2e3, -3e3, 0.0, 0.0, 0.0],
    ];
    for trial in trials {
        let [own, other] =
            [clay.return_map(trial, &intact(1e-5)), tresca.return_map(trial, &Point::default())];
        assert_eq!(own.stress, other.stress);
        assert_eq!(own.plastic_strain, other.plastic_strain);
        let is_left = (0..6).all(|n| (own.stress[n] - trial[n]).abs() < 1e-9 * STRENGTH);
        assert!(clay.may_yield(trial, &intact(1e-5)) || is_left, "{trial:?}");
        assert!(!clay.may_yield(trial, &intact(0.0)), "no time passes in a remap");
    }
}

#[test]
fn remoulding_takes_the_strength_away() {
    let sensitive = ClayParameters { sensitivity: 4.0, remoulding_strain: 2.0, ..LASTING };
    for strain in [0.2_f64, 1.0, 2.0, 10.0] {
        // Up to the elastic part of the strain, 0.005.
        let expected = STRENGTH * (0.25 + 0.75 * (-3.0 * (strain - 0.005) / 2.0).exp());
        let stress = shear_stress(&sensitive, 1e-6, strain);
        assert!((stress / expected - 1.0).abs() < 5e-3, "{strain}: {stress} Pa of {expected} Pa");
    }
    let law = Clay::new(elastic(), &sensitive);
    assert!((law.slow_strength(STRENGTH, 1e9) / (0.25 * STRENGTH) - 1.0).abs() < 1e-12);
}

#[test]
fn fast_shear_finds_more_strength() {
    let viscous = ClayParameters { rate_strengthening: 0.1, ..LASTING };
    for (rate, factor) in [(1e-7, 1.0), (1e-5, 1.0), (1e-3, 1.2), (10.0, 1.6)] {
        let stress = shear_stress(&viscous, rate, 0.05);
        assert!((stress / (factor * STRENGTH) - 1.0).abs() < 1e-5, "{rate} 1/s: {stress} Pa");
    }
}

#[test]
fn the_cheap_check_is_the_circle_that_touches_the_hexagon_in_simple_shear() {
    let law = Clay::new(elastic(), &LASTING);
    for (part, yields) in [(0.999, false), (1.001, true)] {
        let stress = [-1e4, -1e4, -1e4, part * STRENGTH, 0.0, 0.0];
        assert_eq!(law.may_yield(stress, &intact(1.0)), yields);
    }
}
