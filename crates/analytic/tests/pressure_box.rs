//! The exact coefficient over its whole range: found wherever the field exists, smooth, bounded, fast.

use analytic::earth_pressure::{
    Face, PressureTable, TableRange, compare, coulomb, eurocode, log_spiral, sokolovskii,
    surcharge_coefficient,
};
use proptest::prelude::*;
use std::time::Instant;

#[test]
fn every_face_in_range_is_solved_or_has_a_negative_fan() {
    let (mut count, mut refused, mut wrong) = (0, 0, 0);
    for phi in [10., 15., 25., 35., 45., 50.] {
        for ratio in [-2. / 3., -1. / 3., 0., 0.3, 0.9, 1.0] {
            for beta in [-10., 0., 8., 25.] {
                if beta >= phi - 0.06 || -beta >= phi - 0.06 {
                    continue;
                }
                for alpha in [0., 3., 15., 30., 45., 60., 75., 90.] {
                    count += 1;
                    let face = Face::degrees(phi, phi * ratio, alpha, beta);
                    match sokolovskii(&face) {
                        Ok(field) => wrong += violations(&face, field.coefficient),
                        Err(why) if why.to_string().contains("discontinuity") => refused += 1,
                        Err(why) => {
                            wrong += 1;
                            println!("unsolved {phi} {ratio:.2} {beta} {alpha}: {why}");
                        }
                    }
                }
            }
        }
    }
    println!("{count} faces, {refused} without a continuous field, {wrong} wrong");
    assert_eq!(wrong, 0);
}

/// Number of known bounds and trends that the coefficient violates.
fn violations(face: &Face, k: f64) -> usize {
    let mut violations = Vec::new();
    if log_spiral(face).is_ok_and(|bound| k > bound * (1.0 + 1e-5)) {
        violations.push("above the upper bound");
    }
    if eurocode(face).is_ok_and(|bound| k < bound * (1.0 - 1e-6)) {
        violations.push("below the overburden estimate");
    }
    let other = |face: Face| sokolovskii(&face).map_or(f64::INFINITY, |field| field.coefficient);
    if other(Face { wall_friction: face.wall_friction + 0.01, ..*face }) <= k {
        violations.push("not rising with wall friction");
    }
    let phi = face.friction_angle + 0.005;
    if other(Face { friction_angle: phi, ..*face }) <= k {
        violations.push("not rising with friction");
    }
    if other(Face { backfill: face.backfill + 0.01, ..*face }) <= k {
        violations.push("not rising with the backfill");
    }
    for violation in &violations {
        println!("violation {face:?} {k}: {violation}");
    }
    violations.len()
}

/// A millisecond of a current core is about 10⁵ sines; the comparison is independent of the load of the
/// machine.
#[test]
fn one_solution_takes_less_than_a_hundred_thousand_sines() {
    let start = Instant::now();
    for n in 0..200 {
        let face = Face::degrees(20.0 + 0.1 * f64::from(n), 5.0, 10.0 + 0.4 * f64::from(n), 0.0);
        sokolovskii(std::hint::black_box(&face)).unwrap();
    }
    let each = start.elapsed().as_secs_f64() / 200.0;
    let start = Instant::now();
    let sum: f64 = (0..2_000_000).map(|n| std::hint::black_box(f64::from(n)).sin()).sum();
    let sines = start.elapsed().as_secs_f64() / 20.0;
    println!("one exact coefficient: {:.1} µs, 10⁵ sines {:.1} µs ({sum:.1})", each * 1e6, sines * 1e6);
    assert!(each < sines, "{each} s, {sines} s");
}

#[test]
fn the_table_agrees_with_the_solver() {
    let range = TableRange {
        friction_angle: (25_f64.to_radians(), 45_f64.to_radians()),
        wall_friction_ratio: (0.0, 0.5),
        surface: (5_f64.to_radians(), 60_f64.to_radians()),
        backfill: 0.0,
    };
    let table = PressureTable::new(range).unwrap();
    let mut worst = [0.0_f64; 2];
    for n in 0..300 {
        let sample = |prime: f64| (f64::from(n) * prime.sqrt()).fract();
        let phi = 25.0 + 20.0 * sample(2.0);
        let face = Face::degrees(phi, phi * 0.5 * sample(3.0), 5.0 + 55.0 * sample(5.0), 0.0);
        let (quick, exact) = (table.field(&face).unwrap(), sokolovskii(&face).unwrap());
        worst[0] = worst[0].max((quick.coefficient / exact.coefficient - 1.0).abs());
        worst[1] = worst[1].max((quick.rupture_ratio / exact.rupture_ratio - 1.0).abs());
    }
    let start = Instant::now();
    let face = Face::degrees(33.0, 4.0, 27.0, 0.0);
    let sum: f64 = (0..10_000).map(|_| table.field(std::hint::black_box(&face)).unwrap().coefficient).sum();
    println!("table: worst {worst:?}, {:.2} µs each ({sum:.0})", start.elapsed().as_secs_f64() * 100.0);
    assert!(worst[0] < 1e-4 && worst[1] < 1e-3);
    assert!(table.field(&Face::degrees(50.0, 0.0, 30.0, 0.0)).is_err());
}

#[test]
fn the_comparison_gives_a_reason_for_every_gap() {
    let all = compare(&Face::degrees(33.0, 10.0, 70.0, 5.0));
    assert!(all.rankine.is_err() && all.lancellotta.is_err());
    let (exact, bound) = (all.sokolovskii.unwrap(), all.log_spiral.unwrap());
    assert!(
        exact.coefficient < bound && all.coulomb.unwrap() > bound && all.en1997.unwrap() < exact.coefficient
    );
    let disc = compare(&Face::degrees(33.0, 10.0, 25.0, 0.0));
    assert!(disc.coulomb.unwrap_err().to_string().contains("overhanging"));
    for (phi, delta) in [(5.0, 0.0), (30.0, -30.0), (55.0, 0.0)] {
        assert!(sokolovskii(&Face::degrees(phi, delta, 40.0, 0.0)).is_err());
    }
}

proptest! {
    #[test]
    fn nothing_is_ever_nan_or_infinite(phi in -10.0..100.0_f64, delta in -60.0..60.0_f64,
                                       alpha in -10.0..100.0_f64, beta in -40.0..40.0_f64) {
        let face = Face::degrees(phi, delta, alpha, beta);
        let all = compare(&face);
        for k in [all.rankine, all.coulomb, all.lancellotta, all.en1997, all.log_spiral.clone()].into_iter().flatten() {
            prop_assert!(k.is_finite() && k >= 0.0);
        }
        if let Ok(field) = all.sokolovskii {
            prop_assert!(field.coefficient.is_finite() && field.coefficient > 0.0 && field.rupture_ratio.is_finite());
            if let Ok(bound) = all.log_spiral {
                prop_assert!(field.coefficient <= bound * (1.0 + 1e-4));
            }
        }
        if let Ok(k) = surcharge_coefficient(&face) {
            prop_assert!(k.is_finite());
        }
        let broken = Face { friction_angle: f64::NAN, ..face };
        prop_assert!(coulomb(&broken).is_err());
    }
}
