//! Tests of every law: admissible stresses, consistent with the flow rule, objective, dissipative.

use physics::elastic::Elastic;
use physics::law::Law;
use physics::menetrey_willam::{Eccentricity, MenetreyWillam};
use physics::mohr_coulomb::MohrCoulomb;
use physics::tensor::{Spectrum, Symmetric, contract, deviator, mean, mises};
use physics::yield_law::{Point, YieldLaw};

struct Sample {
    name: &'static str,
    friction: f64,
    dilation: f64,
    cohesion: f64,
}

const SAMPLES: [Sample; 6] = [
    Sample { name: "sand, no dilation", friction: 35.0, dilation: 0.0, cohesion: 0.0 },
    Sample { name: "sand, dilating", friction: 40.0, dilation: 12.0, cohesion: 0.0 },
    Sample { name: "sand, associated", friction: 30.0, dilation: 30.0, cohesion: 0.0 },
    Sample { name: "soil with cohesion", friction: 25.0, dilation: 5.0, cohesion: 10e3 },
    Sample { name: "weak friction", friction: 2.0, dilation: 0.0, cohesion: 5e3 },
    Sample { name: "clay (Tresca)", friction: 0.0, dilation: 0.0, cohesion: 20e3 },
];

fn elastic() -> Elastic {
    Elastic::new(20e6, 0.3)
}

fn surface(s: &Sample) -> MohrCoulomb {
    MohrCoulomb::new(elastic(), s.friction.to_radians(), s.dilation.to_radians(), s.cohesion, f64::INFINITY)
}

fn smooth(s: &Sample, shape: Eccentricity) -> MenetreyWillam {
    let (friction, dilation) = (s.friction.to_radians(), s.dilation.to_radians());
    MenetreyWillam::new(elastic(), friction, dilation, s.cohesion, f64::INFINITY, shape)
}

/// Every law with this surface.
fn laws(s: &Sample) -> [Law; 3] {
    let usual = Eccentricity::usual(s.friction.to_radians());
    let circle = Eccentricity { deviatoric: 1.0, ..usual };
    [
        Law::MohrCoulomb(surface(s)),
        Law::MenetreyWillam(smooth(s, usual)),
        Law::MenetreyWillam(smooth(s, circle)),
    ]
}

/// Every soil and every law with its surface.
fn everything() -> impl Iterator<Item = (&'static Sample, Law)> {
    SAMPLES.iter().flat_map(|s| laws(s).map(|law| (s, law)))
}

fn stresses() -> Vec<Symmetric> {
    let mut seed = 11_u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut all: Vec<Symmetric> = (0..4000)
        .map(|_| {
            let p = -1e5 * (next() + 0.4);
            let mut s: Symmetric = std::array::from_fn(|_| 1e5 * next());
            s[0] += p;
            s[1] += p;
            s[2] += p;
            s
        })
        .collect();
    // States on and very near the meridians, where eigenvectors are ill defined.
    for tiny in [0.0, 1e-9, 1e-3] {
        all.push([-3e4, -3e4 + tiny, -2e5, 0.0, 0.0, 0.0]);
        all.push([-3e4, -2e5 + tiny, -2e5, 0.0, tiny, 0.0]);
        all.push([5e4, 5e4 + tiny, 5e4, 0.0, 0.0, 0.0]);
    }
    all
}

#[test]
fn never_outside_the_yield_surface() {
    for (s, law) in everything() {
        for trial in stresses() {
            let back = law.return_map(trial, &Point::default());
            assert!(back.stress.iter().all(|x| x.is_finite()), "{}: {trial:?} {back:?}", s.name);
            let f = surface(s).yield_function(Spectrum::of(back.stress).principal);
            assert!(f <= 1e-10 * (1e5 + mises(trial)), "{}: f = {f:e} for {trial:?}", s.name);
        }
    }
}

#[test]
fn single_precision_returns_the_same_stress() {
    use physics::single::law::Law as Single;
    use physics::single::yield_law::{Point as SinglePoint, YieldLaw as _};
    let most = |stress: Symmetric| stress.into_iter().fold(0.0, |most: f64, s| most.max(s.abs()));
    for (s, law) in everything() {
        let single = Single::cast(&law);
        for trial in stresses() {
            let exact = law.return_map(trial, &Point::default());
            let rounded = single.return_map(trial.map(|s| s as f32), &SinglePoint::default());
            for n in 0..6 {
                let off = (f64::from(rounded.stress[n]) - exact.stress[n]).abs() / most(trial);
                assert!(off < 1e-5, "{}: {off:e} in component {n} of {trial:?}", s.name);
            }
            let flow = f64::from(rounded.plastic_strain) - exact.plastic_strain;
            assert!(flow.abs() < 1e-5 * most(trial) / elastic().shear, "{}: {flow:e}", s.name);
        }
    }
}

#[test]
fn an_elastic_state_stays_and_the_cheap_check_never_misses() {
    for (s, law) in everything() {
        for trial in stresses() {
            let spectrum = Spectrum::of(trial);
            let apex = surface(s).apex();
            let inside = surface(s).yield_function(spectrum.principal) < 0.0 && spectrum.principal[0] < apex;
            if inside {
                let back = law.return_map(trial, &Point::default()).stress;
                let moved: f64 = (0..6).map(|n| (back[n] - trial[n]).abs()).sum();
                assert!(moved < 1e-9 * (1e5 + mises(trial)), "{}: moved {moved:e}", s.name);
            } else {
                assert!(law.may_yield(trial, &Point::default()), "{}: missed {trial:?}", s.name);
            }
        }
    }
}

#[test]
fn a_second_return_changes_nothing() {
    for (s, law) in everything() {
        for trial in stresses() {
            let once = law.return_map(trial, &Point::default()).stress;
            let twice = law.return_map(once, &Point::default()).stress;
            for n in 0..6 {
                assert!((once[n] - twice[n]).abs() < 1e-8 * (1e5 + mises(trial)), "{}: {trial:?}", s.name);
            }
        }
    }
}

#[test]
fn plastic_work_is_never_negative() {
    for (s, law) in everything() {
        // A smooth potential lies outside the hexagon's sides: with a dilation angle near φ the flow would
        // create energy.
        if matches!(law, Law::MenetreyWillam(law) if law.least_dissipation() < 0.0) {
            continue;
        }
        for far in stresses() {
            // The smooth return follows the gradients along its path, not the final one: it is accurate to
            // second order in the small steps of an explicit method. The closed form is exact for any step.
            let on = law.return_map(far, &Point::default()).stress;
            let trial = match law {
                Law::MohrCoulomb(_) | Law::VonMises(_) | Law::Sand(_) | Law::Clay(_) => far,
                Law::MenetreyWillam(_) => std::array::from_fn(|n| on[n] + 1e-3 * (far[n] - on[n])),
            };
            let new = law.return_map(trial, &Point::default()).stress;
            let change: Symmetric = std::array::from_fn(|n| trial[n] - new[n]);
            let work = elastic().compliance(new, change);
            let most = contract(new, new).sqrt() * contract(change, change).sqrt() / (2.0 * elastic().shear);
            let second_order = if matches!(law, Law::MohrCoulomb(_)) { 0.0 } else { 1e-3 * most };
            let limit = 1e-9 * elastic().energy(far) + second_order;
            assert!(work >= -limit, "{}: {work:e} of {most:e}", s.name);
        }
    }
}

#[test]
fn soil_at_its_critical_density_flows_without_dilation() {
    for s in &SAMPLES {
        let critical = Sample { name: s.name, dilation: 0.0, ..*s };
        for (law, without) in laws(s).into_iter().zip(laws(&critical)) {
            for trial in stresses() {
                let (a, b) = (
                    law.return_map(trial, &Point { is_critical: true, ..Point::default() }),
                    without.return_map(trial, &Point::default()),
                );
                assert_eq!(a, b, "{}", s.name);
            }
        }
    }
}

/// Plastic strain (deviator and volume) of the return of a trial stress: xx, yy, zz, xy, yz, xz.
fn plastic_strain(trial: Symmetric, new: Symmetric) -> (Symmetric, f64) {
    let change: Symmetric = std::array::from_fn(|n| trial[n] - new[n]);
    (deviator(change).map(|x| x / (2.0 * elastic().shear)), mean(change) / elastic().bulk)
}

#[test]
fn shear_flow_dilates_with_the_dilation_angle() {
    // Plane return: volumetric plastic strain = 2 sin ψ · γ, σ₁ part (1 + sin ψ) γ, σ₃ part −(1 − sin ψ) γ.
    for s in &SAMPLES {
        let trial: Symmetric = [-6e4, -2.3e5, -4e5, 0.0, 0.0, 0.0];
        let (e, volume) = plastic_strain(trial, surface(s).return_map(trial, &Point::default()).stress);
        let strain = [e[0] + volume / 3.0, e[1] + volume / 3.0, e[2] + volume / 3.0];
        let sin = s.dilation.to_radians().sin();
        let gamma = 0.5 * (strain[0] - strain[2]);
        assert!(gamma > 0.0, "{} must yield", s.name);
        assert!((volume - 2.0 * sin * gamma).abs() < 1e-6 * gamma, "{}: {volume} {gamma}", s.name);
        assert!(strain[1].abs() < 1e-6 * gamma, "{}", s.name);
    }
}

/// The potential of Menétrey and Willam as the Abaqus manual writes it, from invariants.
fn potential(s: &Sample, shape: Eccentricity, stress: Symmetric) -> f64 {
    let (phi, psi) = (s.friction.to_radians(), s.dilation.to_radians());
    let principal = Spectrum::of(stress).principal;
    let p = -mean(stress);
    let q = mises(stress);
    let j3: f64 = principal.iter().map(|x| x + p).product();
    let theta = (13.5 * j3 / q.powi(3)).clamp(-1.0, 1.0).acos() / 3.0;
    let e = shape.deviatoric;
    let (a, c) = (1.0 - e * e, theta.cos());
    let over = 4.0 * a * c * c + (2.0 * e - 1.0).powi(2);
    let under = 2.0 * a * c + (2.0 * e - 1.0) * (4.0 * a * c * c + 5.0 * e * e - 4.0 * e).sqrt();
    let r = over / under * (3.0 - phi.sin()) / (6.0 * phi.cos());
    ((shape.meridional * s.cohesion * psi.tan()).powi(2) + (r * q).powi(2)).sqrt() - p * psi.tan()
}

#[test]
fn the_flow_is_normal_to_the_smooth_potential() {
    for s in &SAMPLES {
        let usual = Eccentricity::usual(s.friction.to_radians());
        for shape in
            [usual, Eccentricity { deviatoric: 1.0, ..usual }, Eccentricity { meridional: 2.0, ..usual }]
        {
            let law = smooth(s, shape);
            // A trial stress slightly outside the surface: the return follows the gradient of the potential
            // there.
            for direction in [
                [1.0, 0.2, -0.7, 0.3, -0.2, 0.1],
                [0.2, 0.5, -0.3, 0.0, 0.4, 0.6],
                [0.9, -0.4, -0.6, 0.1, 0.0, 0.0],
            ] {
                let far: Symmetric =
                    std::array::from_fn(|n| 1e6 * direction[n] - if n < 3 { 1e5 } else { 0.0 });
                let on = law.return_map(far, &Point::default()).stress;
                if mises(on) < 1e3 {
                    continue;
                }
                let trial: Symmetric = std::array::from_fn(|n| on[n] + 1e-6 * mises(on) * direction[n]);
                let back = law.return_map(trial, &Point::default()).stress;
                let (e, volume) = plastic_strain(trial, back);
                let strain: Symmetric =
                    std::array::from_fn(|n| e[n] + if n < 3 { volume / 3.0 } else { 0.0 });
                let h = 1e-4 * mises(on);
                let gradient: Symmetric = std::array::from_fn(|n| {
                    let moved = |by: f64| {
                        let mut x = on;
                        x[n] += by;
                        potential(s, shape, x)
                    };
                    // A shear stress appears twice in the tensor.
                    (moved(h) - moved(-h)) / (2.0 * h) * if n < 3 { 1.0 } else { 0.5 }
                });
                let size = |a: Symmetric| contract(a, a).sqrt();
                let cosine = contract(strain, gradient) / (size(strain) * size(gradient));
                assert!(cosine > 1.0 - 1e-6, "{} {shape:?}: {cosine}", s.name);
            }
        }
    }
}

#[test]
fn with_a_circle_the_smooth_return_is_the_closed_form() {
    // e = 1, ε = 0: Θ is constant, q decreases by 3 G Δλ R, the pressure increases by K tan ψ Δλ in one step.
    for s in SAMPLES.iter().filter(|s| s.friction > 5.0) {
        let law = smooth(s, Eccentricity { meridional: 0.0, deviatoric: 1.0 });
        let (phi, psi) = (s.friction.to_radians(), s.dilation.to_radians());
        let trial: Symmetric = [-9e4, -1.3e5, -4e5, 2e4, 1e4, -3e4];
        let spectrum = Spectrum::of(trial);
        let (cos, sin) = spectrum.lode();
        let root = 0.5 * 3_f64.sqrt();
        let hexagon = (0.5 * sin + root * cos) / (3_f64.sqrt() * phi.cos())
            + (0.5 * cos - root * sin) * phi.tan() / 3.0;
        let circle = (3.0 - phi.sin()) / (6.0 * phi.cos());
        let (p, q) = (-mean(trial), mises(trial));
        let excess = hexagon * q - p * phi.tan() - s.cohesion;
        assert!(excess > 0.0, "{} must yield", s.name);
        let (shear, bulk) = (elastic().shear, elastic().bulk);
        let multiplier = excess / (3.0 * shear * hexagon * circle + bulk * phi.tan() * psi.tan());
        let back = law.return_map(trial, &Point::default()).stress;
        let off = [
            mises(back) - (q - 3.0 * shear * circle * multiplier),
            -mean(back) - (p + bulk * psi.tan() * multiplier),
        ];
        assert!(off[0].abs() < 1e-9 * q && off[1].abs() < 1e-9 * q, "{}: {off:?}", s.name);
    }
}

#[test]
fn the_response_is_objective() {
    // Rotation by 30° about z.
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let turn = |a: Symmetric| {
        let [xx, yy, zz, xy, yz, xz] = a;
        [
            cos * cos * xx + sin * sin * yy - 2.0 * sin * cos * xy,
            sin * sin * xx + cos * cos * yy + 2.0 * sin * cos * xy,
            zz,
            sin * cos * (xx - yy) + (cos * cos - sin * sin) * xy,
            sin * xz + cos * yz,
            cos * xz - sin * yz,
        ]
    };
    for (s, law) in everything() {
        for trial in stresses() {
            let a = turn(law.return_map(trial, &Point::default()).stress);
            let b = law.return_map(turn(trial), &Point::default()).stress;
            for n in 0..6 {
                assert!((a[n] - b[n]).abs() < 1e-8 * (1e5 + mises(trial)), "{}", s.name);
            }
        }
    }
}

#[test]
fn cohesionless_soil_has_no_tensile_strength_and_records_the_gap() {
    for law in laws(&SAMPLES[0]) {
        let back = law.return_map([1e4, 1.1e4, 0.9e4, 10.0, 0.0, 0.0], &Point::default());
        assert!(contract(back.stress, back.stress) < 1e-12);
        assert!((back.gap_strain - 1e4 / elastic().bulk).abs() < 1e-12);
    }
}

#[test]
fn the_most_tension_is_that_at_the_apex() {
    for s in SAMPLES.iter().filter(|s| s.friction > 0.0) {
        let apex = s.cohesion / s.friction.to_radians().tan();
        for (law, n) in laws(s).into_iter().flat_map(|law| (0..50).map(move |n| (law, f64::from(n)))) {
            let trial = [2e5 + 700.0 * n, 2.2e5 - 900.0 * n, 1.8e5 + 300.0 * n, 10.0, 0.0, 0.0];
            let back = law.return_map(trial, &Point::default());
            let principal = Spectrum::of(back.stress).principal;
            assert!(principal.iter().all(|stress| (stress - apex).abs() < 1e-6), "{}: {back:?}", s.name);
            // What is pulled beyond it opens, and dilation does not close it.
            let gap = (mean(trial) - apex) / elastic().bulk;
            assert!((back.gap_strain / gap - 1.0).abs() < 1e-9, "{} {n}: {back:?}", s.name);
        }
    }
}

#[test]
fn the_strains_of_a_return_are_those_that_the_stress_lost() {
    for (s, cutoff) in SAMPLES.iter().flat_map(|s| [(s, 1e3), (s, f64::INFINITY)]) {
        let (friction, dilation) = (s.friction.to_radians(), s.dilation.to_radians());
        let law = MohrCoulomb::new(elastic(), friction, dilation, s.cohesion, cutoff);
        for trial in stresses() {
            let back = law.return_map(trial, &Point::default());
            let (strain, volume) = plastic_strain(trial, back.stress);
            let most = 1e-10 * (1e5 + mises(trial)) / elastic().shear;
            let size = (2.0 / 3.0 * contract(strain, strain)).sqrt();
            assert!((back.plastic_strain - size).abs() < most, "{}: {trial:?}", s.name);
            // Soil opens where no stress is left to bear: all three at the cut-off.
            let least = Spectrum::of(back.stress).principal[2];
            let gap = if least > cutoff.min(law.apex()) - 1e-6 { volume } else { 0.0 };
            assert!((back.gap_strain - gap).abs() < most, "{}: {trial:?} {back:?}", s.name);
        }
    }
}

#[test]
fn flow_at_an_edge_is_a_sum_of_that_of_its_planes() {
    // Koiter (1953): between two planes at σ₁ = σ₂ the middle strain is one of extension, at σ₂ = σ₃ of
    // compression, elsewhere none; extensions and compressions are in the ratio of 1 + sin ψ to 1 − sin ψ.
    for s in &SAMPLES {
        let (law, sin) = (surface(s), s.dilation.to_radians().sin());
        for trial in stresses() {
            let [before, after] = [trial, law.return_map(trial, &Point::default()).stress].map(Spectrum::of);
            let lost: [f64; 3] = std::array::from_fn(|n| before.principal[n] - after.principal[n]);
            let (strain, volume) = plastic_strain([lost[0], lost[1], lost[2], 0.0, 0.0, 0.0], [0.0; 6]);
            let strain = [0, 1, 2].map(|n| strain[n] + volume / 3.0);
            let most = 1e-9 * (1e5 + mises(trial)) / elastic().shear;
            let extension: f64 = strain.iter().map(|e| e.max(0.0)).sum();
            let off = (1.0 - sin) * extension + (1.0 + sin) * (volume - extension);
            // At the apex there is more extension.
            if after.principal[2] > law.apex() - 1e-3 {
                assert!(off > -3.0 * most, "{}: {trial:?} {strain:?}", s.name);
                continue;
            }
            let apart = [0, 1].map(|n| after.principal[n] - after.principal[n + 1] > 1e-3);
            assert!(strain[0] > -most && strain[2] < most, "{}: {trial:?}", s.name);
            assert!(!apart[0] || strain[1] < most, "{}: {trial:?} {strain:?}", s.name);
            assert!(!apart[1] || strain[1] > -most, "{}: {trial:?} {strain:?}", s.name);
            assert!(off.abs() < 3.0 * most, "{}: {trial:?} {strain:?}", s.name);
        }
    }
}

#[test]
fn the_cheap_check_is_the_cone_that_touches_the_pyramid_and_its_cut_off() {
    let pressure = [-1e5, -1e5, -1e5, 0.0, 0.0, 0.0];
    for (s, law) in everything() {
        // Deviators of unit size at all Lode angles, and how far each reaches.
        let reach = |degrees: i32| {
            let (sin, cos) = (0.1 * f64::from(degrees)).to_radians().sin_cos();
            let (a, b) = (cos / 6_f64.sqrt(), sin / 2_f64.sqrt());
            let unit = [2.0 * a, b - a, -b - a];
            let at = |size: f64| surface(s).yield_function(unit.map(|u| size * u - 1e5));
            (at(0.0) / (at(0.0) - at(1.0)), unit)
        };
        // Principal values are in order from 0 to 60°.
        let (least, unit) = (0..=600).map(reach).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        for (part, yields) in [(0.999, false), (1.001, true)] {
            let stress =
                std::array::from_fn(|n| pressure[n] + if n < 3 { part * least * unit[n] } else { 0.0 });
            assert_eq!(law.may_yield(stress, &Point::default()), yields, "{} {part}", s.name);
        }
    }
    let cut = MohrCoulomb::new(elastic(), 0.5, 0.0, 1e5, 1e4);
    for (part, yields) in [(0.999, false), (1.001, true)] {
        assert_eq!(cut.may_yield([part * 1e4, -2e4, -2e4, 0.0, 0.0, 0.0], &Point::default()), yields);
        assert_eq!(
            cut.may_yield([part * 1e4, part * 1e4, part * 1e4, 0.0, 0.0, 0.0], &Point::default()),
            yields
        );
    }
}

#[test]
fn dissipation_is_least_where_the_circle_is_farthest_outside_the_hexagon() {
    // Half way along a side of Tresca's hexagon, where its radius is √3/2 of that of the circle.
    for s in &SAMPLES {
        let (phi, psi) = (s.friction.to_radians(), s.dilation.to_radians());
        let law = smooth(s, Eccentricity { meridional: 0.1, deviatoric: 1.0 });
        let ratio = if s.friction > 0.0 { psi.tan() / phi.tan() } else { 0.0 };
        let exact = (3.0 - phi.sin()) / (2.0 * (3.0 + phi.sin().powi(2)).sqrt()) - ratio;
        assert!((law.least_dissipation() - exact).abs() < 1e-4, "{}: {exact}", s.name);
    }
    let usual = Eccentricity::usual(30_f64.to_radians());
    assert!(usual.meridional == 0.1 && (usual.deviatoric - 5.0 / 7.0).abs() < 1e-15);
}

#[test]
fn only_soil_without_friction_has_an_undrained_strength() {
    assert_eq!(MohrCoulomb::tresca(elastic(), 2e4).undrained_strength(), Some(2e4));
    assert_eq!(surface(&SAMPLES[3]).undrained_strength(), None);
}
