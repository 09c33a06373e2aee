//! Narrow blades: the comparison table of the derivation (vertical face, φ = 35°, δ = ⅔φ).

use analytic::cutting::{effective_width, hansen_end_factor, mckyes_ali_factors};
use analytic::disc::end_factor;
use analytic::earth_pressure::{Face, coulomb_total, sokolovskii};
use std::f64::consts::FRAC_PI_2;

#[test]
fn end_effects_match_the_table() {
    let rows = [
        (0.25, [9.29, 8.19, 9.53, 3.73]),
        (0.5, [5.21, 4.60, 5.26, 2.75]),
        (1.0, [3.16, 2.80, 3.13, 2.02]),
        (2.0, [2.11, 1.90, 2.07, 1.56]),
        (5.0, [1.47, 1.36, 1.43, 1.24]),
        (10.0, [1.24, 1.18, 1.21, 1.12]),
    ];
    let (phi, delta) = (35_f64.to_radians(), 70_f64.to_radians() / 3.0);
    let field = sokolovskii(&Face::degrees(35.0, 70.0 / 3.0, 90.0, 0.0)).unwrap();
    let m = field.rupture_ratio;
    let plane = mckyes_ali_factors(phi, delta, FRAC_PI_2, 1e9).unwrap().weight;
    assert!((2.0 * plane - 9.96).abs() < 0.01, "{plane}");
    assert!(
        (2.0 * plane / coulomb_total(&Face::degrees(35.0, 70.0 / 3.0, 90.0, 0.0)).unwrap() - 1.0).abs()
            < 1e-6
    );
    // K_a of the same wall, exact to the printed digits of R: 0.244 (Coulomb, active).
    let excess = field.coefficient / delta.cos() - 0.244;
    for (width, row) in rows {
        let found = [
            mckyes_ali_factors(phi, delta, FRAC_PI_2, width).unwrap().weight / plane,
            end_factor(m, width),
            effective_width(width, 1.0, m) / width,
            hansen_end_factor(excess, width, 1.0, 0.0, f64::INFINITY).unwrap(),
        ];
        println!("w/d={width}: {found:.3?} for {row:?}");
        for (got, want) in found.into_iter().zip(row) {
            assert!((got / want - 1.0).abs() < 6e-3, "w/d={width}: {got} for {want}");
        }
    }
}
