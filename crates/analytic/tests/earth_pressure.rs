//! The tables of the derivation: K_p of vertical walls, K_n of the faces of a disc, Martin's N_γ.

use analytic::earth_pressure::{Face, coulomb, coulomb_total, lancellotta, log_spiral, rankine, sokolovskii};

fn total(k: f64, face: &Face) -> f64 {
    k / face.wall_friction.cos()
}

/// φ, δ/φ, Coulomb, Lancellotta, Sokolovskii, log-spiral; totals on a vertical wall.
const VERTICAL: [(f64, f64, f64, f64, f64, f64); 30] = [
    (20., 0., 2.040, 2.040, 2.040, 2.040),
    (20., 1. / 3., 2.414, 2.365, 2.384, 2.387),
    (20., 0.5, 2.635, 2.515, 2.559, 2.568),
    (20., 2. / 3., 2.888, 2.654, 2.732, 2.752),
    (20., 1., 3.525, 2.872, 3.044, 3.128),
    (25., 0., 2.464, 2.464, 2.464, 2.464),
    (25., 1. / 3., 3.124, 3.025, 3.063, 3.069),
    (25., 0.5, 3.552, 3.300, 3.388, 3.405),
    (25., 2. / 3., 4.079, 3.563, 3.722, 3.763),
    (25., 1., 5.599, 4.002, 4.358, 4.536),
    (30., 0., 3.000, 3.000, 3.000, 3.000),
    (30., 1. / 3., 4.143, 3.946, 4.020, 4.031),
    (30., 0.5, 4.977, 4.439, 4.614, 4.648),
    (30., 2. / 3., 6.105, 4.930, 5.256, 5.339),
    (30., 1., 10.095, 5.804, 6.548, 6.927),
    (35., 0., 3.690, 3.690, 3.690, 3.690),
    (35., 1. / 3., 5.680, 5.277, 5.420, 5.442),
    (35., 0.5, 7.357, 6.164, 6.520, 6.589),
    (35., 2. / 3., 9.962, 7.090, 7.773, 7.947),
    (35., 1., 22.971, 8.850, 10.466, 11.292),
    (40., 0., 4.599, 4.599, 4.599, 4.599),
    (40., 1. / 3., 8.147, 7.284, 7.572, 7.616),
    (40., 0.5, 11.771, 8.916, 9.665, 9.813),
    (40., 2. / 3., 18.717, 10.712, 12.210, 12.592),
    (40., 1., 92.6, 14.393, 18.127, 20.004),
    (45., 0., 5.828, 5.828, 5.828, 5.829),
    (45., 1. / 3., 12.466, 10.479, 11.087, 11.181),
    (45., 0.5, 21.379, 13.602, 15.279, 15.612),
    (45., 2. / 3., 46.087, 17.268, 20.797, 21.693),
    (45., 1., f64::INFINITY, 25.472, 34.933, 39.459),
];

#[test]
fn vertical_walls_match_the_table() {
    let mut worst = [0.0_f64; 4];
    for (phi, ratio, wedge, fan, exact, spiral) in VERTICAL {
        let face = Face::degrees(phi, phi * ratio, 90.0, 0.0);
        let mut note = |n: usize, got: f64, want: f64| {
            let error = (got / want - 1.0).abs();
            if error > worst[n] {
                worst[n] = error;
                println!("column {n} φ={phi} δ/φ={ratio:.3}: {got:.4} for {want} ({error:.1e})");
            }
        };
        if wedge.is_finite() {
            note(0, coulomb_total(&face).unwrap(), wedge);
        } else {
            assert!(coulomb_total(&face).is_err());
        }
        note(1, total(lancellotta(&face).unwrap(), &face), fan);
        note(2, total(sokolovskii(&face).unwrap().coefficient, &face), exact);
        note(3, total(log_spiral(&face).unwrap(), &face), spiral);
        let smooth = Face::degrees(phi, 0.0, 90.0, 0.0);
        assert!((rankine(&smooth).unwrap() - (45.0 + phi / 2.0).to_radians().tan().powi(2)).abs() < 1e-12);
    }
    println!("worst relative errors: Coulomb, Lancellotta, Sokolovskii, log-spiral {worst:?}");
    assert!(worst[0] < 1e-3 && worst[1] < 1e-3 && worst[2] < 1e-3 && worst[3] < 1e-3);
}

const NONE: f64 = f64::NAN;
/// α [deg], K_n for δ/φ = −⅔, −⅓, 0, ⅓, ⅔, 0.9, then r_f/L for −⅔, 0, ⅔; NaN where no continuous field
/// exists.
#[allow(clippy::approx_constant)] // 6.28 is a coefficient here.
const DISC_30: [[f64; 10]; 13] = [
    [5., 2.89, 7.14, 13.95, 23.04, 32.92, 38.70, 0.68, 1.87, 2.93],
    [10., 2.85, 6.68, 12.73, 20.78, 29.54, 34.68, 0.71, 1.86, 2.90],
    [15., 2.80, 6.25, 11.63, 18.75, 26.51, 31.07, 0.74, 1.86, 2.87],
    [20., 2.74, 5.86, 10.63, 16.93, 23.79, 27.83, 0.77, 1.85, 2.83],
    [25., 2.67, 5.49, 9.73, 15.30, 21.35, 24.93, 0.80, 1.85, 2.80],
    [30., 2.60, 5.15, 8.92, 13.82, 19.16, 22.32, 0.83, 1.85, 2.77],
    [35., 2.52, 4.82, 8.17, 12.50, 17.19, 19.98, 0.85, 1.84, 2.74],
    [40., 2.43, 4.52, 7.49, 11.30, 15.42, 17.87, 0.88, 1.84, 2.71],
    [50., 2.25, 3.95, 6.29, 9.23, 12.40, 14.28, 0.92, 1.83, 2.64],
    [60., NONE, 3.44, 5.27, 7.53, 9.93, 11.36, NONE, 1.81, 2.57],
    [70., NONE, 2.97, 4.40, 6.12, 7.93, 9.00, NONE, 1.79, 2.49],
    [80., NONE, NONE, 3.65, 4.94, 6.28, 7.07, NONE, 1.77, 2.41],
    [90., NONE, NONE, 3.00, 3.96, 4.94, 5.51, NONE, 1.73, 2.33],
];
const DISC_35: [[f64; 10]; 13] = [
    [5., 4.45, 13.49, 30.63, 56.46, 86.97, 105.4, 0.88, 2.62, 4.28],
    [10., 4.19, 12.03, 26.73, 48.87, 75.05, 90.93, 0.90, 2.57, 4.17],
    [15., 3.95, 10.77, 23.37, 42.33, 64.78, 78.43, 0.92, 2.51, 4.06],
    [20., 3.72, 9.66, 20.48, 36.70, 55.94, 67.65, 0.94, 2.46, 3.95],
    [25., 3.51, 8.69, 17.98, 31.84, 48.31, 58.35, 0.96, 2.42, 3.85],
    [30., 3.31, 7.84, 15.81, 27.66, 41.73, 50.33, 0.98, 2.37, 3.75],
    [35., 3.12, 7.09, 13.93, 24.04, 36.05, 43.41, 0.99, 2.33, 3.65],
    [40., 2.94, 6.42, 12.30, 20.92, 31.15, 37.44, 1.01, 2.29, 3.56],
    [50., 2.60, 5.28, 9.62, 15.87, 23.27, 27.83, 1.04, 2.21, 3.37],
    [60., NONE, 4.36, 7.57, 12.07, 17.38, 20.66, NONE, 2.14, 3.20],
    [70., NONE, 3.60, 5.96, 9.19, 12.96, 15.29, NONE, 2.07, 3.03],
    [80., NONE, NONE, 4.70, 7.00, 9.64, 11.28, NONE, 2.00, 2.86],
    [90., NONE, NONE, 3.69, 5.31, 7.14, 8.26, NONE, 1.92, 2.70],
];
/// α, then K_n for δ/φ = −⅓, 0, ⅓ and r_f/L at 0, for φ = 40° and again for 45°.
const DISC_STEEP: [[f64; 9]; 7] = [
    [10., 22.67, 60.13, 125.7, 3.58, 45.58, 149.2, 367.6, 5.12],
    [20., 16.58, 42.16, 86.87, 3.32, 30.13, 95.17, 232.3, 4.60],
    [30., 12.34, 29.83, 60.22, 3.10, 20.35, 61.20, 147.1, 4.14],
    [40., 9.34, 21.32, 41.92, 2.89, 14.08, 39.79, 93.44, 3.74],
    [50., 7.18, 15.41, 29.32, 2.71, 9.99, 26.24, 59.66, 3.40],
    [60., 5.58, 11.26, 20.62, 2.55, 7.24, 17.59, 38.34, 3.10],
    [90., NONE, 4.60, 7.37, 2.14, NONE, 5.83, 10.71, 2.41],
];

/// Half a unit of the last of `digits` significant digits of a printed value, or 0.1 % of it.
fn printed(value: f64, digits: i32) -> f64 {
    let last = 10_f64.powf(value.abs().log10().floor() + 1.0 - f64::from(digits));
    (0.5 * last).max(1e-3 * value)
}

fn check(face: &Face, coefficient: f64, reach: Option<f64>) -> f64 {
    let found = sokolovskii(face);
    if coefficient.is_nan() {
        assert!(found.is_err(), "{face:?} should have no field");
        return 0.0;
    }
    let found = found.expect("a field");
    if let Some(reach) = reach {
        assert!(
            (found.rupture_ratio - reach).abs() < 0.0052,
            "{face:?}: {} for {reach}",
            found.rupture_ratio
        );
    }
    let digits = if coefficient < 10.0 { 3 } else { 4 };
    assert!(
        (found.coefficient - coefficient).abs() <= 1.02 * printed(coefficient, digits),
        "{face:?}: {found:?} for {coefficient}"
    );
    (found.coefficient / coefficient - 1.0).abs()
}

#[test]
fn faces_of_a_disc_match_the_table() {
    let mut worst = 0.0_f64;
    for (phi, rows) in [(30.0, &DISC_30), (35.0, &DISC_35)] {
        for row in rows {
            for (n, ratio) in [-2. / 3., -1. / 3., 0., 1. / 3., 2. / 3., 0.9].into_iter().enumerate() {
                let reach = match n {
                    0 => Some(row[7]),
                    2 => Some(row[8]),
                    4 => Some(row[9]),
                    _ => None,
                };
                worst = worst.max(check(&Face::degrees(phi, phi * ratio, row[0], 0.0), row[n + 1], reach));
            }
        }
    }
    for row in DISC_STEEP {
        for (phi, at) in [(40.0, 1), (45.0, 5)] {
            for (n, ratio) in [-1. / 3., 0., 1. / 3.].into_iter().enumerate() {
                let reach = (n == 1).then_some(row[at + 3]);
                worst = worst.max(check(&Face::degrees(phi, phi * ratio, row[0], 0.0), row[at + n], reach));
            }
        }
    }
    println!("worst relative difference from the printed K_n (three digits printed): {worst:.1e}");
}

#[test]
fn single_rows_match_to_a_thousandth() {
    let rows = [
        (30., 0., 40., 0., 7.489),
        (35., 0., 30., 0., 15.811),
        (35., 70. / 3., 50., 0., 23.270),
        (35., -35. / 3., 40., 0., 6.419),
        (30., 0., 30., 15., 13.876),
        (35., 17.5, 90., 10., 9.054),
        (35., 17.5, 90., -10., 4.063),
    ];
    for (phi, delta, alpha, beta, expected) in rows {
        let found = sokolovskii(&Face::degrees(phi, delta, alpha, beta)).unwrap().coefficient;
        println!("{phi} {delta} {alpha} {beta}: {found:.4} for {expected}");
        assert!((found / expected - 1.0).abs() < 1e-3);
    }
}

#[test]
fn smooth_strip_is_martins() {
    let martin = [
        (10., 0.2810, 0.2809),
        (15., 0.6991, 0.6991),
        (20., 1.579, 1.5786),
        (25., 3.461, 3.4611),
        (30., 7.653, 7.6530),
        (35., 17.58, 17.5771),
        (40., 43.19, 43.1866),
        (45., 117.6, 117.576),
        (50., 372.0, 371.967),
    ];
    for (phi, martin, note) in martin {
        let half = 0.5 * sokolovskii(&Face::degrees(phi, 0.0, 0.0, 0.0)).unwrap().coefficient;
        println!("N_γ smooth {phi}°: {half:.5}, Martin {martin}");
        assert!((half / martin - 1.0).abs() < 5e-4 && (half / note - 1.0).abs() < 3e-4);
    }
}

#[test]
fn slope_factors_match() {
    let table = [
        (30., [(-10., 0.70), (10., 1.36), (15., 1.56), (20., 1.77), (25., 1.99)]),
        (35., [(-10., 0.66), (10., 1.44), (15., 1.71), (20., 2.01), (25., 2.34)]),
        (40., [(-10., 0.62), (10., 1.55), (15., 1.90), (20., 2.31), (25., 2.79)]),
    ];
    for (phi, row) in table {
        for (beta, factor) in row {
            let k = |beta| sokolovskii(&Face::degrees(phi, 0.0, 30.0, beta)).unwrap().coefficient;
            let found = k(beta) / k(0.0);
            println!("φ={phi} β={beta}: {found:.3} for {factor}");
            assert!((found / factor - 1.0).abs() < 0.02);
        }
    }
}

#[test]
fn coulomb_on_the_overhanging_face_is_far_too_large_or_missing() {
    let rows = [
        (30., 0., 90., 3.00),
        (30., 0., 70., 4.71),
        (30., 0., 60., 6.46),
        (30., 0., 50., 10.5),
        (30., 0., 40., 27.8),
        (30., 0., 35., 87.0),
        (30., 10., 60., 13.9),
        (30., 10., 50., 40.3),
        (30., 10., 45., 133.0),
        (35., 0., 50., 20.5),
        (35., 0., 40., 125.0),
        (40., 0., 60., 16.9),
        (40., 0., 50., 50.4),
    ];
    for (phi, delta, alpha, expected) in rows {
        let found = coulomb(&Face::degrees(phi, delta, alpha, 0.0)).unwrap();
        assert!((found / expected - 1.0).abs() < 5e-3, "{phi} {delta} {alpha}: {found} for {expected}");
    }
    for (phi, delta, alpha) in [(30., 0., 30.), (30., 10., 40.), (35., 0., 35.), (40., 0., 40.)] {
        assert!(coulomb(&Face::degrees(phi, delta, alpha, 0.0)).is_err());
    }
}

/// The field is found for each of a thousand faces. Also a benchmark: the user time of this test in seconds
/// is the time of one coefficient in milliseconds.
#[test]
fn a_thousand_fields() {
    let ratios = [-0.4, 0.0, 0.3, 0.6, 1.0];
    let mut sum = 0.0;
    for n in 0..1000 {
        let phi = 25.0 + 20.0 * f64::from(n % 40) / 39.0;
        let ratio = ratios[n as usize % 5];
        let surface = if ratio < 0.0 { 15.0 + f64::from(n % 30) } else { 15.0 + f64::from(n % 76) };
        sum += sokolovskii(&Face::degrees(phi, ratio * phi, surface, 0.0)).unwrap().coefficient;
    }
    assert!(sum.is_finite());
}
