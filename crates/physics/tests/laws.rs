//! One battery of tests for every strength: never outside, consistent with the flow rule, objective, dissipative.

use physics::elastic::Elastic;
use physics::mohr_coulomb::MohrCoulomb;
use physics::tensor::{Spectrum, Symmetric, contract, deviator, mean, mises};

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

fn law(s: &Sample) -> MohrCoulomb {
    MohrCoulomb::new(elastic(), s.friction.to_radians(), s.dilation.to_radians(), s.cohesion, f64::INFINITY)
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
    for s in &SAMPLES {
        let law = law(s);
        for trial in stresses() {
            let back = law.return_map(trial);
            assert!(back.stress.iter().all(|x| x.is_finite()));
            let f = law.yield_function(Spectrum::of(back.stress).principal);
            assert!(f <= 1e-10 * (1e5 + mises(trial)), "{}: f = {f:e} for {trial:?}", s.name);
        }
    }
}

#[test]
fn an_elastic_state_stays_and_the_cheap_check_never_misses() {
    for s in &SAMPLES {
        let law = law(s);
        for trial in stresses() {
            let spectrum = Spectrum::of(trial);
            let apex =
                if s.friction > 0.0 { s.cohesion / s.friction.to_radians().tan() } else { f64::INFINITY };
            let inside = law.yield_function(spectrum.principal) < 0.0 && spectrum.principal[0] < apex;
            if inside {
                let back = law.return_map(trial).stress;
                let moved: f64 = (0..6).map(|n| (back[n] - trial[n]).abs()).sum();
                assert!(moved < 1e-9 * (1e5 + mises(trial)), "{}: moved {moved:e}", s.name);
            } else {
                assert!(law.may_yield(trial), "{}: missed {trial:?}", s.name);
            }
        }
    }
}

#[test]
fn a_second_return_changes_nothing() {
    for s in &SAMPLES {
        let law = law(s);
        for trial in stresses() {
            let once = law.return_map(trial).stress;
            let twice = law.return_map(once).stress;
            for n in 0..6 {
                assert!((once[n] - twice[n]).abs() < 1e-8 * (1e5 + mises(trial)), "{}: {trial:?}", s.name);
            }
        }
    }
}

#[test]
fn plastic_work_is_never_negative() {
    for s in &SAMPLES {
        let law = law(s);
        for trial in stresses() {
            let new = law.return_map(trial).stress;
            let change: Symmetric = std::array::from_fn(|n| trial[n] - new[n]);
            let work = elastic().compliance(new, change);
            assert!(work >= -1e-9 * elastic().energy(trial), "{}: {work:e}", s.name);
        }
    }
}

#[test]
fn shear_flow_dilates_as_the_dilation_angle_says() {
    // Plane return: volumetric plastic strain = 2 sin ψ · γ, σ₁ part (1 + sin ψ) γ, σ₃ part −(1 − sin ψ) γ.
    for s in &SAMPLES {
        let trial: Symmetric = [-6e4, -2.3e5, -4e5, 0.0, 0.0, 0.0];
        let new = law(s).return_map(trial).stress;
        let change: Symmetric = std::array::from_fn(|n| trial[n] - new[n]);
        let volume = mean(change) / elastic().bulk;
        let e = deviator(change).map(|x| x / (2.0 * elastic().shear));
        let strain = [e[0] + volume / 3.0, e[1] + volume / 3.0, e[2] + volume / 3.0];
        let sin = s.dilation.to_radians().sin();
        let gamma = 0.5 * (strain[0] - strain[2]);
        assert!(gamma > 0.0, "{} must yield", s.name);
        assert!((volume - 2.0 * sin * gamma).abs() < 1e-6 * gamma, "{}: {volume} {gamma}", s.name);
        assert!(strain[1].abs() < 1e-6 * gamma, "{}", s.name);
    }
}

#[test]
fn the_response_turns_with_the_axes() {
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
    for s in &SAMPLES {
        let law = law(s);
        for trial in stresses() {
            let (a, b) = (turn(law.return_map(trial).stress), law.return_map(turn(trial)).stress);
            for n in 0..6 {
                assert!((a[n] - b[n]).abs() < 1e-8 * (1e5 + mises(trial)), "{}", s.name);
            }
        }
    }
}

#[test]
fn cohesionless_soil_bears_no_tension_and_remembers_the_gap() {
    let law = law(&SAMPLES[0]);
    let back = law.return_map([1e4, 1.1e4, 0.9e4, 10.0, 0.0, 0.0]);
    assert!(contract(back.stress, back.stress) < 1e-12);
    assert!((back.gap_strain - 1e4 / elastic().bulk).abs() < 1e-12);
}
