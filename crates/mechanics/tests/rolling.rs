//! A sphere on an inclined plane, with frictional contact at one point through the interface that contact
//! uses.
//!
//! It rolls at a = 5/7 g sin θ while tan θ < 7/2 μ, and otherwise slides at a = g (sin θ − μ cos θ), its spin
//! growing at 5/2 μ g cos θ / r (Routh, Dynamics of a System of Rigid Bodies, 1905).
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{GRAVITY, Largest, below};
use glam::DVec3;
use mechanics::{Body, Conditions, Inertia, Mechanism, Pose, Step, Twist};

const RADIUS: f64 = 0.2;
const MASS: f64 = 3.0;
const SLOPE: f64 = 0.4;

/// Contact with a plane by projected Gauss–Seidel: no approach beyond the gap, and Coulomb friction.
fn contact(step: &mut Step, normal: DVec3, gap: f64, friction: f64) {
    let arm = -RADIUS * normal;
    let mass = 1.0 / step.inverse_mass_along(0, arm, normal);
    let tangential_mass = 1.0 / step.inverse_mass(0, arm).to_cols_array().into_iter().fold(0.0, f64::max);
    let mut total = DVec3::ZERO;
    for _ in 0..60 {
        let velocity = step.velocity_at(0, arm);
        let closing = velocity.dot(normal);
        let old = total.dot(normal);
        let pressed = (old - (closing + gap / step.dt()) * mass).max(0.0);
        let sliding = velocity - closing * normal;
        let rubbed = (total - old * normal - tangential_mass * sliding).clamp_length_max(friction * pressed);
        let new = pressed * normal + rubbed;
        step.apply(0, arm, new - total);
        total = new;
    }
}

/// Acceleration along the slope, spin-up [1/s²] and the error of the energy over the work of gravity.
fn descend(friction: f64, centre: f64) -> (f64, f64, f64) {
    let normal = DVec3::new(SLOPE.sin(), 0.0, SLOPE.cos());
    let down = DVec3::new(SLOPE.cos(), 0.0, -SLOPE.sin());
    let inertia = Inertia::sphere(MASS, RADIUS).with_centre(centre * DVec3::Y);
    let mechanism = Mechanism::new(vec![Body::free(inertia)], vec![]).unwrap();
    let mut state = mechanism.state(&[(Pose::at(RADIUS * normal), Twist::ZERO)]);
    let (mut step, mut works, mut error) = (Step::default(), 0.0, Largest::default());
    let (dt, steps) = (1e-3, 2000);
    let mut first = Twist::ZERO;
    for n in 0..steps {
        let conditions = Conditions { time: n as f64 * dt, dt, gravity: GRAVITY };
        mechanism.predict(&state, &conditions, &mut step);
        let gap = state.bodies[0].pose.position.dot(normal) - RADIUS;
        contact(&mut step, normal, gap, friction);
        mechanism.advance(&mut state, &mut step);
        works += step.work(0).total();
        error.add((mechanism.kinetic_energy(&state) - works) / works.abs().max(1.0));
        if n == 0 {
            first = state.bodies[0].twist;
        }
    }
    let gained = state.bodies[0].twist - first;
    let time = (steps - 1) as f64 * dt;
    (gained.linear.dot(down) / time, gained.angular.dot(normal.cross(down)) / time, error.0)
}

#[test]
fn it_rolls_or_slides() {
    let limit = 2.0 / 7.0 * SLOPE.tan();
    for friction in [1.05 * limit, 1e3] {
        let (acceleration, spin_up, energy) = descend(friction, 0.0);
        let exact = 5.0 / 7.0 * 9.81 * SLOPE.sin();
        below("rolling: acceleration", (acceleration / exact - 1.0).abs(), 1e-9);
        below("rolling: spin", (spin_up * RADIUS / exact - 1.0).abs(), 1e-9);
        below("rolling: energy balance", energy, 1e-11);
    }
    for friction in [0.95 * limit, 0.3 * limit, 0.0] {
        let (acceleration, spin_up, energy) = descend(friction, 0.0);
        let exact = 9.81 * (SLOPE.sin() - friction * SLOPE.cos());
        below("sliding: acceleration", (acceleration / exact - 1.0).abs(), 1e-9);
        let exact = 2.5 * friction * 9.81 * SLOPE.cos() / RADIUS;
        below("sliding: spin", (spin_up - exact).abs() / 9.81, 1e-9);
        below("sliding: energy balance", energy, 1e-11);
    }
}
