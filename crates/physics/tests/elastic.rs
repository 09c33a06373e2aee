//! Elasticity against Hooke's law, and moduli that grow with the pressure.

use physics::elastic::{Elastic, Stiffening};

/// Steel: Young's modulus [Pa], Poisson's ratio.
const STEEL: [f64; 2] = [210e9, 0.3];

fn is_close(found: f64, exact: f64) -> bool {
    (found - exact).abs() <= 1e-12 * exact.abs()
}

#[test]
fn uniaxial_stress_stores_what_hookes_law_says() {
    let [young, poisson] = STEEL;
    let steel = Elastic::new(young, poisson);
    let (x, y, shear) =
        ([2e8, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 5e7, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 3e7]);
    assert!(is_close(steel.compliance(x, x), 2e8 * 2e8 / young));
    assert!(is_close(steel.compliance(x, y), -poisson * 2e8 * 5e7 / young));
    assert!(is_close(steel.compliance(shear, shear), 3e7 * 3e7 * 2.0 * (1.0 + poisson) / young));
    assert!(is_close(steel.energy(x), 0.5 * 2e8 * 2e8 / young));
    // σ₁ = M ε₁ without lateral strain: M = E (1 − ν)/((1 + ν)(1 − 2ν)).
    let constrained = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    assert!(is_close(steel.constrained(), constrained));
    // Longitudinal waves in steel: some 5.9 to 6.0 km/s in tables.
    assert!((steel.wave_speed(7850.0) - 6001.0).abs() < 1.0, "{}", steel.wave_speed(7850.0));
}

#[test]
fn moduli_grow_with_the_root_of_the_pressure_between_their_bounds() {
    let (steel, sand) = (Elastic::new(STEEL[0], STEEL[1]), Stiffening { least: 1e3, most: 1e5 });
    for (pressure, factor) in
        [(-1e4, 0.1), (0.0, 0.1), (1e3, 0.1), (4e3, 0.2), (2.5e4, 0.5), (1e5, 1.0), (1e7, 1.0)]
    {
        assert!(is_close(sand.factor(pressure), factor), "{pressure}");
        let moduli = sand.moduli(steel, pressure);
        assert!(is_close(moduli.bulk, factor * steel.bulk) && is_close(moduli.shear, factor * steel.shear));
    }
}

#[test]
fn the_energy_of_stiffening_soil_is_the_work_of_loading_it() {
    let (elastic, sand) = (Elastic::new(75e6, 0.2), Stiffening { least: 1e-6, most: 1e5 });
    let at = |p: f64, shear: f64| sand.energy(elastic, [-p, -p, -p, shear, 0.0, 0.0]);
    // ∫ p dp/K under pressure alone.
    const STEPS: usize = 100_000;
    let step = 5e4 / STEPS as f64;
    let work: f64 =
        (0..STEPS).map(|n| (n as f64 + 0.5) * step).map(|p| p * step / sand.moduli(elastic, p).bulk).sum();
    assert!((at(5e4, 0.0) / work - 1.0).abs() < 1e-6, "{} {work}", at(5e4, 0.0));
    // τ²/2G of shear under a constant pressure.
    let shear = sand.moduli(elastic, 5e4).shear;
    assert!(((at(5e4, 2e4) - at(5e4, 0.0)) * 2.0 * shear / (2e4 * 2e4) - 1.0).abs() < 1e-9);
}
