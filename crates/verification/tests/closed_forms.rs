//! The numbers in the files `expected.toml` are those of the closed forms that they name.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use analytic::bearing::{davis_friction_angle, weight_factor_exact_smooth, weight_factor_martin_rough};
use analytic::earth_pressure::{Face, sokolovskii};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use verification::expectation::{Suite, Target};
use verification::expectations;
use verification::row::Expected;

/// Lower and upper end of what the full suite expects; both are the same for a single value.
fn expected(id: &str, case: &str, quantity: &str) -> [f64; 2] {
    let known = expectations().unwrap().iter().find(|known| known.id == id).unwrap();
    match known.find(case, quantity, Suite::Full).unwrap().target {
        Target::Number(Expected::Value(value)) => [value; 2],
        Target::Number(Expected::Between(low, high)) => [low, high],
        ref other => panic!("{id}: {case}: {other:?}"),
    }
}

#[track_caller]
fn same(found: [f64; 2], closed_form: [f64; 2]) {
    for (found, exact) in found.into_iter().zip(closed_form) {
        assert!((found / exact - 1.0).abs() < 1e-12, "{found} is not {exact}");
    }
}

/// Davis' friction angle of sand that keeps its volume [rad].
fn davis(angle: f64) -> f64 {
    davis_friction_angle(angle, 0.0).unwrap()
}

#[test]
fn footings_on_clay_are_prandtls() {
    for id in ["B1", "B2"] {
        same(expected(id, "B/h = 16", "bearing capacity factor N_c"), [2.0 + PI; 2]);
    }
}

#[test]
fn footings_on_sand_are_martins() {
    for (angle, is_rough) in [20.0_f64, 25.0, 30.0, 35.0].into_iter().flat_map(|a| [(a, false), (a, true)]) {
        let word = if is_rough { "rough" } else { "smooth" };
        let form = if is_rough { weight_factor_martin_rough } else { weight_factor_exact_smooth };
        let exact = |angle: f64| form(angle).unwrap();
        let case = |dilation: f64| format!("{word}, φ = {angle}°, ψ = {dilation}°, B/h = 16");
        let found = |dilation: f64| expected("B4", &case(dilation), "bearing capacity factor N_γ");
        let phi = angle.to_radians();
        same(found(angle), [exact(phi); 2]);
        same(found(0.0), [exact(davis(phi)), exact(phi)]);
    }
}

#[test]
fn smooth_walls_are_rankines() {
    let rankine = |angle: f64| (FRAC_PI_4 + 0.5 * angle.to_radians()).tan().powi(2);
    for angle in [30.0_f64, 35.0, 40.0] {
        let bracket = [rankine(davis(angle.to_radians()).to_degrees()), rankine(angle)];
        let found = |dilation: f64, quantity: &str| {
            expected("B5", &format!("φ = {angle}°, ψ = {dilation}°, H/h = 16"), quantity)
        };
        same(found(angle, "K_p, heave included"), [rankine(angle); 2]);
        for quantity in [
            "K_p, heave included",
            "K_p over the undisturbed height",
            "largest K_p up to 0.02 H, heave included",
            "residual K_p over the last third, heave included",
        ] {
            same(found(0.0, quantity), bracket);
        }
        if angle == 35.0 {
            same(expected("E3", "H/h = 16", "K_p over the undisturbed height"), bracket);
        }
    }
}

#[test]
fn rough_walls_and_plates_are_sokolovskiis() {
    let coefficient = |friction_angle: f64, wall_friction: f64, surface: f64| {
        let wall_friction = wall_friction.min(friction_angle);
        sokolovskii(&Face { friction_angle, wall_friction, surface, backfill: 0.0 }).unwrap().coefficient
    };
    let check = |id: &str, case: &str, quantity: &str, angle: f64, [wall_friction, surface]: [f64; 2]| {
        let phi = angle.to_radians();
        let exact = |phi: f64| coefficient(phi, wall_friction, surface);
        let found = |dilation: f64| expected(id, &case.replace('?', &dilation.to_string()), quantity);
        same(found(angle), [exact(phi); 2]);
        same(found(0.0), [exact(davis(phi)), exact(phi)]);
    };
    for (angle, ratio) in [(30.0_f64, 0.5), (35.0, 2.0 / 3.0)] {
        let delta = ratio * angle.to_radians();
        let case = format!("φ = {angle}°, δ = {:.1}°, ψ = ?°, H/h = 16", delta.to_degrees());
        check("B6", &case, "K_n = K_p cos δ", angle, [delta, FRAC_PI_2]);
    }
    for (angle, inclination) in [(30.0, 60.0_f64), (30.0, 40.0), (35.0, 30.0)] {
        let case = format!("φ = {angle}°, α = {inclination}°, ψ = ?°, L/h = 16");
        check("B7", &case, "normal coefficient K_n", angle, [0.0, inclination.to_radians()]);
    }
}

/// Run-outs of the laws of Lube et al. (2005) and of Lajeunesse et al. (2005); where a law leaves a gap
/// between its two parts, the first is extended up to the second.
#[test]
fn columns_run_out_as_published() {
    for a in [0.5_f64, 1.0, 2.0, 3.0, 4.0] {
        let power = a.powf(2.0 / 3.0);
        let lube = if a < 2.8 { 1.2 * a } else { 1.9 * power };
        let lajeunesse = if a < 3.0 { 1.8 * a } else { 2.3 * power };
        let case = format!("a = {a}, φ = 37°, L₀/h = 20");
        same(expected("C1", &case, "run-out (L − L₀)/L₀"), [lube, lajeunesse]);
    }
    for a in [0.6_f64, 1.0, 2.0, 3.0] {
        let exact = if a < 1.7 { 1.24 * a } else { 1.6 * a.sqrt() };
        let case = format!("a = {a}, φ = 31°, r₀/h = 10");
        same(expected("C2", &case, "run-out (r − r₀)/r₀"), [exact; 2]);
    }
}

/// Final heights of the two laws over L₀. Lajeunesse's factor of a^⅓ is read from the line through the
/// measured points in the figure (1.92 at a = 10, 2.78 at a = 30). Of the round columns those of Lube et al.
/// (2004).
#[test]
fn columns_end_as_high_as_published() {
    for a in [0.5_f64, 1.0, 2.0, 3.0, 4.0] {
        let lube = if a < 1.15 { a } else { 0.65 * a.powf(0.4) };
        let lajeunesse = if a < 0.7 { a } else { 0.895 * a.cbrt() };
        let case = format!("a = {a}, φ = 37°, L₀/h = 20");
        let both = [lube.min(lajeunesse), lube.max(lajeunesse)];
        same(expected("C1", &case, "final height over L₀"), both);
    }
    for (a, heights) in [(0.6, [0.6; 2]), (1.0, [0.88, 1.0]), (3.0, [0.88 * 3_f64.powf(1.0 / 6.0); 2])] {
        let case = format!("a = {a}, φ = 31°, r₀/h = 10");
        same(expected("C2", &case, "final height over r₀"), heights);
    }
}
