//! What the tests share: a run without contact, elliptic integrals, extremes.
#![allow(dead_code)] // each test uses a part of it
#![allow(clippy::unwrap_used)] // clippy does not recognise test helpers

use glam::DVec3;
use mechanics::{Conditions, Mechanism, MechanismState, Step};

/// Gravity [m/s²].
pub(crate) const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -9.81);

/// Takes `steps` steps of `dt` [s] without contact and shows each state to `observe`, with its time [s].
pub(crate) fn run(
    (mechanism, state): (&Mechanism, &mut MechanismState),
    gravity: DVec3,
    (dt, steps): (f64, usize),
    mut observe: impl FnMut(f64, &MechanismState, &Step),
) {
    let mut step = Step::default();
    for n in 0..steps {
        let time = n as f64 * dt;
        mechanism.predict(state, &Conditions { time, dt, gravity }, &mut step);
        mechanism.advance(state, &mut step);
        observe(time + dt, state, &step);
    }
}

/// Kinetic, potential and stored energy [J].
pub(crate) fn energy(mechanism: &Mechanism, state: &MechanismState, gravity: DVec3) -> f64 {
    mechanism.kinetic_energy(state)
        + mechanism.potential_energy(state, gravity)
        + mechanism.joint_energy(state)
}

/// Complete elliptic integral of the first kind of the modulus k, by the arithmetic–geometric mean
/// (Abramowitz & Stegun 17.6.3).
pub(crate) fn elliptic_k(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / a
}

/// Times at which a sampled signal passes zero upwards, by linear interpolation.
#[derive(Default)]
pub(crate) struct Crossings {
    last: Option<(f64, f64)>,
    pub(crate) times: Vec<f64>,
}

impl Crossings {
    pub(crate) fn add(&mut self, time: f64, value: f64) {
        if let Some((before, old)) = self.last
            && old < 0.0
            && value >= 0.0
        {
            self.times.push(before + (time - before) * old / (old - value));
        }
        self.last = Some((time, value));
    }

    /// Mean interval between crossings.
    pub(crate) fn period(&self) -> f64 {
        (self.times.last().unwrap() - self.times[0]) / (self.times.len() - 1) as f64
    }
}

/// The largest of many errors.
#[derive(Default)]
pub(crate) struct Largest(pub(crate) f64);

impl Largest {
    pub(crate) fn add(&mut self, error: f64) {
        self.0 = if error.is_nan() { f64::INFINITY } else { self.0.max(error.abs()) };
    }
}

/// Says and checks that an error stays below a limit.
pub(crate) fn below(what: &str, error: f64, limit: f64) {
    eprintln!("{what}: {error:.2e} (limit {limit:.0e})");
    assert!(error <= limit, "{what}: {error:e} exceeds {limit:e}");
}
